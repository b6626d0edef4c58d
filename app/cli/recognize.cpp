// recognize SCAN: the table of a turned part, its shaft, drawing and CAD.
#include <nlohmann/json.hpp>

#include "app/cli/scans.h"
#include "app/cli/shaft_outputs.h"
#include "app/cli/verbs.h"
#include "engine/cad/steps_view.h"
#include "engine/features/recognition.h"
#include "engine/features/recognition_report.h"
#include "engine/features/recognized_rows.h"
#include "engine/features/snap.h"
#include "engine/report/plain_text.h"

namespace lathelier::cli {
namespace {

/// Why the shaft is not complete.
Text missingOf(const features::Recognition& result)
{
    if (!result.gaps.empty()) return LT_TEXT("Engine", "there is a gap in the data");
    if (!result.length_mm) return LT_TEXT("Engine", "an end is not seen; state the length to confirm it");
    return {};
}

/// The published table: of that method where it was asked for, else of the rows.
std::vector<ShaftStep> stepsForReport(const features::Recognition& result)
{
    if (!result.paper_steps.empty()) return result.paper_steps;
    return cad::stepsOf(result.shaft);
}

void runRecognize(const Request& request, io::InputFiles& inputs, const Progress& progress, Answer& answer)
{
    const auto parameters = fromValues<features::RecognitionParameters>(request.parameters);
    const io::ScanFile file =
        readScan(request.operands.at(0), request, inputs, progress.part(0, 0.2, LT_TEXT("Engine", "Reading")), answer);
    const auto result = std::make_shared<features::Recognition>(
        features::recognize(file.scan, parameters, progress.part(0.2, 0.9, LT_TEXT("Engine", "Recognising"))));
    result->shaft.name = request.operands.at(0).substr(request.operands.at(0).find_last_of('/') + 1);
    answerWith(
        answer, result,
        [](const auto& found) {
            Json json = features::toJson(found);
            const bool published = !found.paper_steps.empty();
            const bool applied = found.parameters.snap == features::Snap::Apply && !published;
            json[published ? "robust_steps" : "steps"] = cad::stepsJson(applied ? found.shaft : measuredShaft(found));
            return json;
        },
        [](const auto& found) { return features::recognitionReport(found, stepsForReport(found), {}); },
        [](const auto& found) { return report::toPlainText(features::recognitionSummary(found)); });
    ShaftToWrite asked{result->shaft, result->complete, missingOf(*result),
                       parameters.length_of_chucked_mm.value_or(0)};
    asked.measured = true;
    for (const features::RecognizedRow& row : result->segments) asked.uncertainties.push_back(row.uncertainty);
    for (const auto& bore : result->bores)
        for (auto& own = asked.bore_uncertainties.emplace_back(); const features::RecognizedRow& row : bore)
            own.push_back(row.uncertainty);
    const std::vector<InputFile> read = inputs.list();
    if (!read.empty()) asked.scan = read.front();
    writeShaftOutputs(request, asked, progress.part(0.9, 1, LT_TEXT("Engine", "Writing")), answer);
}

}  // namespace

Verb recognizeVerb()
{
    std::vector<Option> options = optionsOf<features::RecognitionParameters>();
    for (Option& option : cadOptions()) options.push_back(std::move(option));
    return {"recognize",
            "Recognize a turned part in its scan: diameters, lengths, chamfers, fillets, their uncertainties.",
            {{"SCAN", "The part: a point cloud or mesh."}},
            options,
            {&io::scanFiles()},
            shaftOutputs(),
            true,
            runRecognize};
}

}  // namespace lathelier::cli
