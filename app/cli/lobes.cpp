// lobes [FRF]: the limiting depth of cut over the spindle speed.
#include "engine/stability/lobes.h"

#include <nlohmann/json.hpp>

#include "app/cli/frf_source.h"
#include "app/cli/shafts.h"
#include "app/cli/verbs.h"
#include "engine/core/core_codes.h"
#include "engine/io/frf/frf_reader.h"
#include "engine/report/plain_text.h"
#include "engine/stability/modes.h"
#include "engine/stability/operating_point.h"
#include "engine/stability/pass/lobes_over_pass.h"
#include "engine/stability/stability_quantities.h"
#include "engine/stability/stability_report.h"

namespace lathelier::cli {
namespace {

std::vector<Option> lobesOptions()
{
    std::vector<Option> options = optionsOf<stability::LobeParameters>();
    for (Option& option : optionsOf<stability::PointParameters>()) options.push_back(std::move(option));
    for (Option& option : optionsOf<stability::PassParameters>()) options.push_back(std::move(option));
    for (Option& option : frfSourceOptions()) options.push_back(std::move(option));
    return options;
}

/// A pass requires a shaft.
void checkPass(const Request& request, const stability::PassParameters& pass)
{
    if (pass.isAsked() && wordOf(request, "shaft").empty())
        throw Error(
            errors::valueNotUnderstood,
            {{"parameter", "shaft"}, {"found", Value()}, {"expected", LT_TEXT("Engine", "the shaft of a pass")}});
}

std::shared_ptr<const stability::PassResult> passOf(const Request& request, const stability::PassParameters& pass,
                                                    const stability::LobeResult& lobes, io::InputFiles& inputs,
                                                    const Progress& progress)
{
    if (!pass.isAsked()) return nullptr;
    Answer ignoredAnswer;  // already noted when the source was read
    const Shaft shaft = readShaft(wordOf(request, "shaft"), request, inputs, progress.part(0, 0), ignoredAnswer);
    const auto spindle = readSpindle(request, inputs, progress.part(0, 0), ignoredAnswer);
    stability::LobeParameters parameters = lobes.parameters;
    parameters.speed_rpm = {lobes.speed_rpm};
    return std::make_shared<const stability::PassResult>(lobesOverPass(
        shaft, pass, fromValues<receptance::ReceptanceParameters>(request.parameters), spindle, parameters, progress));
}

void runLobes(const Request& request, io::InputFiles& inputs, const Progress& progress, Answer& answer)
{
    const auto parameters = fromValues<stability::LobeParameters>(request.parameters);
    const auto pass_parameters = fromValues<stability::PassParameters>(request.parameters);
    const auto point = operatingPointOf(fromValues<stability::PointParameters>(request.parameters));
    checkPass(request, pass_parameters);
    const double highest =
        parameters.speed_rpm.empty() ? stability::usualHighestSpeed_rpm : parameters.speed_rpm.front().to;
    const auto source =
        std::make_shared<const FrfSource>(frfSource(request, highest, inputs, progress.part(0, 0.3), answer));
    const auto result =
        std::make_shared<stability::LobeResult>(findLobes(source->frf, parameters, progress.part(0.3, 0.6)));
    const auto pass = passOf(request, pass_parameters, *result, inputs, progress.part(0.6, 1));
    answerWith(
        answer, result,
        [point, pass](const auto& found) {
            Json json = toJson(found);
            if (point) json["operating_point"] = pointJson(found, *point);
            if (pass) json["pass"] = passJson(*pass);
            return json;
        },
        [source, point, pass](const auto& found) {
            report::Document document = lobesReport(found, source->frf, nullptr, source->used, {}, point);
            if (pass) document.sections.insert(document.sections.begin() + 2, passSection(*pass));
            return document;
        },
        [point](const auto& found) {
            report::Section section = lobesSummary(found);
            if (point) section.blocks.push_back(pointTable(found, *point));
            return report::toPlainText(section);
        });
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
