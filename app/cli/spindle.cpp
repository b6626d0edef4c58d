// spindle MEASUREMENTS: the receptance of a spindle by inverse coupling from tap tests on several rods.
#include <filesystem>
#include <nlohmann/json.hpp>

#include "app/cli/verbs.h"
#include "engine/io/file.h"
#include "engine/io/frf/frf_reader.h"
#include "engine/receptance/receptance_report.h"
#include "engine/receptance/spindle_file.h"
#include "engine/report/plain_text.h"

namespace lathelier::cli {
namespace {

constexpr const char* outputOption = "--output";

receptance::MeasurementFile readMeasurements(const std::string& path, io::InputFiles& inputs, Answer& answer)
{
    try {
        return receptance::readMeasurements(std::string(inputs.open(path)), answer.notes);
    } catch (Error& error) {
        throw error.with("path", path);
    }
}

/// A path in a file is relative to that file.
std::string besideOf(const std::string& path, const std::string& other)
{
    return (std::filesystem::path(path).parent_path() / other).string();
}

void runSpindle(const Request& request, io::InputFiles& inputs, const Progress& progress, Answer& answer)
{
    const std::string& path = request.operands.at(0);
    const receptance::MeasurementFile file = readMeasurements(path, inputs, answer);
    const std::string responses = besideOf(path, file.frf);
    const Progress reading = progress.part(0, 0.2, LT_TEXT("Engine", "Reading"));
    const io::FrfFile measured =
        io::readFrf(responses, inputs.open(responses, reading), fromValues<io::ImportOptions>(request.parameters),
                    fromValues<io::FrfOptions>(request.parameters), reading);
    answer.notes.insert(answer.notes.end(), measured.notes.begin(), measured.notes.end());
    std::vector<receptance::NodeFrf> frfs;
    for (const io::MeasuredFrf& one : measured.frfs) frfs.push_back({one.response_node, one.reference_node, one.frf});
    const auto result = std::make_shared<receptance::SpindleIdentification>(receptance::identifySpindle(
        measurementsOf(file, frfs), fromValues<receptance::IdentificationParameters>(request.parameters),
        progress.part(0.2, 1, LT_TEXT("Engine", "Identifying"))));
    answerWith(
        answer, result,
        [](const auto& found) {
            Json json;
            json["frequency_hz"] = found.frequency_hz;
            json["condition"] = found.condition;
            json["residual_rms_percent"] = found.residual_rms_percent;
            json["hold_out_rms_percent"] = found.hold_out_rms_percent ? Json(*found.hold_out_rms_percent) : Json();
            json["frfs"] = found.frfs;
            return json;
        },
        [](const auto& found) { return spindleReport(found); },
        [](const auto& found) { return report::toPlainText(spindleSummary(found)); });
    if (const auto output = request.outputs.find(outputOption); output != request.outputs.end())
        io::writeFile(output->second, receptance::spindleText(result->spindle));
}

}  // namespace

Verb spindleVerb()
{
    return {"spindle",
            "Identify the receptance of a spindle from tap tests on rods (inverse coupling).",
            {{"MEASUREMENTS", "Rods, points and the file of frequency responses, as JSON."}},
            optionsOf<receptance::IdentificationParameters>(),
            {&io::frfFiles()},
            {{outputOption, "Write the spindle as SPINDLE.json."}},
            true,
            runSpindle};
}

}  // namespace lathelier::cli
