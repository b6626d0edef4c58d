#include "widgets/spindle_machine/machine_outcome.h"

#include <nlohmann/json.hpp>

#include "engine/io/io_codes.h"
#include "engine/receptance/receptance_codes.h"
#include "engine/receptance/receptance_quantities.h"
#include "engine/receptance/receptance_report.h"
#include "engine/receptance/spindle_file.h"
#include "engine/receptance/spindle_plots.h"
#include "engine/report/parameters_table.h"
#include "engine/report/result_json.h"
#include "widgets/chatter_common/shaft_files.h"
#include "engine/task/memo.h"

namespace lathelier::machine_panel {
namespace {

constexpr double nanometres = 1e6;  ///< per mm

struct Identified {
    receptance::SpindleIdentification spindle;
    receptance::SpindleCheck check;
};

/// By measurements and parameters: another limit computes nothing anew.
struct IdentifiedMemo : Memo<Identified> {};

void identify(MachineOutcome& outcome, const project::PanelState& state, Stores& stores, const Progress& progress)
{
    const project::Source& source = state.inputs.at(measurementsRole);
    const auto loaded =
        stores.of<MeasurementStore>()->load(source, progress.part(0, 0.1, LT_TEXT("Engine", "Reading")));
    outcome.inputs = loaded->inputs;
    outcome.notes = loaded->file.notes;
    outcome.synthetic = source.synthetic || contains(loaded->file.notes, notes::syntheticData);
    const receptance::SpindleMeasurements& measured = loaded->file.measurements;
    const auto& asked = outcome.question.identification;
    const auto found = stores.of<IdentifiedMemo>()->find(
        loaded->digest() + toJson(source.import).dump() + toJson(toValues(asked)).dump(),
        progress.part(0.1, 1, LT_TEXT("Engine", "Identifying")), [&](const Progress& identifying) {
            Identified result{identifySpindle(measured, asked, identifying.part(0, 0.9)), {}};
            result.check = checkSpindle(measured, result.spindle, identifying.part(0.9, 1));
            return result;
        });
    outcome.identified = {found, &found->spindle};
    outcome.check = {found, &found->check};
    outcome.spindle = outcome.identified->spindle;
    outcome.used = outcome.identified->used;
    const Notes& remarks = outcome.identified->notes;
    outcome.notes.insert(outcome.notes.end(), remarks.begin(), remarks.end());
}

void takeSprings(MachineOutcome& outcome)
{
    receptance::SpindleSprings springs = outcome.question.springs;
    ValueOrigin origin = ValueOrigin::Given;
    if (const auto* entry = entryOf(receptance::machines(), outcome.question.source)) {
        springs = entry->value;
        origin = ValueOrigin::Assumed;
        outcome.notes.push_back({notes::machineOfLibrary, {{"source", entry->source}}});
    }
    for (const auto& field : fields<receptance::SpindleSprings>())
        addUsed(outcome.used, field.info, field.get(springs), origin);
    outcome.spindle.source = springs;
}

Json resultOf(const MachineOutcome& outcome)
{
    if (!outcome.identified) return Json::parse(receptance::spindleText(outcome.spindle));
    Json json = nestedJson(describedValues(*outcome.identified));
    json["residual_percent"] = outcome.check->residual_percent;
    return json;
}

report::Document springsReport(const MachineOutcome& outcome, const Language& language)
{
    report::Document document;
    document.title = LT_TEXT("Engine", "Receptance of a spindle");
    document.sections.push_back({LT_TEXT("Engine", "Result"), {answer(outcome, language)}});
    document.sections.push_back({LT_TEXT("Engine", "Receptance of the chuck face"),
                                 {spindleMagnitudePlot(outcome.spindle), spindlePhasePlot(outcome.spindle),
                                  report::parametersTable(*outcome.spindle.springs(), language, outcome.used)}});
    return document;
}

}  // namespace

receptance::TapTests MeasurementStore::read(const project::Source& source, io::InputFiles& inputs,
                                            const Progress& progress) const
{
    return receptance::loadTapTests({source.path, inputs.open(source.path, progress), source.import, inputs, progress});
}

MachineOutcome machineOutcome(const project::PanelState& state, Stores& stores, const Progress& progress)
{
    MachineOutcome outcome;
    outcome.question = fromValues<MachineQuestion>(state.parameters);
    if (outcome.question.source == measuredSource)
        identify(outcome, state, stores, progress);
    else
        takeSprings(outcome);
    progress.report(1);
    return outcome;
}

report::Answer answer(const MachineOutcome& outcome, const Language& language)
{
    if (outcome.identified) {
        report::Answer answer = receptance::answer(*outcome.identified, language);
        if (const auto& held_out = outcome.identified->hold_out_rms_percent) {  // the residual of the held-out rod is
                                                                                // more meaningful
            answer.quantity = LT_TEXT("Engine", "Residual of the rod held out");
            answer.value = held_out;
            answer.sentence =
                LT_TEXT("Engine", "Of the responses used {used} % · responses: {responses} · lines: {lines}");
            set(answer.values, "used", fixed(outcome.identified->residual_rms_percent, 2, language));
        }
        if (!outcome.question.limit_percent) return answer;
        answer.upper_limit = outcome.question.limit_percent;
        answer.verdict = *answer.value <= *outcome.question.limit_percent ? Verdict::Pass : Verdict::Fail;
        answer.verdict_words =
            *answer.verdict == Verdict::Pass ? LT_TEXT("Engine", "✓ accepted") : LT_TEXT("Engine", "✗ not accepted");
        return answer;
    }
    const receptance::SpindleSprings& springs = *outcome.spindle.springs();
    report::Answer answer;
    answer.used = outcome.used;
    answer.quantity = LT_TEXT("Engine", "Static compliance of the chuck face");
    answer.value = nanometres / springs.radial_N_mm;
    answer.unit = LT_TEXT("Engine", "nm/N");
    answer.decimals = 1;
    answer.verdict_words = LT_TEXT("Engine", "computed");
    answer.sentence = LT_TEXT("Engine", "Tilt {tilt} µrad/(N·m) · loss factor {loss}");
    answer.values = {{"tilt", fixed(1e9 / springs.tilt_N_mm_rad, 2, language)},
                     {"loss", fixed(springs.loss_factor, 3, language)}};
    return answer;
}

report::Document reportOf(const MachineOutcome& outcome, const Language& language)
{
    report::Document document =
        outcome.identified ? spindleReport(*outcome.identified, language) : springsReport(outcome, language);
    std::vector<report::Block>& first = document.sections.front().blocks;
    std::erase_if(first, [](const report::Block& block) { return std::holds_alternative<Notes>(block); });
    first.front() = answer(outcome, language);
    if (!outcome.notes.empty()) first.emplace_back(outcome.notes);
    if (outcome.check) {
        report::Section quality{LT_TEXT("Engine", "Quality of the identification"),
                                {residualPlot(*outcome.identified, *outcome.check)}};
        if (outcome.identified->hold_out_rms_percent) quality.blocks.push_back(heldOutPlot(*outcome.check, language));
        quality.blocks.push_back(responsesTable(*outcome.check));
        document.sections.insert(document.sections.begin() + 2, std::move(quality));
    }
    document.inputs = outcome.inputs;
    document.synthetic = outcome.synthetic;
    document.results = {report::toText(
        report::wholeResult("spindle", outcome.inputs, toValues(outcome.question), resultOf(outcome), outcome.notes))};
    return document;
}

}  // namespace lathelier::machine_panel
