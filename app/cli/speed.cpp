// speed [FRF]: a spindle speed without chatter in place of a selected one.
#include <nlohmann/json.hpp>

#include "app/cli/frf_source.h"
#include "app/cli/verbs.h"
#include "engine/io/frf/frf_reader.h"
#include "engine/report/plain_text.h"
#include "engine/stability/modes.h"
#include "engine/stability/speed_choice.h"
#include "engine/stability/stability_quantities.h"
#include "engine/stability/stability_report.h"

namespace lathelier::cli {
namespace {

std::vector<Option> speedOptions()
{
    std::vector<Option> options = optionsOf<stability::SpeedParameters>();
    for (Option& option : frfSourceOptions()) options.push_back(std::move(option));
    return options;
}

void runSpeed(const Request& request, io::InputFiles& inputs, const Progress& progress, Answer& answer)
{
    const auto parameters = fromValues<stability::SpeedParameters>(request.parameters);
    const double highest = std::max(stability::usualHighestSpeed_rpm, parameters.speed_rpm.value_or(0));
    const auto source =
        std::make_shared<const FrfSource>(frfSource(request, highest, inputs, progress.part(0, 0.8), answer));
    const auto result = std::make_shared<stability::SpeedResult>(chooseSpeed(source->frf, parameters));
    answerWith(
        answer, result, [](const auto& found) { return nestedJson(describedValues(found)); },
        [source](const auto& found) { return speedReport(found, source->frf, source->used); },
        [](const auto& found) { return report::toPlainText(speedSummary(found)); });
    progress.report(1);
}

}  // namespace

Verb speedVerb()
{
    return {
        "speed",
        "Recommend a spindle speed without chatter in place of the selected one.",
        {{"FRF", "A receptance of the point that is cut (UFF, CSV, MAT); or --mode, or --shaft.", false, false, true}},
        speedOptions(),
        {&io::frfFiles()},
        {},
        true,
        runSpeed};
}

}  // namespace lathelier::cli
