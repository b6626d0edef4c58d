// cylindricity FILE: how far a cloud of points is from a cylinder.
#include "engine/form/cylindricity.h"

#include <nlohmann/json.hpp>

#include "app/cli/scans.h"
#include "app/cli/verbs.h"
#include "engine/form/cylindricity_json.h"
#include "engine/form/roundness_report.h"
#include "engine/report/plain_text.h"

namespace lathelier::cli {
namespace {

void runCylindricity(const Request& request, InputFiles& inputs, const Progress& progress, Answer& answer)
{
    const ScanFile file =
        readScan(request.operands.at(0), request, inputs, progress.part(0, 0.3, LT_TEXT("Engine", "Reading")), answer);
    const auto result = std::make_shared<form::CylindricityResult>(
        cylindricity(file.scan.points_mm, fromValues<form::CylindricityParameters>(request.parameters),
                     progress.part(0.3, 1, LT_TEXT("Engine", "Fitting cylinders"))));
    answer.notes.insert(answer.notes.end(), result->notes.begin(), result->notes.end());
    result->notes = answer.notes;  // the report shows those of the file as well
    answer.json = [result] { return toJson(*result); };
    answer.report = [result] { return cylindricityReport(*result, {}); };
    if (result->verdict && *result->verdict != form::FormVerdict::Undecided)
        answer.pass = *result->verdict == form::FormVerdict::Pass;
    answer.summary = toPlainText(cylindricitySummary(*result));
}

}  // namespace

Verb cylindricityVerb()
{
    return {"cylindricity",
            "Cylindricity of points: least-squares and minimum-zone cylinder, axis straightness, verdict.",
            {{"FILE", "Points x, y, z of a cylindrical surface: a cloud, a mesh, or stacked sections."}},
            optionsOf<form::CylindricityParameters>(),
            optionsOf<ImportOptions>(),
            {},
            true,
            runCylindricity};
}

}  // namespace lathelier::cli
