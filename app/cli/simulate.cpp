// simulate [FRF]: a cut in time, with loss of contact.
#include <nlohmann/json.hpp>

#include "app/cli/frf_source.h"
#include "app/cli/mode_source.h"
#include "app/cli/verbs.h"
#include "engine/io/file.h"
#include "engine/io/frf/frf_reader.h"
#include "engine/report/plain_text.h"
#include "engine/stability/simulation/simulation_files.h"
#include "engine/stability/simulation/simulation_report.h"

namespace lathelier::cli {
namespace {

constexpr const char* soundOption = "--wav";

std::vector<Option> simulateOptions()
{
    std::vector<Option> options = optionsOf<stability::SimulationParameters>();
    for (Option& option : frfSourceOptions()) options.push_back(std::move(option));
    return options;
}

void runSimulate(const Request& request, io::InputFiles& inputs, const Progress& progress, Answer& answer)
{
    const ModeSource source = modeSource(request, inputs, progress.part(0, 0.1), answer);
    const auto result = std::make_shared<stability::SimulationResult>(
        simulate(source.modes, fromValues<stability::SimulationParameters>(request.parameters),
                 progress.part(0.1, 1, LT_TEXT("Engine", "Simulating"))));
    answerWith(
        answer, result, [](const auto& found) { return nestedJson(describedValues(found)); },
        [used = source.used](const auto& found) {
            report::Document document = simulationReport(found);
            std::get<report::Answer>(document.sections.front().blocks.front()).used = used;
            return document;
        },
        [](const auto& found) { return report::toPlainText(simulationSummary(found)); });
    if (const auto table = request.outputs.find(tableOption); table != request.outputs.end())
        io::writeFile(table->second, [&](const io::Append& append) {
            writeWaveform(*result, [&](std::string_view step) {
                progress.check();
                append(step);
            });
        });
    if (const auto sound = request.outputs.find(soundOption); sound != request.outputs.end())
        io::writeFile(sound->second, soundOf(*result).bytes);
}

}  // namespace

Verb simulateVerb()
{
    return {"simulate",
            "Simulate a cut in time, with loss of contact: does it chatter?",
            {{"FRF", "A frequency response; modes are fitted to it.", false, false, true}},
            simulateOptions(),
            {&io::frfFiles()},
            {{tableOption, "Write the waveform as FILE.csv."},
             {soundOption, "Write the vibration as sound, FILE.wav (16 bit, mono, 44.1 kHz)."}},
            true,
            runSimulate};
}

}  // namespace lathelier::cli
