#include "widgets/surface/surface_outcome.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "engine/core/json.h"
#include "engine/core/texts.h"
#include "engine/stability/lobes.h"
#include "engine/surface/picture_comparison.h"
#include "engine/surface/surface_codes.h"
#include "engine/surface/surface_plots.h"
#include "widgets/chatter_common/input_value.h"
#include "engine/task/memo.h"
#include "widgets/surface/image_store.h"
#include "widgets/surface/next_speed.h"

namespace lathelier::surface_panel {
namespace {

constexpr int modelPoints = 400;
constexpr double modelFrom = 0.7, modelTo = 1.4;  // of the speed of the cut

/// Pictures that were made, by their parameters: one that is looked at anew is not made again.
struct MadePictures : Memo<io::Image> {};

QImage imageOf(const surface::GridView& grid, double low, double high)
{
    QImage image(grid.columns, grid.rows, QImage::Format_Grayscale8);
    for (int y = 0; y < grid.rows; ++y) {
        uchar* line = image.scanLine(y);
        const float* row = grid.row(y);
        for (int x = 0; x < grid.columns; ++x) line[x] = surface::levelOf(row[x], low, high);
    }
    return image;
}

QImage imageOf(const io::Image& image)
{
    return imageOf(surface::GridView(image.grey.data(), image.width, image.height, image.width), 0, 1);
}

std::string nameOfPicture(const std::string& path)
{
    return std::filesystem::path(path).filename().string();
}

void addStripes(ShownImage& shown, const surface::SurfaceView& view)
{
    const auto of = [&](const std::optional<surface::Vector>& wave) {
        return wave ? surface::stripesOf(*wave, phaseOf(view.flat, *wave), view.flat.columns, view.flat.rows)
                    : std::vector<surface::Stripe>();
    };
    shown.feed_stripes = of(view.feed);
    shown.chatter_bands = of(view.bands);
}

std::vector<surface::NamedImage> readImages(const project::PanelState& state, SurfaceOutcome& outcome, Stores& stores,
                                            const Progress& progress)
{
    std::vector<surface::NamedImage> images;
    for (const char* role : {beforeRole, afterRole}) {
        const project::Source* const source = task::sourceOf(state, role);
        if (!source) continue;
        const auto loaded = stores.of<ImageStore>()->load(*source, progress);
        images.emplace_back(source->path, std::shared_ptr<const io::Image>(loaded, &loaded->file));
        outcome.inputs.push_back(loaded->inputs.front());
        outcome.notes.insert(outcome.notes.end(), loaded->file.notes.begin(), loaded->file.notes.end());
        outcome.synthetic |= source->synthetic;
    }
    return images;
}

surface::NamedImage makeImage(SurfaceOutcome& outcome, Stores& stores, const Progress& progress)
{
    const surface::SyntheticParameters asked = pictureOf(outcome.question);
    const std::string key = toJson(toValues(asked)).dump();
    const auto made = stores.of<MadePictures>()->find(
        key, progress, [&](const Progress& part) { return surface::syntheticPicture(asked, part); });
    outcome.made_png = surface::syntheticPng(*made);
    outcome.synthetic = true;
    return {"SYNTHETIC", made};
}

void askModel(const project::PanelState& state, SurfaceOutcome& outcome, Stores& stores, const Progress& progress)
{
    auto response = chatter_common::takeResponse(state, stores, progress.part(0, 0.3));
    if (!response) return;
    const Frf frf = chatter_common::recordInput(outcome, std::move(response->taken));
    if (!outcome.marks) return;
    stability::LobeParameters parameters;
    parameters.speed_rpm = {{modelFrom * outcome.marks->speed_rpm, modelTo * outcome.marks->speed_rpm}};
    parameters.points = modelPoints;
    outcome.model = std::make_shared<const stability::LobeResult>(findLobes(frf, parameters, progress.part(0.3, 1)));
    outcome.check = checkModel(*outcome.marks, *outcome.model);
    if (outcome.check && outcome.check->agrees) outcome.next = nextSpeed(frf, *outcome.marks, *outcome.check);
}

/// A response that is refused leaves the marks as they are.
void compareWithModel(const project::PanelState& state, SurfaceOutcome& outcome, Stores& stores,
                      const Progress& progress)
{
    try {
        askModel(state, outcome, stores, progress);
    } catch (const Error& error) {
        outcome.notes.push_back({notes::modelNotUsed, {{"reason", text(error)}}});
    }
}

void prepare(SurfaceOutcome& outcome, const Progress& progress)
{
    const surface::SurfaceResult& result = *outcome.result;
    for (std::size_t i = 0; i < result.images.size(); ++i) {
        const surface::SurfaceView& view = result.images[i].view;
        ShownImage& shown = outcome.shown[i];
        shown.evaluated = imageOf(view.picture, 0, 1);
        shown.flat = imageOf(view.flat, -surface::flatRange, surface::flatRange);
        addStripes(shown, view);
        progress.report(static_cast<double>(i + 1) / 3);
    }
    if (result.images.size() > 1) {
        surface::Vector shift = result.comparison ? result.comparison->shift : surface::Vector{};
        if (outcome.isLaid())
            shift = {outcome.question.lay_right_px.value_or(0), outcome.question.lay_down_px.value_or(0)};
        const surface::AlignedPictures both = surface::aligned(result.images, shift);
        outcome.laid = shift;
        outcome.before = imageOf(both.pictures[0], -surface::flatRange, surface::flatRange);
        outcome.after = imageOf(both.pictures[1], -surface::flatRange, surface::flatRange);
        outcome.common_mm_per_px = both.mm_per_px;
    }
    const surface::ImageMarks& first = result.images.front();
    if (first.chatter_marks && first.chatter_marks->frequency_hz && first.speed_rpm)
        outcome.marks = stability::SurfaceMarks{
            outcome.shown.front().name, *first.speed_rpm, *first.chatter_marks->frequency_hz,
            first.chatter_marks->frequency_uncertainty_hz.value_or(0), first.chatter_marks->nearest_other_hz};
    progress.report(1);
}

}  // namespace

SurfaceOutcome surfaceOutcome(const project::PanelState& state, Stores& stores, const Progress& progress)
{
    SurfaceOutcome outcome;
    outcome.question = fromValues<SurfaceQuestion>(state.parameters);
    std::vector<surface::NamedImage> images;
    if (outcome.question.make_picture)
        images.push_back(makeImage(outcome, stores, progress.part(0, 0.4, LT_TEXT("Engine", "Making the picture"))));
    else
        images = readImages(state, outcome, stores, progress.part(0, 0.2, LT_TEXT("Engine", "Reading")));
    for (const surface::NamedImage& image : images)
        outcome.shown.push_back({nameOfPicture(image.path), imageOf(*image.image), {}, {}, {}, {}});
    if (images.size() > 1) applyOwnScale(images[1], outcome.question);
    try {
        outcome.result = std::make_shared<const surface::SurfaceResult>(
            findSurfaceMarks(images, parametersOf(outcome.question, images.size()),
                             progress.part(0.4, 0.85, LT_TEXT("Engine", "Evaluating"))));
    } catch (const Error& error) {
        outcome.refused = error;  // the pictures are shown: there the scale and the region can be mended
        return outcome;
    }
    const Notes& notes = outcome.result->notes;
    outcome.notes.insert(outcome.notes.end(), notes.begin(), notes.end());
    prepare(outcome, progress.part(0.85, 0.9));
    compareWithModel(state, outcome, stores, progress.part(0.9, 1, LT_TEXT("Engine", "Finding lobes")));
    return outcome;
}

}  // namespace lathelier::surface_panel
