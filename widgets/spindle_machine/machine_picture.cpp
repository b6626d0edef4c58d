#include "widgets/spindle_machine/machine_picture.h"

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
#include "widgets/core/task/memo.h"

namespace lathelier::machine_panel {
namespace {

constexpr double nanometres = 1e6;  ///< per mm

struct Identified {
    receptance::SpindleIdentification spindle;
    receptance::SpindleCheck check;
};

/// By measurements and parameters: another limit computes nothing anew.
struct IdentifiedMemo : Memo<Identified> {};

void identify(MachinePicture& picture, const project::PanelState& state, Stores& stores, const Progress& progress)
{
    const project::Source& source = state.inputs.at(measurementsRole);
    const auto loaded =
        stores.of<MeasurementStore>()->load(source, progress.part(0, 0.1, LT_TEXT("Engine", "Reading")));
    picture.inputs = loaded->inputs;
    picture.notes = loaded->file.notes;
    picture.synthetic = source.synthetic || contains(loaded->file.notes, notes::syntheticData);
    const receptance::SpindleMeasurements& measured = loaded->file.measurements;
    const auto& asked = picture.question.identification;
    const auto found = stores.of<IdentifiedMemo>()->find(
        loaded->digest() + toJson(source.import).dump() + toJson(toValues(asked)).dump(),
        progress.part(0.1, 1, LT_TEXT("Engine", "Identifying")), [&](const Progress& identifying) {
            Identified result{identifySpindle(measured, asked, identifying.part(0, 0.9)), {}};
            result.check = checkSpindle(measured, result.spindle, identifying.part(0.9, 1));
            return result;
        });
    picture.identified = {found, &found->spindle};
    picture.check = {found, &found->check};
    picture.spindle = picture.identified->spindle;
    picture.used = picture.identified->used;
    const Notes& remarks = picture.identified->notes;
    picture.notes.insert(picture.notes.end(), remarks.begin(), remarks.end());
}

void takeSprings(MachinePicture& picture)
{
    receptance::SpindleSprings springs = picture.question.springs;
    ValueOrigin origin = ValueOrigin::Given;
    if (const auto* entry = chatter_common::chosen(ofLibrary(picture.question.source)).entry) {
        springs = entry->value;
        origin = ValueOrigin::Assumed;
        picture.notes.push_back({notes::machineOfLibrary, {{"source", entry->source}}});
    }
    for (const auto& field : fields<receptance::SpindleSprings>())
        addUsed(picture.used, field.info, field.get(springs), origin);
    picture.spindle.source = springs;
}

Json resultOf(const MachinePicture& picture)
{
    if (!picture.identified) return Json::parse(receptance::spindleText(picture.spindle));
    Json json = nestedJson(describedValues(*picture.identified));
    json["residual_percent"] = picture.check->residual_percent;
    return json;
}

report::Document springsReport(const MachinePicture& picture, const Language& language)
{
    report::Document document;
    document.title = LT_TEXT("Engine", "Receptance of a spindle");
    document.sections.push_back({LT_TEXT("Engine", "Result"), {answer(picture, language)}});
    document.sections.push_back({LT_TEXT("Engine", "Receptance of the chuck face"),
                                 {spindleMagnitudePlot(picture.spindle), spindlePhasePlot(picture.spindle),
                                  report::parametersTable(*picture.spindle.springs(), language, picture.used)}});
    return document;
}

}  // namespace

receptance::TapTests MeasurementStore::read(const project::Source& source, io::InputFiles& inputs,
                                            const Progress& progress) const
{
    return receptance::loadTapTests({source.path, inputs.open(source.path, progress), source.import, inputs, progress});
}

MachinePicture machinePicture(const project::PanelState& state, Stores& stores, const Progress& progress)
{
    MachinePicture picture;
    picture.question = fromValues<MachineQuestion>(state.parameters);
    if (picture.question.source == MachineSource::Measured)
        identify(picture, state, stores, progress);
    else
        takeSprings(picture);
    progress.report(1);
    return picture;
}

report::Answer answer(const MachinePicture& picture, const Language& language)
{
    if (picture.identified) {
        report::Answer answer = receptance::answer(*picture.identified, language);
        if (const auto& held_out = picture.identified->hold_out_rms_percent) {  // what it predicts says more
            answer.quantity = LT_TEXT("Engine", "Residual of the rod held out");
            answer.value = held_out;
            answer.sentence =
                LT_TEXT("Engine", "Of the responses used {used} % · responses: {responses} · lines: {lines}");
            set(answer.values, "used", fixed(picture.identified->residual_rms_percent, 2, language));
        }
        if (!picture.question.limit_percent) return answer;
        answer.upper_limit = picture.question.limit_percent;
        answer.verdict = *answer.value <= *picture.question.limit_percent ? Verdict::Pass : Verdict::Fail;
        answer.verdict_words =
            *answer.verdict == Verdict::Pass ? LT_TEXT("Engine", "✓ accepted") : LT_TEXT("Engine", "✗ not accepted");
        return answer;
    }
    const receptance::SpindleSprings& springs = *picture.spindle.springs();
    report::Answer answer;
    answer.used = picture.used;
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

report::Document reportOf(const MachinePicture& picture, const Language& language)
{
    report::Document document =
        picture.identified ? spindleReport(*picture.identified, language) : springsReport(picture, language);
    std::vector<report::Block>& first = document.sections.front().blocks;
    std::erase_if(first, [](const report::Block& block) { return std::holds_alternative<Notes>(block); });
    first.front() = answer(picture, language);
    if (!picture.notes.empty()) first.emplace_back(picture.notes);
    if (picture.check) {
        report::Section quality{LT_TEXT("Engine", "Quality of the identification"),
                                {residualPlot(*picture.identified, *picture.check)}};
        if (picture.identified->hold_out_rms_percent) quality.blocks.push_back(heldOutPlot(*picture.check, language));
        quality.blocks.push_back(responsesTable(*picture.check));
        document.sections.insert(document.sections.begin() + 2, std::move(quality));
    }
    document.inputs = picture.inputs;
    document.synthetic = picture.synthetic;
    document.results = {report::toText(
        report::wholeResult("spindle", picture.inputs, toValues(picture.question), resultOf(picture), picture.notes))};
    return document;
}

}  // namespace lathelier::machine_panel
