#include "app/cli/verb_answer.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "app/cli/run.h"
#include "engine/core/texts.h"
#include "engine/io/text/units.h"
#include "engine/report/result_json.h"
#include "engine/task/reply.h"

namespace lathelier::cli {
namespace {

/// The file that an error of a computation is about: the operand whose name is its role ("reference", "copy"), else the
/// last one of those that are named one by one.
void blame(Error& error, const Verb& verb, const Request& request)
{
    const ErrorKind kind = error.code().kind;
    if (kind != ErrorKind::InputRejected && kind != ErrorKind::NoAnswer) return;
    const std::vector<Operand>& operands = verb.operands;
    const std::vector<std::string>& paths = request.operands;
    if (operands.empty() || operands.back().is_output || paths.empty()) return;
    if (operands.back().repeated && paths.size() > 1) return;  // the verb itself knows which
    std::size_t which = paths.size() - 1;
    if (const Value* role = find(error.values(), "role"))
        for (std::size_t i = 0; i < operands.size(); ++i)
            if (io::lowerCase(operands[i].name) == text(*role)) which = i;
    error.with("path", paths.at(which));
}

}  // namespace

Answer ask(const Verb& verb, const Request& request, io::InputFiles& inputs, const Progress& progress)
{
    Answer answer;
    gather(answer, [&] { verb.run(request, inputs, progress, answer); });
    // A task has settled its answer itself.
    if (!answer.sources) {
        answer.understanding.add(understandingOf(answer.notes));
        std::optional<Verdict> verdict;
        settle(answer.understanding, verdict, answer.notes);
        if (verdict) answer.pass.reset();
    }
    for (Error& error : answer.errors) blame(error, verb, request);
    return answer;
}

std::vector<InputFile> inputsOf(const Answer& answer, io::InputFiles& inputs)
{
    return answer.sources ? answer.sources->inputs : inputs.list();
}

Json envelope(const Verb& verb, const Request& request, io::InputFiles& inputs, const Answer& answer)
{
    Json result = report::resultHead(verb.name, inputsOf(answer, inputs),
                                     answer.parameters.empty() ? request.parameters : answer.parameters);
    if (answer.json) result.update(answer.json());
    report::addRemarks(result, answer.understanding, answer.errors, answer.notes);
    return result;
}

int exitCode(const Answer& answer, bool strict)
{
    if (!answer.errors.empty()) return task::exitCode(answer.errors.front().code().kind);
    if (strict && !answer.understanding.isWhole()) return exitOutOfTolerance;
    return (strict || answer.always_strict) && answer.pass == false ? exitOutOfTolerance : exitAnswered;
}

}  // namespace lathelier::cli
