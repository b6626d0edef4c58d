// spindle MEASUREMENTS: the receptance of a spindle by inverse coupling from tap tests on several rods.
#include <nlohmann/json.hpp>

#include "app/cli/verbs.h"
#include "engine/io/file.h"
#include "engine/io/frf/frf_reader.h"
#include "engine/io/json/json_locate.h"
#include "engine/receptance/receptance_quantities.h"
#include "engine/receptance/receptance_report.h"
#include "engine/receptance/spindle_file.h"
#include "engine/receptance/spindle_kind.h"
#include "engine/report/plain_text.h"

namespace lathelier::cli {
namespace {

constexpr const char* outputOption = "--output";

/// Calls `work`; an error of a rod or of a point on it (from 1) gets its place in the file.
template <class Work>
auto naming(const std::string& path, Work work)
{
    try {
        return work();
    } catch (Error& error) {
        if (error.code().kind != ErrorKind::InputRejected) throw;
        io::JsonPath where{"rods"};
        for (const auto& [name, list] : {std::pair("rod", ""), std::pair("point", "points")}) {
            const Value* const number = find(error.values(), name);
            if (!number) break;
            if (*list != '\0') where.emplace_back(list);
            where.push_back(std::to_string(std::get<std::int64_t>(*number) - 1));
        }
        if (where.size() > 1) io::locateInFile(error, path, where);
        throw;
    }
}

void runSpindle(const Request& request, io::InputFiles& inputs, const Progress& progress, Answer& answer)
{
    const std::string& path = request.operands.at(0);
    const Progress reading = progress.part(0, 0.2, LT_TEXT("Engine", "Reading"));
    const receptance::TapTests tests =
        receptance::loadTapTests({path, inputs.open(path, reading), request.parameters, inputs, reading});
    answer.notes = tests.notes;
    const auto result = std::make_shared<receptance::SpindleIdentification>(naming(path, [&] {
        return receptance::identifySpindle(tests.measurements,
                                           fromValues<receptance::IdentificationParameters>(request.parameters),
                                           progress.part(0.2, 1, LT_TEXT("Engine", "Identifying")));
    }));
    answerWith(
        answer, result, [](const auto& found) { return nestedJson(describedValues(found)); },
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
