#include "widgets/frf/frf_outcome.h"

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "engine/core/core_codes.h"
#include "engine/core/json.h"
#include "engine/io/frf/frf_choice.h"
#include "engine/io/frf/frf_lines.h"
#include "engine/io/io_codes.h"
#include "engine/receptance/frf_checks.h"
#include "engine/receptance/modal/modal_quantities.h"
#include "engine/receptance/modal/modal_report.h"
#include "engine/report/parameters_table.h"
#include "engine/report/result_json.h"
#include "engine/task/memo.h"

namespace lathelier::frf_panel {
namespace {

constexpr double mostLines = 4000;  ///< largest number of lines of the computed response

/// Cache of fits by response and parameters: dragging a peak does not refit.
struct FitMemo : Memo<receptance::ModalFit> {};
/// Cache of computed responses.
struct ComputedMemo : Memo<receptance::ShaftReceptanceResult> {};

void append(Notes& all, const Notes& more)
{
    for (const Note& note : more) all.push_back(note);
}

/// Returns the cache key of the response; empty without one.
std::string takeMeasured(FrfOutcome& outcome, const project::PanelState& state, Stores& stores,
                         const Progress& progress)
{
    const project::Source* const found = task::sourceOf(state, frfRole);
    if (!found) return {};
    const project::Source& source = *found;
    if (const auto item = chatter_common::takeResponseItem(state)) {
        outcome.study.measured = std::make_shared<const Frf>(chatter_common::recordInput(outcome, *item));
        outcome.name = source.item;
        return item->input.sha256;
    }
    const auto loaded = stores.of<FrfStore>()->load(source, progress);
    const io::MeasuredFrf& chosen = io::chosenResponse(loaded->file.frfs, outcome.question.response);
    outcome.inputs.push_back(loaded->inputs.front());
    append(outcome.notes, loaded->file.notes);
    append(outcome.notes, receptance::checkResponse(chosen, source.path));
    outcome.study.measured = std::make_shared<const Frf>(io::toReceptance(chosen.frf));
    outcome.places = chosen;
    outcome.places.frf = {};
    outcome.name = std::filesystem::path(source.path).filename().string();
    if (const std::string pair = io::nodePair(chosen); loaded->file.frfs.size() > 1)
        outcome.name += " " + (pair.empty() ? outcome.question.response : pair);
    outcome.synthetic |= source.synthetic || contains(loaded->file.notes, notes::syntheticData);
    const auto number = &chosen - loaded->file.frfs.data();
    return loaded->digest() + toJson(source.import).dump() + "#" + std::to_string(number);
}

/// Error valueNotUnderstood for a mode without stiffness.
void requireStiffness(const std::vector<receptance::ModalMode>& modes)
{
    for (const receptance::ModalMode& mode : modes)
        if (mode.stiffness_N_mm == 0)
            throw Error(
                errors::valueNotUnderstood,
                {{"parameter", "modes"}, {"found", 0.0}, {"expected", LT_TEXT("Engine", "a stiffness, not 0")}});
}

/// Whether the parameter concerns the computed response of the shaft.
bool isOfComputing(const std::string& key)
{
    const auto all = infos<receptance::ReceptanceParameters>();
    return std::any_of(all.begin(), all.end(), [&](const FieldInfo& info) { return info.key == key; });
}

/// The lines of the measured response, evenly spaced; else those of the range asked for. A spindle's table rules over
/// their range.
void chooseLines(receptance::ReceptanceParameters& computing, const FrfOutcome& outcome,
                 const std::optional<receptance::SpindleReceptance>& machine)
{
    if (outcome.study.measured && outcome.study.measured->frequency_hz.size() > 1) {
        const std::vector<double>& lines = outcome.study.measured->frequency_hz;
        const double steps = std::min(mostLines, static_cast<double>(lines.size()) - 1);
        computing.step_hz = (lines.back() - lines.front()) / steps;
        computing = receptance::withinLines(computing, machine,
                                            {lines.front() > 0 ? lines.front() : computing.step_hz, lines.back()});
    } else if (!outcome.question.modal.range_hz.empty()) {
        const Interval& range = outcome.question.modal.range_hz.front();
        computing.step_hz = std::max(1e-3, (range.to - range.from) / mostLines * 2);
        computing = receptance::withinLines(computing, machine, {std::max(range.from, computing.step_hz), range.to});
    }
}

std::string takeComputed(FrfOutcome& outcome, const project::PanelState& state, Stores& stores,
                         const Progress& progress)
{
    const auto shaft = chatter_common::takeShaft(state, stores, progress.part(0, 0.1));
    if (!shaft) return {};
    const Shaft held = chatter_common::recordInput(outcome, *shaft);
    const auto spindle = chatter_common::takeSpindle(state, stores, progress.part(0.1, 0.2));
    std::optional<receptance::SpindleReceptance> machine;
    if (spindle) machine = chatter_common::recordInput(outcome, *spindle);
    receptance::ReceptanceParameters computing = outcome.question.computing;
    chooseLines(computing, outcome, machine);
    std::string key = shaft->input.sha256 + (spindle ? spindle->input.sha256 : "") + toJson(toValues(computing)).dump();
    const auto found = stores.of<ComputedMemo>()->find(key, progress.part(0.2, 1), [&](const Progress& part) {
        return receptance::shaftReceptance(held, computing, machine, part);
    });
    append(outcome.notes, found->notes);
    Frf frf = found->frf;
    io::dropUnusableLines(frf);  // removes 0 Hz, where a free shaft has no receptance
    outcome.study.computed = std::make_shared<const Frf>(std::move(frf));
    if (outcome.name.empty()) outcome.name = held.name.empty() ? shaft->input.path : held.name;
    return key;
}

}  // namespace

FrfPtr FrfOutcome::handedOn() const
{
    if (question.handed_on == HandedOn::Measured) return study.measured ? study.measured : study.computed;
    if (study.synthesised.value.empty()) return nullptr;
    return std::make_shared<const Frf>(study.synthesised);
}

FrfOutcome frfOutcome(const project::PanelState& state, Stores& stores, const Progress& progress)
{
    FrfOutcome outcome;
    outcome.question = fromValues<FrfQuestion>(state.parameters);
    const FrfQuestion& question = outcome.question;
    requireStiffness(question.modes);
    std::string basis = takeMeasured(outcome, state, stores, progress.part(0, 0.3, LT_TEXT("Engine", "Reading")));
    const std::string computed =
        takeComputed(outcome, state, stores, progress.part(0.3, 0.5, LT_TEXT("Engine", "Computing")));
    if (basis.empty()) basis = computed;
    std::shared_ptr<const receptance::ModalFit> fit;
    if (question.fit && outcome.study.basis()) {
        const Frf& response = *outcome.study.basis();
        fit = stores.of<FitMemo>()->find(
            basis + toJson(toValues(question.modal)).dump(), progress.part(0.5, 1, LT_TEXT("Engine", "Fitting modes")),
            [&](const Progress& fitting) { return receptance::fitModes(response, question.modal, fitting); });
        append(outcome.notes, fit->notes);
    }
    outcome.study = receptance::studyResponse(outcome.study.measured, outcome.study.computed, fit, question.modes);
    return outcome;
}

report::Document reportOf(const FrfOutcome& outcome, const Language& language)
{
    report::Document document = receptance::responseReport(outcome.study, outcome.notes, language);
    if (outcome.study.computed) {
        std::vector<FieldInfo> infos;
        for (const FieldInfo& info : lathelier::infos<FrfQuestion>())
            if (isOfComputing(info.key)) infos.push_back(info);
        report::QuantityTable table = report::parametersTable(infos, toValues(outcome.question), language);
        table.title = LT_TEXT("Engine", "Computed response");
        document.sections.back().blocks.emplace_back(std::move(table));
    }
    document.inputs = outcome.inputs;
    document.synthetic = outcome.synthetic;
    document.results = {report::toText(report::wholeResult("frf_modes", outcome.inputs, toValues(outcome.question),
                                                           toJson(outcome.study), outcome.notes))};
    return document;
}

}  // namespace lathelier::frf_panel
