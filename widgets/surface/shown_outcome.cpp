#include "widgets/surface/shown_outcome.h"

#include "engine/surface/picture_comparison.h"
#include "engine/surface/surface_plots.h"

namespace lathelier::surface_panel {
namespace {

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

void addStripes(ShownImage& shown, const surface::SurfaceView& view)
{
    const auto of = [&](const std::optional<surface::Vector>& wave) {
        return wave ? surface::stripesOf(*wave, phaseOf(view.flat, *wave), view.flat.columns, view.flat.rows)
                    : std::vector<surface::Stripe>();
    };
    shown.feed_stripes = of(view.feed);
    shown.chatter_bands = of(view.bands);
}

void prepare(ShownOutcome& outcome, const Progress& progress)
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
    progress.report(1);
}

}  // namespace

ShownOutcome answerAndPrepare(const project::PanelState& state, Stores& stores, task::Sources& sources,
                              const Progress& progress)
{
    ShownOutcome outcome{surface::answerSurface(state, stores, sources, progress.part(0, 0.9)), {}, {}, {}, 0, {}};
    if (!outcome.unread.empty()) throw Error(outcome.unread.front());
    for (std::size_t i = 0; i < outcome.images.size(); ++i)
        outcome.shown.push_back({outcome.names[i], imageOf(*outcome.images[i].image), {}, {}, {}, {}});
    if (outcome.result) prepare(outcome, progress.part(0.9, 1));
    return outcome;
}

}  // namespace lathelier::surface_panel
