#include "engine/receptance/task/modes_task.h"

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "engine/core/core_codes.h"
#include "engine/core/field_within.h"
#include "engine/core/json.h"
#include "engine/io/file.h"
#include "engine/io/frf/frf_input.h"
#include "engine/io/frf/frf_writer.h"
#include "engine/io/io_codes.h"
#include "engine/io/shaft/shaft_input.h"
#include "engine/receptance/frf_checks.h"
#include "engine/receptance/modal/modal_quantities.h"
#include "engine/receptance/modal/modal_report.h"
#include "engine/receptance/modal/uncertain_model.h"
#include "engine/receptance/spindle/spindle_input.h"
#include "engine/receptance/task/shaft_task.h"
#include "engine/report/parameters_table.h"
#include "engine/report/quantity_table.h"
#include "engine/task/memo.h"
#include "engine/task/read_key.h"

namespace lathelier::receptance {
namespace {

constexpr double mostLines = 4000;  ///< largest number of lines of the computed response

constexpr const char* responseCsvExport = "csv";
constexpr const char* responseUffExport = "uff";
constexpr const char* modesCsvExport = "modes-csv";

/// By response and parameters: a dragged peak does not fit anew.
struct FittedModes : Memo<std::vector<ModalFit>> {};
struct ComputedShafts : Memo<ShaftReceptanceResult> {};

void append(Notes& all, const Notes& more)
{
    all.insert(all.end(), more.begin(), more.end());
}

/// What is fitted, with its cache key.
struct Basis {
    std::string key;                                        ///< empty: nothing is known
    std::shared_ptr<const Loaded<io::FrfChoiceFile>> file;  ///< that holds the response; null: an item
    std::size_t shown = 0;                                  ///< number of the response in the file
};

/// Takes the response.
Basis takeMeasured(ModesOutcome& outcome, const project::PanelState& state, Stores& stores, task::Sources& sources,
                   const Progress& progress)
{
    const project::Source* const source = task::sourceOf(state, responseRole);
    if (!source) return {};
    const std::size_t read = sources.inputs.size();
    const auto loaded = task::takeFile<io::FrfInput>(state, responseRole, stores, progress, sources);
    if (!loaded) {
        outcome.name = source->item;
        outcome.study.measured =
            std::make_shared<const Frf>(*task::take<io::FrfInput>(state, responseRole, stores, progress, sources));
        return {task::readKey(state, {responseRole}, sources, read), {}};
    }
    const io::MeasuredFrf& chosen = loaded->file.response();
    append(sources.notes, loaded->file.notes_of_choice);
    append(sources.notes, checkResponse(chosen, source->path));
    outcome.study.measured = std::make_shared<const Frf>(io::toReceptance(chosen.frf));
    outcome.measured = chosen;
    outcome.measured.frf = {};
    outcome.name = std::filesystem::path(source->path).filename().string();
    if (loaded->file.frfs.size() > 1) {
        const std::string pair = io::nodePair(chosen);
        outcome.name += " " + (pair.empty() ? "#" + std::to_string(loaded->file.used + 1) : pair);
    }
    return {task::readKey(state, {responseRole}, sources, read), loaded, loaded->file.used};
}

/// Error valueNotUnderstood for a mode without stiffness.
void requireStiffness(const std::vector<ModalMode>& modes)
{
    for (const ModalMode& mode : modes)
        if (mode.stiffness_N_mm == 0)
            throw Error(
                errors::valueNotUnderstood,
                {{"parameter", "modes"}, {"found", 0.0}, {"expected", LT_TEXT("Engine", "a stiffness, not 0")}});
}

void chooseLines(ReceptanceParameters& computing, const ModesOutcome& outcome,
                 const std::optional<SpindleReceptance>& machine)
{
    if (outcome.study.measured && outcome.study.measured->frequency_hz.size() > 1) {
        const std::vector<double>& lines = outcome.study.measured->frequency_hz;
        const double steps = std::min(mostLines, static_cast<double>(lines.size()) - 1);
        computing.step_hz = (lines.back() - lines.front()) / steps;
        computing =
            withinLines(computing, machine, {lines.front() > 0 ? lines.front() : computing.step_hz, lines.back()});
    } else if (!outcome.question.modal.range_hz.empty()) {
        const Interval& range = outcome.question.modal.range_hz.front();
        computing.step_hz = std::max(1e-3, (range.to - range.from) / mostLines * 2);
        computing = withinLines(computing, machine, {std::max(range.from, computing.step_hz), range.to});
    }
}

std::string takeComputed(ModesOutcome& outcome, const project::PanelState& state, Stores& stores,
                         task::Sources& sources, const Progress& progress)
{
    const std::size_t read = sources.inputs.size();
    const auto shaft = task::take<io::ShaftInput>(state, shaftRole, stores, progress.part(0, 0.1), sources);
    if (!shaft) return {};
    const auto machine = task::take<SpindleInput>(state, spindleRole, stores, progress.part(0.1, 0.2), sources);
    ReceptanceParameters computing = outcome.question.computing;
    chooseLines(computing, outcome, machine);
    std::string key =
        task::readKey(state, {shaftRole, spindleRole}, sources, read) + toJson(lathelier::toValues(computing)).dump();
    const std::string name = task::nameOf(*task::sourceOf(state, shaftRole));
    const auto found = stores.of<ComputedShafts>()->find(key, progress.part(0.2, 1), [&](const Progress& part) {
        return shaftReceptance(*shaft, computing, machine, part);
    });
    append(sources.notes, found->notes);
    Frf frf = found->frf;
    io::dropUnusableLines(frf);  // removes 0 Hz, where a free shaft has no receptance
    outcome.study.computed = std::make_shared<const Frf>(std::move(frf));
    if (outcome.name.empty()) outcome.name = shaft->name.empty() ? name : shaft->name;
    return key;
}

/// The responses that are fitted: the shown one, or all of its file.
std::vector<ResponseToFit> responsesToFit(const ModesOutcome& outcome, const Basis& basis, std::vector<Frf>& converted)
{
    const bool is_driving_point = basis.file && io::isDrivingPoint(outcome.measured);
    if (!basis.file || !outcome.question.all_responses) return {{outcome.study.basis(), is_driving_point}};
    const std::vector<io::MeasuredFrf>& all = basis.file->file.frfs;
    converted.reserve(all.size());
    std::vector<ResponseToFit> responses;
    for (const io::MeasuredFrf& one : all) {
        converted.push_back(io::toReceptance(one.frf));
        responses.push_back({&converted.back(), io::isDrivingPoint(one)});
    }
    return responses;
}

/// Fits the response, or all of its file, once for each question.
void fitTo(ModesOutcome& outcome, const Basis& basis, Stores& stores, const Progress& progress)
{
    ResponseStudy& study = outcome.study;
    const ModesQuestion& question = outcome.question;
    std::string key = basis.key + toJson(lathelier::toValues(question.modal)).dump();
    if (question.all_responses) key += "all";
    const auto fits = stores.of<FittedModes>()->find(key, progress, [&](const Progress& part) {
        std::vector<Frf> converted;
        return fitResponses(responsesToFit(outcome, basis, converted), question.modal, part);
    });
    const auto fitAt = [&fits](std::size_t i) { return std::shared_ptr<const ModalFit>(fits, &(*fits)[i]); };
    study.fit = fitAt(fits->size() > 1 ? basis.shown : 0);
    if (!question.all_responses || !basis.file) return;
    for (std::size_t i = 0; i < fits->size(); ++i) {
        const std::string pair = io::nodePair(basis.file->file.frfs[i]);
        study.common.push_back({pair.empty() ? std::to_string(i + 1) : pair, fitAt(i)});
    }
}

std::string modesCsv(const ResponseStudy& study)
{
    return report::csvOf<ShownMode>(
        shownModes(study), {"rank", "frequency_hz", "frequency_uncertainty_hz", "damping_ratio", "damping_uncertainty",
                            "stiffness_N_mm", "stiffness_uncertainty_N_mm", "phase_deg", "flexibility_nm_N"});
}

Json jsonOf(const ResponseStudy& study)
{
    const Json json = toJson(study);
    return json.is_null() ? Json::object() : json;
}

report::Document reportOf(const ModesOutcome& outcome, const Language& language)
{
    report::Document document = responseReport(outcome.study, outcome.notes, language);
    if (outcome.study.computed) {
        std::vector<FieldInfo> of_computing;
        const auto all = infos<ReceptanceParameters>();
        for (const FieldInfo& info : infos<ModesQuestion>())
            if (std::any_of(all.begin(), all.end(), [&](const FieldInfo& one) { return one.key == info.key; }))
                of_computing.push_back(info);
        report::QuantityTable table =
            report::parametersTable(of_computing, lathelier::toValues(outcome.question), language);
        table.title = LT_TEXT("Engine", "Computed response");
        document.sections.back().blocks.emplace_back(std::move(table));
    }
    return document;
}

report::Section summaryOf(const ModesOutcome& outcome, const Language& language)
{
    report::Section section{LT_TEXT("Engine", "Result"), {answer(outcome.study, language)}};
    if (!outcome.study.model.modes.empty()) section.blocks.emplace_back(modesTable(outcome.study));
    if (!outcome.study.common.empty()) section.blocks.emplace_back(shapesTable(outcome.study, language));
    if (!outcome.notes.empty()) section.blocks.emplace_back(outcome.notes);
    return section;
}

void addWriters(task::Outcome& all, const std::shared_ptr<const ModesOutcome>& outcome)
{
    if (const FrfPtr frf = outcome->handedOn()) {
        all.writers[responseCsvExport] = [frf](const std::string& path, const Language&, const Progress&) {
            io::writeFrfCsv(path, *frf);
        };
        all.writers[responseUffExport] = [frf, outcome](const std::string& path, const Language&, const Progress&) {
            io::MeasuredFrf response = outcome->measured;
            response.frf = *frf;
            io::writeUff(path, {&response, 1});
        };
    }
    if (outcome->study.model.modes.empty()) return;
    all.writers[modesCsvExport] = [outcome](const std::string& path, const Language&, const Progress&) {
        io::writeFile(path, modesCsv(outcome->study));
    };
}

}  // namespace

const std::vector<Field<ModesQuestion>>& fieldsOf(const ModesQuestion*)
{
    using Q = ModesQuestion;
    static const std::vector<Field<Q>> all = [] {
        std::vector<Field<Q>> made{
            field("all_responses", &Q::all_responses,
                  Label{LT_TEXT("Engine", "All responses of the file"),
                        LT_TEXT("Engine", "Fitted together: common frequencies and damping, own stiffnesses.")}),
            field("fit", &Q::fit, Label{LT_TEXT("Engine", "Fit modes"), LT_TEXT("Engine", "Finds the modes.")}),
            within(&Q::modal, "number_of_modes"),
            within(&Q::modal, "range_hz"),
            field("handed_on", &Q::handed_on,
                  {{"measured", LT_TEXT("Engine", "The response itself")},
                   {"model", LT_TEXT("Engine", "The modal model")}},
                  Label{LT_TEXT("Engine", "Use for lobes"),
                        LT_TEXT("Engine", "What is handed on and written: the response, or its modal model.")}),
            rows(changedModesKey, &Q::modes, Range{0, mostModes},
                 Label{LT_TEXT("Engine", "Modes changed by hand"),
                       LT_TEXT("Engine", "In place of those of the fit; drag a peak in the magnitude chart.")}),
            within(&Q::modal, "complex_residues"),
            within(&Q::modal, "driving_point"),
            foldedWithin(&Q::computing, "respond_z_mm"),
            foldedWithin(&Q::computing, "excite_z_mm"),
            foldedWithin(&Q::computing, "shear"),
            foldedWithin(&Q::computing, "step_correction")};
        made[1].info.is_kept = true;  // of a window, which shows a response without its modes as well
        return made;
    }();
    return all;
}

FrfPtr ModesOutcome::handedOn() const
{
    if (question.handed_on == HandedOn::Measured) return study.measured ? study.measured : study.computed;
    if (study.synthesised.value.empty()) return nullptr;
    return std::make_shared<const Frf>(study.synthesised);
}

ModesOutcome answerModes(const project::PanelState& state, Stores& stores, task::Sources& sources,
                         const Progress& progress)
{
    ModesOutcome outcome;
    outcome.question = fromValues<ModesQuestion>(state.parameters);
    const ModesQuestion& question = outcome.question;
    requireStiffness(question.modes);
    Basis basis = takeMeasured(outcome, state, stores, sources, progress.part(0, 0.3, LT_TEXT("Engine", "Reading")));
    const std::string computed =
        takeComputed(outcome, state, stores, sources, progress.part(0.3, 0.5, LT_TEXT("Engine", "Computing")));
    if (basis.key.empty()) basis.key = computed;
    if (question.fit && outcome.study.basis())
        fitTo(outcome, basis, stores, progress.part(0.5, 1, LT_TEXT("Engine", "Fitting modes")));
    completeStudy(outcome.study, question.modes);
    outcome.record(state, sources, outcome.study.fit ? outcome.study.fit->notes : Notes{});
    return outcome;
}

task::Outcome outcomeOf(const std::shared_ptr<const ModesOutcome>& outcome)
{
    task::Outcome all;
    all.result = outcome;
    all.notes = outcome->notes;
    all.json = [outcome] { return jsonOf(outcome->study); };
    all.answer = [outcome](const Language& language) { return answer(outcome->study, language); };
    all.summary = [outcome](const Language& language) { return summaryOf(*outcome, language); };
    all.report = [outcome](const Language& language) { return reportOf(*outcome, language); };
    addWriters(all, outcome);
    if (const FrfPtr frf = outcome->handedOn())
        all.products = [outcome, frf](const Language& language) {
            const bool is_model = outcome->question.handed_on == HandedOn::Model;
            const std::string name = is_model ? fill(text(LT_TEXT("Engine", "{response}, modal model"), language),
                                                     {{"response", outcome->name}}, language)
                                              : outcome->name;
            return std::vector<task::Product>{{frfItem, {}, name, [outcome, frf, name, is_model] {
                                                   Frf item = *frf;
                                                   item.name = name;
                                                   Values values = toValues(item);
                                                   if (is_model) addModel(uncertainModelOf(outcome->study), values);
                                                   return values;
                                               }}};
        };
    return settled(modesTask(), std::move(all), outcome->understanding);
}

const task::Task& modesTask()
{
    static const task::Task task = [] {
        task::Task made;
        made.key = "modes";
        made.title = LT_TEXT("Engine", "FRF");
        made.summary = "Modes of a measured frequency response, beside that of a computed shaft.";
        made.question = "machine";
        made.products = {frfItem};
        made.inputs = {
            task::optionalInput<io::FrfInput>(responseRole, "", LT_TEXT("Engine", "Frequency response"),
                                              LT_TEXT("Engine", "Measured by a hammer or shaker: UFF, CSV or MAT.")),
            task::optionalInput<io::ShaftInput>(
                shaftRole, shaftRole, LT_TEXT("Engine", "Shaft"),
                LT_TEXT("Engine",
                        "Whose computed response is drawn under the measured one: SHAFT.json or a stock file.")),
            task::optionalInput<SpindleInput>(
                spindleRole, spindleRole, LT_TEXT("Engine", "Spindle"),
                LT_TEXT("Engine", "That holds the shaft: SPINDLE.json. Without it the shaft is free."))};
        made.inputs.front().is_of_part = true;
        made.one_of = {{responseRole, shaftRole}, LT_TEXT("Engine", "Frequency response or shaft"), true};
        task::askFor<ModesQuestion>(made);
        made.exports = {{responseCsvExport, "Write the response that is handed on as FILE.csv.",
                         LT_TEXT("Engine", "Response (CSV)…"), LT_TEXT("Engine", "Table (*.csv)"), "csv"},
                        {responseUffExport, "Write the response that is handed on as a universal file (58).",
                         LT_TEXT("Engine", "Response (UFF 58)…"), LT_TEXT("Engine", "Universal file (*.uff)"), "uff"},
                        {modesCsvExport, "Write the modes as FILE.csv.", LT_TEXT("Engine", "Modes (CSV)…"),
                         LT_TEXT("Engine", "Table (*.csv)"), "csv"}};
        made.run = [](const project::PanelState& state, const task::Wanted&, Stores& stores, task::Sources& sources,
                      const Progress& progress) {
            return outcomeOf(std::make_shared<const ModesOutcome>(answerModes(state, stores, sources, progress)));
        };
        return made;
    }();
    return task;
}

}  // namespace lathelier::receptance
