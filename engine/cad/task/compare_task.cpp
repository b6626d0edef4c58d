#include "engine/cad/task/compare_task.h"

#include <nlohmann/json.hpp>

#include "engine/cad/task/compare_copies.h"
#include "engine/core/core_codes.h"
#include "engine/core/json.h"
#include "engine/registration/compare_quantities.h"
#include "engine/registration/compare_report.h"
#include "engine/registration/deviation_file.h"
#include "engine/registration/verdict/verdict.h"
#include "engine/registration/verdict/zones_input.h"
#include "engine/task/memo.h"

namespace lathelier::cad {
namespace {

/// A copy compared with its reference.
struct Compared {
    std::shared_ptr<const features::ShaftComparison> sizes;     ///< null: the reference is a scan
    std::shared_ptr<const registration::CompareResult> result;  ///< of a drawing the surface of `sizes`

    explicit Compared(features::ShaftComparison found)
        : sizes(std::make_shared<const features::ShaftComparison>(std::move(found))), result(sizes, &sizes->surface)
    {
    }
    explicit Compared(registration::CompareResult found)
        : result(std::make_shared<const registration::CompareResult>(std::move(found)))
    {
    }
};

/// The results have the size of the scans: few are kept.
struct Comparisons : Memo<Compared> {
    Comparisons() : Memo(2) {}
};

/// What decides on the comparison but for the verdict. The sizes of a drawing are judged while they are compared.
std::string keyOf(const CompareOutcome& outcome, registration::CompareDetail detail)
{
    const registration::CompareParameters& asked = outcome.question.compare;
    registration::CompareParameters fitted = fittedOf(asked);
    if (outcome.reference.drawn) {
        fitted.decision = asked.decision;
        fitted.scanner_accuracy_mm = asked.scanner_accuracy_mm;
    }
    return outcome.scansKey() + toJson(toValues(fitted)).dump() +
           (detail == registration::CompareDetail::Full ? "full" : "summary");
}

Compared computed(const CompareOutcome& outcome, registration::CompareDetail detail, const Progress& progress)
{
    const registration::CompareParameters& asked = outcome.question.compare;
    if (const auto& drawn = outcome.reference.drawn)
        return Compared(features::compareWithShaft(drawn->shaft, outcome.copyScan(), asked, progress, detail));
    return Compared(
        registration::compare(outcome.reference.scan->file.scan, outcome.copyScan(), asked, progress, detail));
}

/// With the limits and rules that are asked for.
Compared judged(const Compared& found, const registration::CompareParameters& asked, const Progress& progress)
{
    if (toValues(found.result->parameters) == toValues(asked)) return found;
    if (found.sizes) {
        features::ShaftComparison again = *found.sizes;
        judgeSurface(again, asked, progress);
        return Compared(std::move(again));
    }
    registration::CompareResult again = *found.result;
    judge(again, asked, progress);
    return Compared(std::move(again));
}

/// A file of zones rules over the table.
CompareQuestion questionOf(const project::PanelState& state, Stores& stores, task::Sources& sources,
                           const Progress& progress)
{
    auto question = fromValues<CompareQuestion>(state.parameters);
    if (auto zones = task::take<registration::ZonesInput>(state, zonesRole, stores, progress, sources))
        question.compare.zones = *std::move(zones);
    return question;
}

Json jsonOf(const CompareOutcome& outcome)
{
    Json json = outcome.sizes ? features::toJson(*outcome.sizes) : registration::toJson(*outcome.result);
    if (outcome.copies.size() > 1) json["copies"] = registration::toJson(outcome.copies);
    return json;
}

report::Document reportOf(const CompareOutcome& outcome, const Language& language)
{
    report::Document document;
    if (outcome.sizes) {
        features::ShaftComparison all = *outcome.sizes;
        all.surface.notes = outcome.notes;  // those of the files as well
        document = shaftReport(all, outcome.sources.inputs, language, outcome.pictures);
    } else {
        registration::CompareResult result = *outcome.result;
        result.notes = outcome.notes;
        document = compareReport(result, outcome.sources.inputs, language, outcome.pictures);
    }
    if (outcome.copies.size() > 1)
        document.sections.insert(document.sections.begin() + 1,
                                 report::Section{LT_TEXT("Engine", "Copies of the same original"),
                                                 {copiesTrend(outcome.copies, outcome.question.compare, language),
                                                  copiesTable(outcome.copies, language)}});
    return document;
}

report::Section summaryOf(const CompareOutcome& outcome, const Language& language)
{
    if (!outcome.sizes) return compareSummary(*outcome.result, language);
    report::Section summary = surfaceSummary(*outcome.sizes, language);
    for (report::Block& block : sizesSection(*outcome.sizes).blocks) summary.blocks.push_back(std::move(block));
    return summary;
}

void checkName(const std::string& path)
{
    if (registration::isDeviationFile(path)) return;
    throw Error(errors::valueNotUnderstood, {{"parameter", std::string("--") + deviationsExport},
                                             {"found", path},
                                             {"expected", LT_TEXT("Engine", "a name in .ply or .csv")}});
}

task::Outcome runCompare(const project::PanelState& state, const task::Wanted& wanted, Stores& stores,
                         task::Sources& sources, const Progress& progress)
{
    const bool is_alone = project::keysOf(state, copiesRole).empty();
    const auto detail = wanted.in_full ? registration::CompareDetail::Full : registration::CompareDetail::Summary;
    CompareOutcome outcome = answerCompare(state, detail, stores, sources, progress.part(0, is_alone ? 1 : 0.4));
    if (!is_alone) {
        addCopies(outcome, compareCopies(outcome, stores, progress.part(0.4, 1)));
        sources = outcome.sources;
    }
    return outcomeOf(std::make_shared<const CompareOutcome>(std::move(outcome)));
}

}  // namespace

std::string CompareOutcome::scansKey() const
{
    return reference.key + copy->digest() + toJson(asked.inputs.at(copyRole).import).dump();
}

CompareOutcome answerCompare(const project::PanelState& state, registration::CompareDetail detail, Stores& stores,
                             task::Sources& sources, const Progress& progress)
{
    CompareOutcome outcome;
    outcome.asked = state;
    outcome.question = questionOf(state, stores, sources, progress.part(0, 0.01));
    const project::PanelState read = withUnits(state, outcome.question);
    outcome.reference =
        takeReference(read, stores, sources, progress.part(0.01, 0.2, LT_TEXT("Engine", "Reading the reference")));
    outcome.original = outcome.reference.scan;
    outcome.copy = task::takeFile<io::ScanInput>(
        read, copyRole, stores, progress.part(0.2, 0.4, LT_TEXT("Engine", "Reading the copy")), sources);
    const Progress comparing = progress.part(0.4, 1, LT_TEXT("Engine", "Comparing"));
    try {
        const auto found =
            stores.of<Comparisons>()->find(keyOf(outcome, detail), comparing.part(0, 0.99),
                                           [&](const Progress& part) { return computed(outcome, detail, part); });
        const Compared compared = judged(*found, outcome.question.compare, comparing.part(0.99, 1));
        outcome.sizes = compared.sizes;
        outcome.result = compared.result;
    } catch (Error& error) {
        explain(error, state, outcome.reference, outcome.copyScan(), sources.notes);
        throw;
    }
    outcome.record(state, sources, outcome.result->notes);
    progress.report(1);
    return outcome;
}

task::Outcome outcomeOf(const std::shared_ptr<const CompareOutcome>& outcome)
{
    task::Outcome all;
    all.result = outcome;
    all.notes = outcome->notes;
    all.stated = withStatedUnits(outcome->asked);
    all.verdict = outcome->sizes ? outcome->sizes->verdict : outcome->result->verdict;
    all.json = [outcome] { return jsonOf(*outcome); };
    all.answer = [outcome](const Language& language) {
        return outcome->sizes ? features::answer(*outcome->sizes, language)
                              : registration::answer(*outcome->result, language);
    };
    all.summary = [outcome](const Language& language) { return summaryOf(*outcome, language); };
    all.report = [outcome](const Language& language) { return reportOf(*outcome, language); };
    all.writers[deviationsExport] = [outcome](const std::string& path, const Language&, const Progress& progress) {
        writeDeviations(path, outcome->copyScan(), *outcome->result,
                        progress.part(0, 1, LT_TEXT("Engine", "Writing deviations")));
    };
    return settled(compareTask(), std::move(all), outcome->understanding);
}

const task::Task& compareTask()
{
    static const task::Task task = [] {
        task::Task made;
        made.key = "compare";
        made.title = LT_TEXT("Engine", "Compare");
        made.summary =
            "Compare a copy with its original or its drawing: alignment, signed surface deviation, sizes, verdict.";
        made.question = "copy";
        made.inputs = compareInputs();
        task::askFor<CompareQuestion>(made);
        made.exports = {{deviationsExport, "Write every point of the copy with its deviation (FILE.ply or FILE.csv).",
                         LT_TEXT("Engine", "Deviations of all points (PLY)…"), LT_TEXT("Engine", "Point cloud (*.ply)"),
                         "ply", false, checkName}};
        made.run = runCompare;
        return made;
    }();
    return task;
}

}  // namespace lathelier::cad
