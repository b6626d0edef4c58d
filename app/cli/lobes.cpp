// lobes [FRF]: the limiting depth of cut over the spindle speed.
#include "engine/stability/lobes.h"

#include <nlohmann/json.hpp>

#include "app/cli/frf_source.h"
#include "app/cli/verbs.h"
#include "engine/io/frf/frf_reader.h"
#include "engine/report/plain_text.h"
#include "engine/stability/modes.h"
#include "engine/stability/stability_quantities.h"
#include "engine/stability/stability_report.h"

namespace lathelier::cli {
namespace {

std::vector<Option> lobesOptions()
{
    std::vector<Option> options = optionsOf<stability::LobeParameters>();
    for (Option& option : frfSourceOptions()) options.push_back(std::move(option));
    return options;
}

void runLobes(const Request& request, io::InputFiles& inputs, const Progress& progress, Answer& answer)
{
    const auto parameters = fromValues<stability::LobeParameters>(request.parameters);
    const double highest =
        parameters.speed_rpm.empty() ? stability::usualHighestSpeed_rpm : parameters.speed_rpm.front().to;
    const auto source =
        std::make_shared<const FrfSource>(frfSource(request, highest, inputs, progress.part(0, 0.5), answer));
    const auto result =
        std::make_shared<stability::LobeResult>(findLobes(source->frf, parameters, progress.part(0.5, 1)));
    answerWith(
        answer, result, [](const auto& found) { return toJson(found); },
        [source](const auto& found) { return lobesReport(found, source->frf, nullptr, source->used); },
        [](const auto& found) { return report::toPlainText(lobesSummary(found)); });
}

}  // namespace

Verb lobesVerb()
{
    return {
        "lobes",
        "Stability lobes: the limiting depth of cut over the spindle speed.",
        {{"FRF", "A receptance of the point that is cut (UFF, CSV, MAT); or --mode, or --shaft.", false, false, true}},
        lobesOptions(),
        {&io::frfFiles()},
        {},
        true,
        runLobes};
}

}  // namespace lathelier::cli
