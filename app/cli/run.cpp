#include "app/cli/run.h"

#include <algorithm>
#include <ctime>
#include <new>
#include <nlohmann/json.hpp>

#include "app/cli/help.h"
#include "app/cli/outputs.h"
#include "app/cli/progress_line.h"
#include "app/cli/standard_streams.h"
#include "app/cli/verb_answer.h"
#include "engine/core/core_codes.h"
#include "engine/core/parallel.h"
#include "engine/core/texts.h"
#include "engine/io/io_codes.h"
#include "engine/report/html.h"
#include "engine/report/result_json.h"
#include "engine/verify/verify_report.h"

namespace lathelier::cli {
namespace {

/// Reduced output when memory is insufficient even for the digests of the inputs.
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
    document.inputs = inputsOf(answer, inputs);
    document.created = now();
    verify::quoteVerification(document, progress);
    io::writeFile(path, report::toHtml(document));
}

/// Hands the whole object to `write`. Without sufficient memory only the error is written.
template <class Write>
void writeJson(const Invocation& invocation, io::InputFiles& inputs, Answer& answer, Write write)
{
    gather(answer, [&] {
        try {
            write(envelope(*invocation.verb, invocation.request, inputs, answer));
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
    watchOutputs(invocation);
    Answer answer = ask(*invocation.verb, invocation.request, inputs, progress);
    if (!common.report.empty() && answer.report && (answer.errors.empty() || answer.is_reported))
        gather(answer, [&] { writeReport(common.report, answer, inputs, progress); });
    progress.check();
    line.clear();

    // A file is there whole or not at all, so that a stop at any moment leaves what was finished before it.
    const bool json_on_stdout = common.json == "-";
    const bool is_refused = std::any_of(answer.errors.begin(), answer.errors.end(),
                                        [](const Error& error) { return error.code() == errors::outputIsInput; });
    if (!common.json.empty() && !json_on_stdout && !is_refused)
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
