#include "engine/surface/task/surface_task.h"

#include <filesystem>
#include <nlohmann/json.hpp>

#include "engine/core/json.h"
#include "engine/core/texts.h"
#include "engine/io/frf/frf_input.h"
#include "engine/io/image/image_input.h"
#include "engine/stability/lobes.h"
#include "engine/stability/task/point_response.h"
#include "engine/surface/surface_codes.h"
#include "engine/surface/surface_quantities.h"
#include "engine/surface/surface_report.h"
#include "engine/surface/task/next_speed.h"
#include "engine/surface/task/surface_answer.h"
#include "engine/task/memo.h"

namespace lathelier::surface {
namespace {

constexpr int modelPoints = 400;
constexpr double modelFrom = 0.7, modelTo = 1.4;  // of the speed of the cut

/// Pictures that were made, by their parameters; pictures that were evaluated, by their content and the parameters.
struct MadePictures : Memo<io::Image> {};
struct EvaluatedPictures : Memo<SurfaceResult> {
    EvaluatedPictures() : Memo(2) {}
};

/// Those that cannot be read are reported together.
void readImages(const project::PanelState& state, SurfaceOutcome& outcome, std::string& key, Stores& stores,
                task::Sources& sources, const Progress& progress)
{
    std::vector<std::string> roles = project::keysOf(state, beforeRole);
    if (task::sourceOf(state, afterRole)) roles.push_back(afterRole);
    const double share = 1.0 / static_cast<double>(roles.size());
    for (std::size_t i = 0; i < roles.size(); ++i) {
        const double done = static_cast<double>(i) * share;
        try {
            const auto loaded =
                task::takeFile<io::ImageInput>(state, roles[i], stores, progress.part(done, done + share), sources);
            const std::string& path = state.inputs.at(roles[i]).path;
            outcome.images.emplace_back(path, std::shared_ptr<const io::Image>(loaded, &loaded->file));
            outcome.names.push_back(std::filesystem::path(path).filename().string());
            key += loaded->digest() + path + '\n';
        } catch (const Error& error) {
            outcome.unread.push_back(error);
        }
    }
}

void makeImage(SurfaceOutcome& outcome, std::string& key, Stores& stores, task::Sources& sources,
               const Progress& progress)
{
    const SyntheticParameters asked = pictureOf(outcome.question);
    key = toJson(toValues(asked)).dump();
    const auto made = stores.of<MadePictures>()->find(
        key, progress, [&](const Progress& part) { return syntheticPicture(asked, part); });
    outcome.made_png = syntheticPng(*made);
    outcome.images.emplace_back("SYNTHETIC", made);
    outcome.names = {"SYNTHETIC"};
    sources.synthetic = true;
}

void evaluate(SurfaceOutcome& outcome, std::string key, Stores& stores, const Progress& progress)
{
    if (outcome.images.size() > 1) applyOwnScale(outcome.images[1], outcome.question);
    const SurfaceParameters parameters = parametersOf(outcome.question, outcome.images.size());
    key += toJson(toValues(parameters)).dump();
    for (const NamedImage& image : outcome.images)
        key += number(image.mm_per_px).dump() + number(image.feed_direction_deg).dump();
    try {
        outcome.result = stores.of<EvaluatedPictures>()->find(
            key, progress, [&](const Progress& part) { return findSurfaceMarks(outcome.images, parameters, part); });
    } catch (const Error& error) {
        outcome.refused = error;  // the pictures are shown: there the scale and the region can be mended
        return;
    }
    const ImageMarks& first = outcome.first();
    if (first.chatter_marks && first.chatter_marks->frequency_hz && first.speed_rpm)
        outcome.marks = stability::SurfaceMarks{
            outcome.names.front(), *first.speed_rpm, *first.chatter_marks->frequency_hz,
            first.chatter_marks->frequency_uncertainty_hz.value_or(0), first.chatter_marks->nearest_other_hz};
}

void askModel(const project::PanelState& state, SurfaceOutcome& outcome, Stores& stores, task::Sources& sources,
              const Progress& progress)
{
    if (!task::sourceOf(state, stability::frfRole)) return;
    const stability::PointResponse response =
        stability::takeResponse(state, {}, 0, std::nullopt, stores, sources, progress.part(0, 0.3));
    if (!outcome.marks) return;
    stability::LobeParameters parameters;
    parameters.speed_rpm = {{modelFrom * outcome.marks->speed_rpm, modelTo * outcome.marks->speed_rpm}};
    parameters.points = modelPoints;
    outcome.model =
        std::make_shared<const stability::LobeResult>(findLobes(*response.frf, parameters, progress.part(0.3, 1)));
    outcome.check = checkModel(*outcome.marks, *outcome.model);
    if (outcome.check && outcome.check->agrees) outcome.next = nextSpeed(*response.frf, *outcome.marks, *outcome.check);
}

/// A response that is refused leaves the marks as they are.
void compareWithModel(const project::PanelState& state, SurfaceOutcome& outcome, Stores& stores, task::Sources& sources,
                      Notes& notes, const Progress& progress)
{
    try {
        askModel(state, outcome, stores, sources, progress);
    } catch (const Error& error) {
        notes.push_back({notes::modelNotUsed, {{"reason", text(error)}}});
    }
}

std::vector<task::Product> productsOf(const SurfaceOutcome& outcome, const Language& language)
{
    const std::string name =
        fill(text(LT_TEXT("Engine", "Marks of {picture}"), language), {{"picture", outcome.marks->picture}});
    return {{stability::marksItem, {}, name, [marks = *outcome.marks] { return toValues(marks); }}};
}

std::vector<task::Input> surfaceInputs()
{
    std::vector<task::Input> all;
    all.push_back(task::input<io::ImageInput>(
        beforeRole, "", LT_TEXT("Engine", "Picture (before)"),
        LT_TEXT("Engine", "A photograph (PNG, JPEG, TIFF); several are compared, the first being before.")));
    all.back().operand = "IMAGE";
    all.back().several = true;
    all.back().is_of_part = true;
    all.push_back(task::optionalInput<io::ImageInput>(
        afterRole, "", LT_TEXT("Engine", "Picture after"),
        LT_TEXT("Engine", "The same surface after the speed was corrected, taken alike. It may be missing.")));
    all.back().is_of_part = true;
    all.push_back(task::optionalInput<io::FrfInput>(
        stability::frfRole, "", LT_TEXT("Engine", "Frequency response"),
        LT_TEXT("Engine", "A model to compare the marks with: UFF, CSV or MAT. It may be missing.")));
    for (std::size_t i = 1; i < all.size(); ++i) all[i].in_window_only = true;
    return all;
}

}  // namespace

SurfaceOutcome answerSurface(const project::PanelState& state, Stores& stores, task::Sources& sources,
                             const Progress& progress)
{
    SurfaceOutcome outcome;
    outcome.question = fromValues<SurfaceQuestion>(state.parameters);
    std::string key;
    if (outcome.question.make_picture)
        makeImage(outcome, key, stores, sources, progress.part(0, 0.4, LT_TEXT("Engine", "Making the picture")));
    else
        readImages(state, outcome, key, stores, sources, progress.part(0, 0.2, LT_TEXT("Engine", "Reading")));
    outcome.stated = state;
    outcome.stated.parameters = statedValues(outcome.question, outcome.images.size(), state.parameters);
    Notes notes;
    if (outcome.unread.empty())
        evaluate(outcome, key, stores, progress.part(0.4, 0.9, LT_TEXT("Engine", "Evaluating")));
    if (outcome.result) {
        notes = outcome.result->notes;
        compareWithModel(state, outcome, stores, sources, notes,
                         progress.part(0.9, 1, LT_TEXT("Engine", "Finding lobes")));
    }
    outcome.record(state, sources, notes);
    progress.report(1);
    return outcome;
}

task::Outcome outcomeOf(const std::shared_ptr<const SurfaceOutcome>& outcome)
{
    task::Outcome all;
    all.result = outcome;
    all.notes = outcome->asks() ? Notes{} : outcome->notes;
    all.stated = outcome->stated;
    all.errors = outcome->unread;
    if (outcome->refused) all.errors.push_back(*outcome->refused);
    if (outcome->result) {
        all.answer = [outcome](const Language& language) { return answer(*outcome, language); };
        all.report = [outcome](const Language& language) { return reportOf(*outcome, language); };
    }
    if (outcome->result && !outcome->asks()) {
        all.json = [outcome] { return toJson(*outcome->result); };
        all.summary = [outcome](const Language& language) { return surfaceSummary(*outcome->result, language); };
        if (outcome->marks)
            all.products = [outcome](const Language& language) { return productsOf(*outcome, language); };
    }
    return settled(surfaceTask(), std::move(all), outcome->understanding);
}

const task::Task& surfaceTask()
{
    static const task::Task task = [] {
        task::Task made;
        made.key = "surface";
        made.title = LT_TEXT("Engine", "Surface");
        made.summary = "Photographs of turned surfaces: feed marks, chatter marks and their frequency.";
        made.question = "photographs";
        made.products = {stability::marksItem};
        made.inputs = surfaceInputs();
        task::askFor<SurfaceQuestion>(made);
        made.run = [](const project::PanelState& state, const task::Wanted&, Stores& stores, task::Sources& sources,
                      const Progress& progress) {
            return outcomeOf(std::make_shared<const SurfaceOutcome>(answerSurface(state, stores, sources, progress)));
        };
        return made;
    }();
    return task;
}

}  // namespace lathelier::surface
