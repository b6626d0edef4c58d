// cylindricity FILE: deviation of a cloud of points from a cylinder.
#include <nlohmann/json.hpp>

#include "app/cli/scans.h"
#include "app/cli/verbs.h"
#include "engine/form/cylinder/cylinder_surface.h"
#include "engine/form/cylinder/cylindricity_quantities.h"
#include "engine/form/cylinder/cylindricity_report.h"
#include "engine/report/plain_text.h"

namespace lathelier::cli {
namespace {

void runCylindricity(const Request& request, io::InputFiles& inputs, const Progress& progress, Answer& answer)
{
    io::ScanFile file =
        readScan(request.operands.at(0), request, inputs, progress.part(0, 0.3, LT_TEXT("Engine", "Reading")), answer);
    const auto result = std::make_shared<form::CylindricityResult>(
        cylindricity(file.scan.points_mm, fromValues<form::CylindricityParameters>(request.parameters),
                     progress.part(0.3, 1, LT_TEXT("Engine", "Fitting cylinders"))));
    answerWith(
        answer, result, [](const auto& found) { return nestedJson(describedValues(found)); },
        [points = std::move(file.scan.points_mm)](const auto& found) {
            const form::CylinderSurface surface = surfaceAbout(found.MZCY, points, found.sections);
            return cylindricityReport(found, &surface, {});
        },
        [](const auto& found) { return report::toPlainText(cylindricitySummary(found)); });
}

}  // namespace

Verb cylindricityVerb()
{
    return {"cylindricity",
            "Cylindricity of points: least-squares and minimum-zone cylinder, axis straightness, verdict.",
            {{"FILE", "Points x, y, z of a cylindrical surface: a cloud, a mesh, or stacked sections."}},
            optionsOf<form::CylindricityParameters>(),
            {&io::scanFiles()},
            {},
            true,
            runCylindricity};
}

}  // namespace lathelier::cli
