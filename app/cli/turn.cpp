// turn SHAFT --job JOB.json: a turning program from a part and a job, checked as written.
#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "app/cli/jobs.h"
#include "app/cli/shafts.h"
#include "app/cli/verbs.h"
#include "engine/cam/job_file.h"
#include "engine/cam/plan_files.h"
#include "engine/cam/plan_report.h"
#include "engine/io/shaft/shaft_kind.h"
#include "engine/receptance/spindle_kind.h"
#include "engine/report/plain_text.h"

namespace lathelier::cli {
namespace {

constexpr const char* programOption = "--out";
constexpr std::size_t shownDigits = 12;

/// Files that options name.
struct TurnFiles {
    std::string job;               ///< path; empty: the operand is the job
    std::string post = "fanuc_a";  ///< name of a post that is built in, or path
    std::string spindle;           ///< path; empty: no speeds from dynamics
};

const std::vector<Field<TurnFiles>>& fieldsOf(const TurnFiles*)
{
    static const std::vector<Field<TurnFiles>> all{
        field(
            "job", &TurnFiles::job,
            Label{LT_TEXT("Engine", "Job"),
                  LT_TEXT("Engine",
                          "Stock, set-up, tools and cutting data, from JOB.json; without it the operand is a job that "
                          "holds its shaft.")}),
        field("post", &TurnFiles::post,
              Label{LT_TEXT("Engine", "Post"),
                    LT_TEXT("Engine",
                            "Control that the program is for: fanuc_a, fanuc_b, haas, sinumerik, linuxcnc, grbl, or "
                            "POST.json.")}),
        field("spindle", &TurnFiles::spindle,
              Label{LT_TEXT("Engine", "Spindle"),
                    LT_TEXT("Engine", "Machine at the chuck face, from SPINDLE.json: speeds follow its dynamics.")})};
    return all;
}

std::vector<Option> turnOptions()
{
    std::vector<Option> options = optionsOf<TurnFiles>();
    for (Option& option : optionsOf<cam::TurningParameters>()) options.push_back(std::move(option));
    return options;
}

struct TurnRead {
    Shaft part;
    cam::Job job;
    cam::TurningInputs inputs;
};

cam::Post readPost(const std::string& stated, io::InputFiles& inputs, const Progress& progress, Answer& answer)
{
    const std::vector<std::string> names = cam::postNames();
    if (std::find(names.begin(), names.end(), stated) != names.end()) return cam::postNamed(stated);
    std::error_code ignored;
    if (stated.find_first_of("./\\") == std::string::npos && !std::filesystem::exists(stated, ignored))
        return cam::postNamed(stated);  // refused, with the names
    try {
        Notes notes;
        cam::Post post = cam::readPost(std::string(inputs.open(stated, progress)), notes);
        for (Note& note : notes) {
            set(note.values, "path", stated);
            answer.notes.push_back(std::move(note));
        }
        return post;
    } catch (Error& error) {
        throw error.with("path", stated);
    }
}

TurnRead readAll(const Request& request, io::InputFiles& inputs, const Progress& progress, Answer& answer)
{
    TurnRead read;
    const std::string &operand = request.operands.front(), stated = wordOf(request, "job");
    const std::string& path = stated.empty() ? operand : stated;
    read.job = readJob(path, request, inputs, progress, answer);
    read.part = partOf(read.job, stated.empty() ? std::string() : operand, path, inputs, progress, answer);
    read.inputs.post = readPost(wordOf(request, "post"), inputs, progress, answer);
    read.inputs.spindle = readSpindle(request, inputs, progress, answer);
    for (const InputFile& input : inputs.list()) {
        const std::string kind = input.path == path ? "job" : input.path == operand ? "shaft" : "";
        if (!kind.empty()) read.inputs.origin.push_back(kind + " SHA-256 " + input.sha256.substr(0, shownDigits));
    }
    return read;
}

void runTurn(const Request& request, io::InputFiles& inputs, const Progress& progress, Answer& answer)
{
    const TurnRead read = readAll(request, inputs, progress.part(0, 0.05), answer);
    const auto plan = std::make_shared<cam::TurningPlan>(
        cam::planTurning(read.part, read.job, read.inputs, fromValues<cam::TurningParameters>(request.parameters),
                         progress.part(0.05, 1)));
    if (plan->is_refused) {
        answer.notes.insert(answer.notes.end(), plan->notes.begin(), plan->notes.end());
        cam::throwIfRefused(*plan);
    }
    std::vector<std::string> paths;
    if (const auto output = request.outputs.find(programOption); output != request.outputs.end()) {
        paths = cam::programPaths(output->second, plan->setups.size());
        cam::refuseInputs(paths, inputs.list(), programOption);
        for (std::size_t i = 0; i < paths.size(); ++i) plan->setups[i].program = paths[i];
    }
    answerWith(
        answer, plan, [](const auto& found) { return cam::toJson(found); },
        [](const auto& found) { return cam::planReport(found); },
        [](const auto& found) { return report::toPlainText(cam::planSummary(found)); });
    if (!paths.empty()) cam::writePrograms(*plan, paths);
}

}  // namespace

Verb turnVerb()
{
    return {"turn",
            "Plan a turning program from a part and a job, write it for a control, and check what was written.",
            {{"SHAFT|JOB", "The part (SHAFT.json, STEP, CSV) with --job, or a job that holds its shaft."}},
            turnOptions(),
            {&cam::jobFiles(), &io::shaftFiles(), &receptance::spindleFiles()},
            {{programOption, "Write the program as FILE; two clampings as FILE_1 and FILE_2."}},
            true,
            runTurn};
}

}  // namespace lathelier::cli
