#include "app/cli/run.h"

#include <ctime>
#include <new>
#include <nlohmann/json.hpp>

#include "app/cli/help.h"
#include "app/cli/progress_line.h"
#include "app/cli/standard_streams.h"
#include "engine/core/core_codes.h"
#include "engine/core/failure.h"
#include "engine/core/parallel.h"
#include "engine/core/texts.h"
#include "engine/io/text/units.h"
#include "engine/report/html.h"
#include "engine/report/result_json.h"
#include "engine/verify/verify_report.h"

namespace lathelier::cli {
namespace {

int exitCode(ErrorKind kind)
{
    switch (kind) {
        case ErrorKind::WrongUsage: return exitWrongUsage;
        case ErrorKind::InputRejected: return exitInputRejected;
        case ErrorKind::NoAnswer: return exitNoAnswer;
        case ErrorKind::OutputFailed: return exitOutputFailed;
    }
    return exitNoAnswer;
}

int exitCode(const Answer& answer, bool strict)
{
    if (!answer.errors.empty()) return exitCode(answer.errors.front().code().kind);
    return (strict || answer.always_strict) && answer.pass == false ? exitOutOfTolerance : exitAnswered;
}

/// The file that an error of a computation is about: the operand whose name is its role ("reference", "copy"), else the
/// last one of those that are named one by one.
void blame(Error& error, const Invocation& invocation)
{
    const ErrorKind kind = error.code().kind;
    if (kind != ErrorKind::InputRejected && kind != ErrorKind::NoAnswer) return;
    const std::vector<Operand>& operands = invocation.verb->operands;
    const std::vector<std::string>& paths = invocation.request.operands;
    if (operands.empty() || operands.back().is_output || paths.empty()) return;
    if (operands.back().repeated && paths.size() > 1) return;  // the verb itself knows which
    std::size_t which = paths.size() - 1;
    if (const Value* role = find(error.values(), "role"))
        for (std::size_t i = 0; i < operands.size(); ++i)
            if (io::lowerCase(operands[i].name) == text(*role)) which = i;
    error.with("path", paths.at(which));
}

/// What every verb's object begins and ends with.
Json envelope(const Invocation& invocation, io::InputFiles& inputs, const Answer& answer)
{
    Json result = report::resultHead(invocation.verb->name, inputs.list(), invocation.request.parameters);
    Json notes = toJson(answer.notes);
    if (answer.json) result.update(answer.json());
    if (!answer.errors.empty()) {
        result["error"] = toJson(answer.errors.front());
        // Why there is no answer is a note as well: scripts that collect notes find it beside the others.
        if (answer.errors.front().code().kind == ErrorKind::NoAnswer) notes.push_back(result["error"]);
    }
    if (answer.errors.size() > 1)
        for (const Error& error : answer.errors) result["errors"].push_back(toJson(error));
    result["notes"] = std::move(notes);
    return result;
}

/// What is left of it when there is no memory, not even for the digests of the inputs.
Json shortEnvelope(const Invocation& invocation, const Answer& answer)
{
    Json result = report::resultHead(invocation.verb->name, {}, invocation.request.parameters);
    for (const std::string& path : invocation.request.operands) result["inputs"].push_back({{"path", path}});
    result["error"] = toJson(answer.errors.back());
    result["notes"] = Json::array({result["error"]});
    return result;
}

std::string now()
{
    const std::time_t seconds = std::time(nullptr);
    std::tm local{};
    localtime_r(&seconds, &local);
    char buffer[32];
    return {buffer, std::strftime(buffer, sizeof buffer, "%Y-%m-%dT%H:%M:%S%z", &local)};
}

void writeReport(const std::string& path, const Answer& answer, io::InputFiles& inputs, const Progress& progress)
{
    report::Document document = answer.report();
    document.inputs = inputs.list();
    document.created = now();
    verify::quoteVerification(document, progress);
    io::writeFile(path, report::toHtml(document));
}

/// Calls `work`; an Error becomes part of the answer. Cancelled passes through.
template <class Work>
void gather(Answer& answer, Work work)
{
    try {
        work();
    } catch (const Cancelled&) {
        throw;
    } catch (const std::exception& failure) {
        answer.errors.push_back(toError(failure));
    }
}

/// Hands the whole object to `write`. Where the memory is too short for that, the answer gives way to the error.
template <class Write>
void writeJson(const Invocation& invocation, io::InputFiles& inputs, Answer& answer, Write write)
{
    gather(answer, [&] {
        try {
            write(envelope(invocation, inputs, answer));
        } catch (const std::exception& failure) {
            if (!(toError(failure).code() == errors::outOfMemory)) throw;
            answer.json = nullptr;
            answer.report = nullptr;
            answer.summary.clear();
            answer.errors.emplace_back(errors::outOfMemory, Values{});
            write(shortEnvelope(invocation, answer));
        }
    });
}

std::string forPeople(const Answer& answer)
{
    std::string result = answer.summary;
    for (const Note& note : answer.notes)
        result += (note.code.severity == Severity::Warning ? "! " : "- ") + text(note) + "\n";
    return result;
}

int work(const Invocation& invocation, const Progress& progress, ProgressLine& line)
{
    const CommonOptions& common = invocation.common;
    const ThreadLimit limit(common.threads);
    io::InputFiles inputs(common.threads != 1);
    Answer answer;
    gather(answer, [&] { invocation.verb->run(invocation.request, inputs, progress, answer); });
    for (Error& error : answer.errors) blame(error, invocation);
    if (!common.report.empty() && answer.report && answer.errors.empty())
        gather(answer, [&] { writeReport(common.report, answer, inputs, progress); });
    progress.check();
    line.clear();

    // A file is there whole or not at all, so that a stop at any moment leaves what was finished before it.
    const bool json_on_stdout = common.json == "-";
    if (!common.json.empty() && !json_on_stdout)
        writeJson(invocation, inputs, answer, [&](const Json& json) {
            io::writeFile(common.json, [&](const io::Append& append) {
                report::writeText(json, [&](std::string_view step) {
                    progress.check();
                    append(step);
                });
            });
        });
    if (!common.quiet)
        gather(answer, [&] { print(json_on_stdout ? Stream::Errors : Stream::Answers, forPeople(answer), progress); });
    if (json_on_stdout)
        writeJson(invocation, inputs, answer, [&](const Json& json) {
            report::writeText(json, [&](std::string_view step) { print(Stream::Answers, step, progress); });
        });
    for (const Error& error : answer.errors)
        print(Stream::Errors, std::string(programName) + ": " + text(error) + "\n");
    return exitCode(answer, common.strict);
}

}  // namespace

int run(const Invocation& invocation, std::stop_token stop)
{
    ProgressLine line(!invocation.common.quiet);
    const Progress progress(std::move(stop), [&line](double fraction, Text stage) { line.show(fraction, stage); });
    try {
        return work(invocation, progress, line);
    } catch (const Cancelled&) {
        line.clear();
        print(Stream::Errors, std::string(programName) + ": cancelled\n");
        return exitCancelled;
    }
}

}  // namespace lathelier::cli
