// trajectory RECORD...: from probe records to the image of the machined surface, its sections and the spindle's motion.
#include "engine/trajectory/trajectory.h"

#include <nlohmann/json.hpp>

#include "app/cli/filter_option.h"
#include "app/cli/records.h"
#include "app/cli/verbs.h"
#include "engine/report/plain_text.h"
#include "engine/trajectory/section_file.h"
#include "engine/trajectory/trajectory_quantities.h"
#include "engine/trajectory/trajectory_report.h"

namespace lathelier::cli {
namespace {

constexpr const char* imageOption = "--image-csv";

std::vector<Option> trajectoryOptions()
{
    std::vector<Option> options = optionsOf<trajectory::TrajectoryParameters>();
    options.insert(options.begin(), noFilterOption());
    return options;
}

void runTrajectory(const Request& request, io::InputFiles& inputs, const Progress& progress, Answer& answer)
{
    const auto parameters = fromValues<trajectory::TrajectoryParameters>(request.parameters);
    checkNoFilter(request, parameters.form);
    std::vector<io::ProbeFile> records;
    const auto count = static_cast<double>(request.operands.size());
    for (const std::string& path : request.operands) {
        const auto done = static_cast<double>(records.size());
        const Progress reading =
            progress.part(0.4 * done / count, 0.4 * (done + 1) / count, LT_TEXT("Engine", "Reading"));
        records.push_back(readRecord(path, request, inputs, reading, answer));
    }
    auto result = std::make_shared<trajectory::TrajectoryResult>(
        trajectory::trajectory(records, parameters, progress.part(0.4, 1)));
    answerWith(
        answer, result, [](const auto& found) { return toJson(found); },
        [](const auto& found) { return trajectory::trajectoryReport(found, {}); },
        [](const auto& found) { return report::toPlainText(trajectory::trajectorySummary(found)); });
    if (const auto table = request.outputs.find(tableOption); table != request.outputs.end())
        trajectory::writeSectionTable(table->second, *result);
    if (const auto image = request.outputs.find(imageOption); image != request.outputs.end())
        trajectory::writeImages(image->second, *result);
}

}  // namespace

Verb trajectoryVerb()
{
    return {"trajectory",
            "Evaluate probe records: trajectories, image of the surface, roundness, longitudinal section.",
            {{"RECORD", "A probe record (CSV or L-Graph .dat/.par), or one for each section.", true}},
            trajectoryOptions(),
            {&io::probeRecordFiles()},
            {{tableOption, "Write the table of the sections as FILE.csv."},
             {imageOption, "Write the images of the surface, point by point, as FILE.csv."}},
            true,
            runTrajectory};
}

}  // namespace lathelier::cli
