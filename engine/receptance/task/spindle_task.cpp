#include "engine/receptance/task/spindle_task.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "engine/core/field_within.h"
#include "engine/core/json.h"
#include "engine/core/statistics.h"
#include "engine/core/units.h"
#include "engine/core/verdict_json.h"
#include "engine/io/file.h"
#include "engine/io/json/json_locate.h"
#include "engine/receptance/receptance_codes.h"
#include "engine/receptance/receptance_quantities.h"
#include "engine/receptance/receptance_report.h"
#include "engine/receptance/spindle/spindle_file.h"
#include "engine/receptance/spindle/spindle_item.h"
#include "engine/receptance/spindle/spindle_plots.h"
#include "engine/report/chart_csv.h"
#include "engine/report/parameters_table.h"
#include "engine/report/plain_text.h"
#include "engine/task/memo.h"
#include "engine/task/task_codes.h"

namespace lathelier::receptance {
namespace {

constexpr double nanometres = 1e6;  ///< per mm

struct Identified {
    SpindleIdentification spindle;
    SpindleCheck check;
};

/// By measurements and parameters: another limit computes nothing anew.
struct IdentifiedSpindles : Memo<Identified> {};

std::vector<FieldChoice> spindleSources()
{
    std::vector<FieldChoice> choices = machineChoices(LT_TEXT("Engine", "springs"));
    choices.front().key = springsSource;
    choices.insert(choices.begin(), {measuredSource, LT_TEXT("Engine", "tap tests")});
    return choices;
}

/// Calls `work`; an error of a rod or of a point on it (from 1) gets its place in the file.
template <class Work>
auto namingRods(const std::string& path, Work work)
{
    try {
        return work();
    } catch (Error& error) {
        if (error.code().kind != ErrorKind::InputRejected) throw;
        io::JsonPath where{"rods"};
        for (const auto& [name, list] : {std::pair("rod", ""), std::pair("point", "points")}) {
            const Value* const number = find(error.values(), name);
            if (!number) break;
            if (*list != '\0') where.emplace_back(list);
            where.push_back(std::to_string(std::get<std::int64_t>(*number) - 1));
        }
        if (where.size() > 1) io::locateInFile(error, path, where);
        throw;
    }
}

Notes identify(SpindleOutcome& outcome, const project::PanelState& state, Stores& stores, task::Sources& sources,
               const Progress& progress)
{
    const auto loaded = task::takeFile<MeasurementsInput>(state, measurementsRole, stores,
                                                          progress.part(0, 0.1, LT_TEXT("Engine", "Reading")), sources);
    if (!loaded) throw Error(errors::oneNeeded, {{"names", LT_TEXT("Engine", "Tap tests or springs")}});
    const SpindleMeasurements& measured = loaded->file.measurements;
    const auto& asked = outcome.question.identification;
    const auto found = stores.of<IdentifiedSpindles>()->find(
        loaded->digest() + toJson(state.inputs.at(measurementsRole).import).dump() +
            toJson(lathelier::toValues(asked)).dump(),
        progress.part(0.1, 1, LT_TEXT("Engine", "Identifying")), [&](const Progress& identifying) {
            Identified result{namingRods(loaded->inputs.front().path,
                                         [&] { return identifySpindle(measured, asked, identifying.part(0, 0.9)); }),
                              {}};
            result.check = checkSpindle(measured, result.spindle, identifying.part(0.9, 1));
            return result;
        });
    outcome.identified = {found, &found->spindle};
    outcome.check = {found, &found->check};
    outcome.spindle = outcome.identified->spindle;
    outcome.used = outcome.identified->used;
    return outcome.identified->notes;
}

Notes takeSprings(SpindleOutcome& outcome)
{
    SpindleSprings springs = outcome.question.springs;
    ValueOrigin origin = ValueOrigin::Given;
    Notes found;
    if (const auto* entry = entryOf(machines(), outcome.question.source)) {
        springs = entry->value;
        origin = ValueOrigin::Assumed;
        found.push_back({notes::machineOfLibrary, {{"source", entry->source}}});
    }
    for (const auto& field : fields<SpindleSprings>()) addUsed(outcome.used, field.info, field.get(springs), origin);
    outcome.spindle.source = springs;
    return found;
}

std::optional<Verdict> verdictOf(const SpindleOutcome& outcome)
{
    return outcome.understanding.isWhole() ? answer(outcome).verdict : Verdict::Undecided;
}

Json jsonOf(const SpindleOutcome& outcome)
{
    if (!outcome.identified) return Json::parse(spindleText(outcome.spindle));
    Json json = nestedJson(describedValues(*outcome.identified));
    const std::optional<Verdict> verdict = verdictOf(outcome);
    json["verdict"] = verdictJson(verdict);
    json["residual_percent"] = outcome.check->residual_percent;
    json["responses"] = Json::array();
    for (const CheckedResponse& response : outcome.check->responses)
        json["responses"].push_back(nestedJson(describedValues(response)));
    json["remedy"] = nullptr;
    if (const auto& tried = outcome.identified->remedy) {
        json["remedy"] = nestedJson(tried->values);
        json["remedy"]["kind"] = key(tried->remedy.kind);
    }
    return json;
}

report::Document springsReport(const SpindleOutcome& outcome, const Language& language)
{
    report::Document document;
    document.title = LT_TEXT("Engine", "Receptance of a spindle");
    document.sections.push_back({LT_TEXT("Engine", "Result"), {answer(outcome, language)}});
    document.sections.push_back({LT_TEXT("Engine", "Receptance of the chuck face"),
                                 {spindleMagnitudePlot(outcome.spindle), spindlePhasePlot(outcome.spindle),
                                  report::parametersTable(*outcome.spindle.springs(), language, outcome.used)}});
    return document;
}

report::Document reportOf(const SpindleOutcome& outcome, const Language& language)
{
    report::Document document =
        outcome.identified ? spindleReport(*outcome.identified, language) : springsReport(outcome, language);
    std::vector<report::Block>& first = document.sections.front().blocks;
    std::erase_if(first, [](const report::Block& block) { return std::holds_alternative<Notes>(block); });
    first.front() = answer(outcome, language);
    if (!outcome.notes.empty()) first.emplace_back(outcome.notes);
    if (!outcome.check) return document;
    report::Section quality{LT_TEXT("Engine", "Quality of the identification"),
                            {residualPlot(*outcome.check, language)}};
    if (outcome.identified->hold_out_rms_percent) quality.blocks.push_back(heldOutPlot(*outcome.check, language));
    quality.blocks.push_back(responsesTable(*outcome.check));
    document.sections.insert(document.sections.begin() + 2, std::move(quality));
    return document;
}

report::Section summaryOf(const SpindleOutcome& outcome, const Language& language)
{
    if (!outcome.identified) return {LT_TEXT("Engine", "Result"), {answer(outcome, language)}};
    report::Section section = spindleSummary(*outcome.identified, language);
    section.blocks.front() = answer(outcome, language);
    return section;
}

/// The stiffness that the chuck face shows at the lowest lines, where inertia does not count; its uncertainty from the
/// residual (k = 2), which becomes the sentence. `told`: the answer with the residual.
report::Answer stiffnessAnswer(const SpindleIdentification& found, report::Answer told, const Language& language)
{
    constexpr std::size_t share_of_lines = 10;
    std::vector<double> stiffness_N_um;
    const std::size_t lines = std::max<std::size_t>(1, found.frequency_hz.size() / share_of_lines);
    for (std::size_t i = 0; i < std::min(lines, found.frequency_hz.size()); ++i)
        stiffness_N_um.push_back(1 / (um_per_mm * std::abs(found.spindle.at(found.frequency_hz[i])(0, 0))));
    const double middle_N_um = stiffness_N_um.empty() ? notANumber : median(std::move(stiffness_N_um));
    if (!std::isfinite(middle_N_um)) return told;
    const double residual_percent = *told.value;
    told.quantity = LT_TEXT("Engine", "Stiffness of the chuck face");
    told.value = middle_N_um;
    told.unit = LT_TEXT("Engine", "N/µm");
    told.expanded_uncertainty = 2 * residual_percent / 100 * middle_N_um;
    told.decimals =
        std::clamp(1 - static_cast<int>(std::floor(std::log10(std::max(1e-6, *told.expanded_uncertainty)))), 0, 3);
    set(told.values, "residual", fixed(residual_percent, 2, language));
    told.sentence = found.hold_out_rms_percent
                        ? LT_TEXT("Engine", "The rod held out is reproduced to {residual} % · responses: {responses}")
                        : LT_TEXT("Engine", "The rods are reproduced to {residual} % · responses: {responses}");
    return told;
}

/// The residual of a rod that was held out says more than that of the responses used.
report::Answer identifiedAnswer(const SpindleOutcome& outcome, const Language& language)
{
    report::Answer told = answer(*outcome.identified, language);
    if (const auto& held_out = outcome.identified->hold_out_rms_percent) {
        told.quantity = LT_TEXT("Engine", "Residual of the rod held out");
        told.value = held_out;
        told.sentence = LT_TEXT("Engine", "Of the responses used {used} % · responses: {responses} · lines: {lines}");
        set(told.values, "used", fixed(outcome.identified->residual_rms_percent, 2, language));
    }
    if (!outcome.question.limit_percent) return stiffnessAnswer(*outcome.identified, std::move(told), language);
    told.upper_limit = outcome.question.limit_percent;
    told.verdict = *told.value <= *outcome.question.limit_percent ? Verdict::Pass : Verdict::Fail;
    told.verdict_words =
        *told.verdict == Verdict::Pass ? LT_TEXT("Engine", "✓ accepted") : LT_TEXT("Engine", "✗ not accepted");
    return told;
}

std::string nameOfProduct(const SpindleOutcome& outcome, const Language& language)
{
    if (outcome.sources.inputs.empty()) return text(LT_TEXT("Engine", "spindle"), language);
    const std::string file = std::filesystem::path(outcome.sources.inputs.front().path).stem().string();
    return fill(text(LT_TEXT("Engine", "spindle of {file}"), language), {{"file", file}});
}

}  // namespace

const std::vector<Field<SpindleQuestion>>& fieldsOf(const SpindleQuestion*)
{
    using Q = SpindleQuestion;
    static const auto all = [] {
        auto list = described<Q>(
            choice(sourceKey, &Q::source, spindleSources(),
                   Label{LT_TEXT("Engine", "Known from"),
                         LT_TEXT("Engine", "Machines of the library are assumed values to begin with.")}),
            group("springs", &Q::springs,
                  Label{LT_TEXT("Engine", "Springs at the chuck"), LT_TEXT("Engine", "Where they are typed.")}));
        for (const FieldInfo& info : infos<IdentificationParameters>())
            list.push_back(within(&Q::identification, info.key));
        list.push_back(
            field("limit_percent", &Q::limit_percent, Range{0, 1000},
                  Label{LT_TEXT("Engine", "Largest residual"),
                        LT_TEXT("Engine", "Of the rod held out, else of all responses used."), unit::percent}));
        return list;
    }();
    return all;
}

SpindleOutcome answerSpindle(const project::PanelState& state, Stores& stores, task::Sources& sources,
                             const Progress& progress)
{
    SpindleOutcome outcome;
    outcome.question = fromValues<SpindleQuestion>(state.parameters);
    const Notes found = outcome.question.source == measuredSource ? identify(outcome, state, stores, sources, progress)
                                                                  : takeSprings(outcome);
    outcome.record(state, sources, found);
    progress.report(1);
    return outcome;
}

report::Answer answer(const SpindleOutcome& outcome, const Language& language)
{
    if (outcome.identified) return identifiedAnswer(outcome, language);
    const SpindleSprings& springs = *outcome.spindle.springs();
    report::Answer told;
    told.used = outcome.used;
    told.quantity = LT_TEXT("Engine", "Static compliance of the chuck face");
    told.value = nanometres / springs.radial_N_mm;
    told.unit = LT_TEXT("Engine", "nm/N");
    told.decimals = 1;
    told.verdict_words = LT_TEXT("Engine", "computed");
    told.sentence = LT_TEXT("Engine", "Tilt {tilt} µrad/(N·m) · loss factor {loss}");
    told.values = {{"tilt", fixed(1e9 / springs.tilt_N_mm_rad, 2, language)},
                   {"loss", fixed(springs.loss_factor, 3, language)}};
    return told;
}

task::Outcome outcomeOf(const std::shared_ptr<const SpindleOutcome>& outcome)
{
    task::Outcome all;
    all.result = outcome;
    all.notes = outcome->notes;
    all.verdict = verdictOf(*outcome);
    all.json = [outcome] { return jsonOf(*outcome); };
    all.answer = [outcome](const Language& language) { return answer(*outcome, language); };
    all.summary = [outcome](const Language& language) { return summaryOf(*outcome, language); };
    all.report = [outcome](const Language& language) { return reportOf(*outcome, language); };
    all.writers[spindleExport] = [outcome](const std::string& path, const Language&, const Progress&) {
        io::writeFile(path, spindleText(outcome->spindle));
    };
    all.writers[magnitudeExport] = [outcome](const std::string& path, const Language&, const Progress&) {
        io::writeFile(path, report::toCsv(spindleMagnitudePlot(outcome->spindle)));
    };
    all.products = [outcome](const Language& language) {
        return std::vector<task::Product>{
            {spindleItem, {}, nameOfProduct(*outcome, language), [outcome] { return toValues(outcome->spindle); }}};
    };
    return settled(spindleTask(), std::move(all), outcome->understanding);
}

const task::Task& spindleTask()
{
    static const task::Task task = [] {
        task::Task made;
        made.key = "spindle";
        made.title = LT_TEXT("Engine", "Spindle");
        made.summary = "Identify the receptance of a spindle from tap tests on rods (inverse coupling).";
        made.question = "machine";
        made.products = {spindleItem};
        made.inputs = {task::optionalInput<MeasurementsInput>(
            measurementsRole, "", LT_TEXT("Engine", "Tap tests"),
            LT_TEXT("Engine", "MEASUREMENTS.json, with the file of frequency responses beside it"))};
        task::askFor<SpindleQuestion>(made);
        made.exports = {
            {spindleExport, "Write the spindle as SPINDLE.json.", LT_TEXT("Engine", "Spindle (SPINDLE.json)…"),
             LT_TEXT("Engine", "JSON (*.json)"), "json", true},
            {magnitudeExport, "Write the magnitude over the frequency as FILE.csv.",
             LT_TEXT("Engine", "Magnitude over frequency (CSV)…"), LT_TEXT("Engine", "Table (*.csv)"), "csv"}};
        made.run = [](const project::PanelState& state, const task::Wanted&, Stores& stores, task::Sources& sources,
                      const Progress& progress) {
            return outcomeOf(std::make_shared<const SpindleOutcome>(answerSpindle(state, stores, sources, progress)));
        };
        return made;
    }();
    return task;
}

}  // namespace lathelier::receptance
