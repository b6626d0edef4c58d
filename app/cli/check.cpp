// check PROGRAM --job JOB.json: any turning program against its drawing, its stock and the surrounding bodies.
#include <nlohmann/json.hpp>

#include "app/cli/jobs.h"
#include "app/cli/programs.h"
#include "app/cli/shafts.h"
#include "app/cli/verbs.h"
#include "engine/cam/check/check_report.h"
#include "engine/cam/check/correction_file.h"
#include "engine/cam/job_file.h"
#include "engine/core/core_codes.h"
#include "engine/gcode/program_kind.h"
#include "engine/io/shaft/shaft_kind.h"
#include "engine/report/plain_text.h"

namespace lathelier::cli {
namespace {

/// Files that options name.
struct CheckFiles {
    std::string job;         ///< path
    std::string shaft;       ///< path; empty: the one within the job
    std::string correction;  ///< path; empty: the program follows the drawing
    std::string before;      ///< path; empty: the second clamping starts from the bar
};

const std::vector<Field<CheckFiles>>& fieldsOf(const CheckFiles*)
{
    Label job{LT_TEXT("Engine", "Job"), LT_TEXT("Engine", "Stock, set-up, tools and cutting data, from JOB.json.")};
    job.required = true;
    static const std::vector<Field<CheckFiles>> all{
        field("job", &CheckFiles::job, job),
        field("shaft", &CheckFiles::shaft,
              Label{LT_TEXT("Engine", "Shaft"),
                    LT_TEXT("Engine", "The part, from FILE (SHAFT.json, STEP, CSV), instead of the one in the job.")}),
        field("correction", &CheckFiles::correction,
              Label{LT_TEXT("Engine", "Correction"),
                    LT_TEXT("Engine",
                            "What the program was corrected by: FILE that deflection --compensate wrote "
                            "with --json.")}),
        field("before", &CheckFiles::before,
              Label{LT_TEXT("Engine", "Program before"),
                    LT_TEXT("Engine", "The program of the first clamping, for --setup 2.")})};
    return all;
}

std::vector<Option> checkOptions()
{
    std::vector<Option> options = optionsOf<CheckFiles>();
    for (Option& option : optionsOf<cam::CheckParameters>()) options.push_back(std::move(option));
    return options;
}

cam::Job jobOfOption(const Request& request, io::InputFiles& inputs, const Progress& progress, Answer& answer)
{
    const std::string path = wordOf(request, "job");
    if (path.empty())
        throw Error(errors::valueNotUnderstood,
                    {{"parameter", "--job"}, {"found", ""}, {"expected", LT_TEXT("Engine", "a job (JOB.json)")}});
    return readJob(path, request, inputs, progress, answer);
}

cam::CheckInputs furtherInputs(const Request& request, io::InputFiles& inputs, const Progress& progress)
{
    cam::CheckInputs further;
    if (const std::string path = wordOf(request, "correction"); !path.empty()) {
        try {
            further.correction = cam::readCorrection(std::string(inputs.open(path, progress)));
        } catch (Error& error) {
            throw error.with("path", path);
        }
    }
    if (const std::string path = wordOf(request, "before"); !path.empty())
        further.before = std::string(inputs.open(path, progress));
    return further;
}

void runCheck(const Request& request, io::InputFiles& inputs, const Progress& progress, Answer& answer)
{
    const std::string& path = request.operands.front();
    const cam::Job job = jobOfOption(request, inputs, progress.part(0, 0.02), answer);
    const auto part = std::make_shared<Shaft>(
        partOf(job, wordOf(request, "shaft"), wordOf(request, "job"), inputs, progress.part(0.02, 0.05), answer));
    const cam::CheckInputs further = furtherInputs(request, inputs, progress.part(0.05, 0.08));
    const auto parameters = fromValues<cam::CheckParameters>(request.parameters);
    std::string text(inputs.open(path, progress));
    const auto result = std::make_shared<cam::CheckResult>();
    try {
        *result = cam::checkTurning(std::move(text), *part, job, parameters, further, progress.part(0.08, 1));
    } catch (Error& error) {
        throw error.with("path", path);
    }
    answerWith(
        answer, result, [](const auto& found) { return cam::toJson(found); },
        [part](const auto& found) { return cam::checkReport(found, *part); },
        [](const auto& found) { return report::toPlainText(cam::checkSummary(found)); });
    if (auto error = firstError(result->path, path)) answer.errors.push_back(*error);
}

}  // namespace

Verb checkVerb()
{
    return {"check",
            "Check a turning program against its drawing and its stock: what it cuts too deep, leaves and meets.",
            {{"PROGRAM", "An NC program (Fanuc, Haas, Sinumerik, LinuxCNC)."}},
            checkOptions(),
            {&gcode::programFiles(), &cam::jobFiles(), &io::shaftFiles()},
            {},
            true,
            runCheck};
}

}  // namespace lathelier::cli
