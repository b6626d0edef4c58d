#include "engine/form/task/cylindricity_task.h"

#include <nlohmann/json.hpp>

#include "engine/core/json.h"
#include "engine/form/cylinder/cylindricity_plots.h"
#include "engine/form/cylinder/cylindricity_quantities.h"
#include "engine/form/cylinder/cylindricity_report.h"
#include "engine/io/file.h"
#include "engine/report/chart_csv.h"
#include "engine/task/memo.h"

namespace lathelier::form {
namespace {

struct CylinderWithSurface {
    CylindricityResult result;
    CylinderSurface surface;
};

struct FittedCylinders : Memo<CylinderWithSurface> {};

/// What the fit depends on: sameButVerdict().
std::string keyOf(const Loaded<io::ScanFile>& points, const project::Source& source, CylindricityParameters parameters)
{
    CylindricityParameters fitted;
    fitted.probe_uncertainty_um = parameters.probe_uncertainty_um;
    return points.digest() + toJson(source.import).dump() + toJson(toValues(fitted)).dump();
}

report::Document reportOf(const CylindricityOutcome& outcome, const Language& language)
{
    CylindricityResult result = *outcome.result;
    result.notes = outcome.notes;
    return cylindricityReport(result, outcome.surface.get(), outcome.sources.inputs, language);
}

}  // namespace

CylindricityOutcome answerCylindricity(const project::PanelState& state, Stores& stores, task::Sources& sources,
                                       const Progress& progress)
{
    const auto parameters = fromValues<CylindricityParameters>(state.parameters);
    CylindricityOutcome outcome;
    outcome.points = task::takeFile<io::ScanInput>(state, pointsRole, stores,
                                                   progress.part(0, 0.3, LT_TEXT("Engine", "Reading")), sources);
    const auto fitted = stores.of<FittedCylinders>()->find(
        keyOf(*outcome.points, state.inputs.at(pointsRole), parameters),
        progress.part(0.3, 1, LT_TEXT("Engine", "Fitting cylinders")), [&](const Progress& part) {
            CylinderWithSurface made{cylindricity(outcome.scan().points_mm, parameters, part.part(0, 0.95)), {}};
            made.surface =
                surfaceAbout(made.result.MZCY, outcome.scan().points_mm, made.result.sections, part.part(0.95, 1));
            return made;
        });
    CylindricityResult result = fitted->result;
    judge(result, parameters);
    outcome.result = std::make_shared<const CylindricityResult>(std::move(result));
    outcome.surface = {fitted, &fitted->surface};
    outcome.record(state, sources, outcome.result->notes);
    return outcome;
}

task::Outcome outcomeOf(const std::shared_ptr<const CylindricityOutcome>& outcome)
{
    task::Outcome all;
    all.result = outcome;
    all.notes = outcome->notes;
    all.verdict = outcome->result->verdict;
    all.json = [outcome] { return nestedJson(describedValues(*outcome->result)); };
    all.answer = [outcome](const Language&) { return answer(*outcome->result); };
    all.summary = [outcome](const Language&) { return cylindricitySummary(*outcome->result); };
    all.report = [outcome](const Language& language) { return reportOf(*outcome, language); };
    all.writers[alongAxisExport] = [outcome](const std::string& path, const Language&, const Progress&) {
        report::Plot plot = radiusAlongAxis(*outcome->surface, outcome->result->parameters);
        for (report::Curve& curve : centresAlongAxis(*outcome->surface).curves) plot.curves.push_back(std::move(curve));
        io::writeFile(path, report::toCsv(plot));
    };
    return settled(cylindricityTask(), std::move(all), outcome->understanding);
}

const task::Task& cylindricityTask()
{
    static const task::Task task = [] {
        task::Task made;
        made.key = "cylindricity";
        made.title = LT_TEXT("Engine", "Cylindricity");
        made.summary = "Cylindricity of points: least-squares and minimum-zone cylinder, axis straightness, verdict.";
        made.question = "roundness";
        made.inputs = {task::input<io::ScanInput>(
            pointsRole, "", LT_TEXT("Engine", "Points"),
            LT_TEXT("Engine", "Points of one cylindrical surface: a scan, or sections measured one above the other."))};
        made.inputs.front().operand = "FILE";
        made.inputs.front().is_of_part = true;
        task::askFor<CylindricityParameters>(made);
        made.exports = {{alongAxisExport, "Write local radius and axis along the length as FILE.csv.",
                         LT_TEXT("Engine", "Local radius and axis along the length (CSV)…"),
                         LT_TEXT("Engine", "Table (*.csv)"), "csv"}};
        made.run = [](const project::PanelState& state, const task::Wanted&, Stores& stores, task::Sources& sources,
                      const Progress& progress) {
            return outcomeOf(
                std::make_shared<const CylindricityOutcome>(answerCylindricity(state, stores, sources, progress)));
        };
        return made;
    }();
    return task;
}

}  // namespace lathelier::form
