// frf SHAFT: the frequency response of a shaft, free or on its spindle.
#include <nlohmann/json.hpp>

#include "app/cli/shafts.h"
#include "app/cli/verbs.h"
#include "engine/io/frf/frf_lines.h"
#include "engine/io/frf/frf_writer.h"
#include "engine/receptance/receptance_quantities.h"
#include "engine/receptance/receptance_report.h"
#include "engine/report/plain_text.h"

namespace lathelier::cli {
namespace {

constexpr const char* universalOption = "--uff";

void runFrf(const Request& request, io::InputFiles& inputs, const Progress& progress, Answer& answer)
{
    const auto parameters = fromValues<receptance::ReceptanceParameters>(request.parameters);
    const Shaft shaft = readShaft(request.operands.at(0), request, inputs, progress.part(0, 0.05), answer);
    const auto spindle = readSpindle(request, inputs, progress.part(0.05, 0.1), answer);
    const auto result =
        std::make_shared<receptance::ShaftReceptanceResult>(namingShaft(request.operands.at(0), shaft, [&] {
            return receptance::shaftReceptance(shaft, parameters, spindle,
                                               progress.part(0.1, 1, LT_TEXT("Engine", "Computing")));
        }));
    answerWith(
        answer, result, [](const auto& found) { return nestedJson(describedValues(found)); },
        [](const auto& found) { return frfReport(found); },
        [](const auto& found) { return report::toPlainText(frfSummary(found)); });
    if (request.outputs.empty()) return;
    io::MeasuredFrf response;
    response.frf = result->frf;
    io::dropUnusableLines(response.frf);  // a free shaft has no receptance at 0 Hz
    if (const auto table = request.outputs.find(tableOption); table != request.outputs.end())
        io::writeFrfCsv(table->second, response.frf);
    if (const auto universal = request.outputs.find(universalOption); universal != request.outputs.end())
        io::writeUff(universal->second, {&response, 1});
}

}  // namespace

Verb frfVerb()
{
    return {"frf",
            "Frequency response and natural frequencies of a shaft, free or on its spindle.",
            {{"SHAFT", "The shaft: SHAFT.json, or a stock file."}},
            shaftOptions(),
            {},
            {{tableOption, "Write the receptance as FILE.csv."},
             {universalOption, "Write the receptance as a universal file (58)."}},
            true,
            runFrf};
}

}  // namespace lathelier::cli
