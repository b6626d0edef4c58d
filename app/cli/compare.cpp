// compare REFERENCE COPY: how far the copy is from the original, where, and how sure that is.
#include "engine/registration/compare.h"

#include <nlohmann/json.hpp>

#include "app/cli/scans.h"
#include "app/cli/verbs.h"
#include "engine/core/core_codes.h"
#include "engine/registration/compare_quantities.h"
#include "engine/registration/compare_report.h"
#include "engine/registration/deviation_file.h"
#include "engine/registration/verdict/zone_limits.h"
#include "engine/report/plain_text.h"

namespace lathelier::cli {
namespace {

constexpr const char* deviationsOption = "--deviations";
constexpr const char* zonesKey = "zones";

/// The options of the parameters; zones come in a file.
std::vector<Option> compareOptions()
{
    std::vector<Option> options = optionsOf<registration::CompareParameters>();
    for (Option& option : options) {
        if (option.info.key != zonesKey) continue;
        option.info.kind = FieldInfo::Kind::Word;
        option.info.columns.clear();
        option.info.optional = true;
        option.info.help = LT_TEXT("Engine", "Limits of their own along the axis, from FILE.json.");
        option.standard = {};
    }
    return options;
}

/// The parameters of a request, its zones read.
registration::CompareParameters parametersOf(const Request& request, io::InputFiles& inputs, const Progress& progress,
                                             Answer& answer)
{
    Values values = request.parameters;
    std::erase_if(values, [](const auto& value) { return value.first == zonesKey; });
    auto parameters = fromValues<registration::CompareParameters>(values);
    const Value* const given = find(request.parameters, zonesKey);
    const auto* const path = given ? std::get_if<std::string>(given) : nullptr;
    if (!path) return parameters;
    try {
        parameters.zones = registration::readZones(std::string(inputs.open(*path, progress)), answer.notes);
    } catch (Error& error) {
        error.with("path", *path);
        throw;
    }
    return parameters;
}

void runCompare(const Request& request, io::InputFiles& inputs, const Progress& progress, Answer& answer)
{
    const auto deviations = request.outputs.find(deviationsOption);
    const bool wanted = deviations != request.outputs.end();
    if (wanted && !registration::isDeviationFile(deviations->second))  // said before the work, not after it
        throw Error(errors::valueNotUnderstood, {{"parameter", deviationsOption},
                                                 {"found", deviations->second},
                                                 {"expected", LT_TEXT("Engine", "a name in .ply or .csv")}});
    const registration::CompareParameters parameters = parametersOf(request, inputs, progress.part(0, 0.01), answer);
    const Text reading = LT_TEXT("Engine", "Reading");
    const io::ScanFile reference =
        readScan(request.operands.at(0), request, inputs, progress.part(0, 0.15, reading), answer);
    const io::ScanFile copy =
        readScan(request.operands.at(1), request, inputs, progress.part(0.15, 0.3, reading), answer);
    const auto result = std::make_shared<registration::CompareResult>();
    try {
        *result = compare(reference.scan, copy.scan, parameters,
                          progress.part(0.3, wanted ? 0.9 : 1, LT_TEXT("Engine", "Comparing")),
                          request.in_full ? registration::CompareDetail::Full : registration::CompareDetail::Summary);
    } catch (Error& error) {  // the engine names the role of the scan at fault; here is its file
        const Value* const role = find(error.values(), "role");
        const auto* const name = role ? std::get_if<std::string>(role) : nullptr;
        if (name) error.with("path", request.operands.at(*name == "copy" ? 1 : 0));
        throw;
    }
    answerWith(
        answer, result, [](const auto& found) { return toJson(found); },
        [](const auto& found) { return compareReport(found, {}); },
        [](const auto& found) { return report::toPlainText(compareSummary(found)); });
    if (wanted)
        writeDeviations(deviations->second, copy.scan, *result,
                        progress.part(0.9, 1, LT_TEXT("Engine", "Writing deviations")));
}

}  // namespace

Verb compareVerb()
{
    return {"compare",
            "Compare a copy with its original: alignment, signed surface deviation, verdict.",
            {{"REFERENCE", "The original: a point cloud or mesh."}, {"COPY", "The copy: a point cloud or mesh."}},
            compareOptions(),
            {&io::scanFiles()},
            {{deviationsOption, "Write every point of the copy with its deviation (FILE.ply or FILE.csv)."}},
            true,
            runCompare};
}

}  // namespace lathelier::cli
