#include "engine/cad/task/recognize_task.h"

#include <filesystem>
#include <nlohmann/json.hpp>

#include "engine/cad/cad_notes.h"
#include "engine/cad/steps_view.h"
#include "engine/core/field_within.h"
#include "engine/core/json.h"
#include "engine/features/features_codes.h"
#include "engine/features/nominal/snap.h"
#include "engine/features/refit/refit.h"
#include "engine/features/report/recognition_plots.h"
#include "engine/features/report/recognition_report.h"
#include "engine/features/report/recognized_rows.h"
#include "engine/features/stock_part.h"
#include "engine/io/file.h"
#include "engine/report/plot_svg.h"
#include "engine/shaft/shaft_codes.h"
#include "engine/shaft/shaft_rules.h"
#include "engine/task/memo.h"

namespace lathelier::cad {
namespace {

/// By scan and parameters; and by those and the changes.
struct Recognitions : Memo<features::Recognition> {};
struct ChangedRecognitions : Memo<features::Recognition> {};

/// Steps found by the published method, else the rows converted to its table.
void addSteps(RecognizeOutcome& outcome)
{
    const features::Recognition& result = *outcome.result;
    outcome.steps = result.paper_steps;
    if (result.parameters.method == features::RecognitionMethod::Paper) return;
    outcome.steps = stepsOf(outcome.shaft);
    for (ShaftStep& step : outcome.steps) {
        const Eigen::Vector3d middle =
            result.axis_point_mm + (step.z_start_mm + step.z_end_mm) / 2 * result.axis_direction;
        step.x_mm = middle.x();
        step.y_mm = middle.y();
    }
    outcome.beside = rowsBesideSteps(outcome.shaft);
}

RecoveredFrom recoveredFrom(const InputFile& scan, const features::Recognition& result)
{
    RecoveredFrom recovered{std::filesystem::path(scan.path).filename().string(), scan.sha256, result.method_used};
    if (contains(result.notes, notes::endConfirmed)) recovered.stated_length_mm = result.parameters.length_mm;
    return recovered;
}

Json jsonOf(const RecognizeOutcome& outcome)
{
    const features::Recognition& result = *outcome.result;
    Json json = features::toJson(result);
    const bool published = !result.paper_steps.empty();
    const bool applied = result.parameters.snap == features::Snap::Apply && !published;
    json[published ? "robust_steps" : "steps"] = stepsJson(applied ? outcome.shaft : measuredShaft(result));
    return json;
}

report::Document reportOf(const RecognizeOutcome& outcome, const Language& language)
{
    features::Recognition result = *outcome.result;
    result.notes = outcome.notes;
    return recognitionReport(result, outcome.steps, outcome.sources.inputs, language);
}

/// What the rules of shafts and CAD files say of the part as it is written; empty where it is not complete.
Notes remarksOf(const RecognizeOutcome& outcome, bool has_cad)
{
    if (!outcome.result->complete) return {};
    Notes remarks = checkShaft(outcome.shaft);
    if (!has_cad) return remarks;
    const Notes left_out = cadNotes(outcome.shaft);
    remarks.insert(remarks.end(), left_out.begin(), left_out.end());
    return remarks;
}

std::shared_ptr<const PartToWrite> partOf(const std::shared_ptr<const RecognizeOutcome>& outcome)
{
    const double chucked_mm = outcome->result->parameters.length_of_chucked_mm.value_or(0);
    PartToWrite part;
    part.shaft = outcome->shaft;
    part.stock = outcome->result->complete ? features::outOfChuck(outcome->shaft, chucked_mm) : outcome->shaft;
    part.drawing = [outcome](const Language& language) { return drawingOf(*outcome, language); };
    part.require_complete = [outcome] {
        requireComplete(*outcome->result);
        checkShaft(outcome->shaft);
    };
    part.cad = outcome->question.cad;
    return std::make_shared<const PartToWrite>(std::move(part));
}

std::vector<Field<RecognizeQuestion>> kept(std::vector<Field<RecognizeQuestion>> all)
{
    for (Field<RecognizeQuestion>& field : all)
        for (const char* key : {changesKey, changesOfKey})
            if (field.info.key == key) field.info.is_kept = true;
    return all;
}

}  // namespace

const std::vector<Field<RecognizeQuestion>>& fieldsOf(const RecognizeQuestion*)
{
    using Q = RecognizeQuestion;
    static const auto all = [] {
        std::vector<Field<Q>> made;
        for (const FieldInfo& info : infos<features::RecognitionParameters>())
            made.push_back(within(&Q::recognition, info.key));
        for (const FieldInfo& info : infos<TitleQuestion>()) made.push_back(foldedWithin(&Q::title, info.key));
        for (const FieldInfo& info : infos<CadQuestion>()) made.push_back(within(&Q::cad, info.key));
        made.push_back(field(changesKey, &Q::changes,
                             Label{LT_TEXT("Engine", "Changes of rows"), LT_TEXT("Engine", "Made by a person.")}));
        made.push_back(
            field(changesOfKey, &Q::changes_of,
                  Label{LT_TEXT("Engine", "Rows changed of"), LT_TEXT("Engine", "The scan that the changes are of.")}));
        made.push_back(field(acceptedKey, &Q::accepted,
                             Label{LT_TEXT("Engine", "Accepted sizes"),
                                   LT_TEXT("Engine",
                                           "Suggested sizes that a person confirms, as row:quantity: "
                                           "2:diameter_mm,5:leg_mm. They are put in place even beyond U."),
                                   {},
                                   true}));
        return kept(std::move(made));
    }();
    return all;
}

void requireComplete(const features::Recognition& result)
{
    if (result.complete) return;
    const Text reason =
        !result.gaps.empty() ? LT_TEXT("Engine", "there is a gap in the data")
        : !result.length_mm
            ? LT_TEXT("Engine", "an end is not seen or undecided; state the length to confirm it (--length-mm)")
            : LT_TEXT("Engine", "a bore is not seen over its whole length");
    throw Error(errors::shaftIncomplete, {{"reason", reason}});
}

RecognizeOutcome answerRecognize(const project::PanelState& state, Stores& stores, task::Sources& sources,
                                 const Progress& progress)
{
    RecognizeOutcome outcome;
    outcome.question = fromValues<RecognizeQuestion>(state.parameters);
    const RecognizeQuestion& question = outcome.question;
    const project::Source& source = state.inputs.at(scanRole);
    outcome.points = task::takeFile<io::ScanInput>(state, scanRole, stores,
                                                   progress.part(0, 0.3, LT_TEXT("Engine", "Reading")), sources);
    const std::string key =
        outcome.points->digest() + toJson(source.import).dump() + toJson(toValues(question.recognition)).dump();
    outcome.found = stores.of<Recognitions>()->find(
        key, progress.part(0.3, 0.85, LT_TEXT("Engine", "Recognising the rows")), [&](const Progress& part) {
            return features::recognize(outcome.points->file.scan, question.recognition, part);
        });
    if (question.changes_of == source.path) outcome.changes = features::rowChanges(question.changes);
    outcome.result = outcome.changes.empty()
                         ? outcome.found
                         : stores.of<ChangedRecognitions>()->find(
                               key + question.changes, progress.part(0.85, 1), [&](const Progress& part) {
                                   return features::refit(*outcome.found, outcome.changes, part);
                               });
    outcome.accepted = features::acceptedSizes(question.accepted);
    outcome.shaft = withAccepted(*outcome.result, outcome.accepted);
    outcome.shaft.recovered = recoveredFrom(sources.inputs.front(), *outcome.result);
    addTitle(question.title, outcome.shaft, sources.notes);
    if (outcome.shaft.name.empty()) outcome.shaft.name = std::filesystem::path(source.path).stem().string();
    addSteps(outcome);
    Notes found = outcome.result->notes;
    for (Note& note : features::notesOfSizes(*outcome.result, outcome.accepted)) found.push_back(std::move(note));
    outcome.record(state, sources, found);
    progress.report(1);
    return outcome;
}

task::Outcome outcomeOf(const std::shared_ptr<const RecognizeOutcome>& outcome)
{
    const std::shared_ptr<const features::Recognition> result = outcome->result;
    task::Outcome all;
    all.result = outcome;
    all.notes = outcome->notes;
    all.json = [outcome] { return jsonOf(*outcome); };
    all.answer = [result](const Language&) { return features::answer(*result); };
    all.summary = [result](const Language& language) { return features::recognitionSummary(*result, language); };
    all.report = [outcome](const Language& language) { return reportOf(*outcome, language); };
    all.writers = partWriters(partOf(outcome));
    all.writers[meridianExport] = [result](const std::string& path, const Language&, const Progress&) {
        io::writeFile(path, features::meridianCsv(*result));
    };
    all.writers[meridianPicture] = [result](const std::string& path, const Language& language, const Progress&) {
        io::writeFile(path, report::toSvg(features::meridianPlot(*result, language), language));
    };
    all.writers[residualPicture] = [result](const std::string& path, const Language& language, const Progress&) {
        io::writeFile(path, report::toSvg(features::residualPlot(*result), language));
    };
    if (result->complete)
        all.products = [outcome](const Language&) {
            return std::vector<task::Product>{
                {shaftItem, {}, outcome->shaft.name, [outcome] { return toValues(outcome->shaft); }}};
        };
    return settled(recognizeTask(), std::move(all), outcome->understanding);
}

const task::Task& recognizeTask()
{
    static const task::Task task = [] {
        task::Task made;
        made.key = "recognize";
        made.title = LT_TEXT("Engine", "Recognise");
        made.summary =
            "Recognize a turned part in its scan: diameters, lengths, chamfers, fillets, their uncertainties.";
        made.question = "scan";
        made.products = {shaftItem};
        made.inputs = {task::ofPart(
            task::input<io::ScanInput>(scanRole, "", LT_TEXT("Engine", "Scan"),
                                       LT_TEXT("Engine", "Points or mesh of a turned part, in any pose")))};
        task::askFor<RecognizeQuestion>(made);
        made.exports = partExports();
        // The measured drawing marks what is not explained.
        for (task::Export& written : made.exports)
            if (written.option == drawingExport) written.is_cut_by = false;
        const Text picture = LT_TEXT("Engine", "Picture (*.svg)");
        made.exports.push_back({meridianExport, "Write meridian and residuals as FILE.csv.",
                                LT_TEXT("Engine", "Meridian and residuals (CSV)…"), LT_TEXT("Engine", "Table (*.csv)"),
                                "csv"});
        made.exports.push_back(
            {meridianPicture, "Write the meridian as FILE.svg.", LT_TEXT("Engine", "Meridian (SVG)…"), picture, "svg"});
        made.exports.push_back({residualPicture, "Write the residuals as FILE.svg.",
                                LT_TEXT("Engine", "Residuals (SVG)…"), picture, "svg"});
        made.run = [](const project::PanelState& state, const task::Wanted& wanted, Stores& stores,
                      task::Sources& sources, const Progress& progress) {
            RecognizeOutcome outcome = answerRecognize(state, stores, sources, progress);
            const bool has_others = std::any_of(wanted.exports.begin(), wanted.exports.end(),
                                                [](const std::string& option) { return option != shaftExport; });
            if (has_others) {
                const Notes remarks = remarksOf(outcome, isSolidWanted(wanted));
                outcome.notes.insert(outcome.notes.end(), remarks.begin(), remarks.end());
            }
            return outcomeOf(std::make_shared<const RecognizeOutcome>(std::move(outcome)));
        };
        return made;
    }();
    return task;
}

}  // namespace lathelier::cad
