#include "engine/task/reply.h"

#include <nlohmann/json.hpp>

#include "engine/core/failure.h"
#include "engine/report/result_json.h"

namespace lathelier::task {
namespace {

/// Calls `work`; an error becomes part of the reply.
template <class Work>
void gather(Reply& reply, Work work)
{
    try {
        work();
    } catch (const Cancelled&) {
        throw;
    } catch (const std::exception& failure) {
        reply.errors.push_back(toError(failure));
    }
}

/// Names that cannot be written are refused before the computation.
void checkExports(const Task& task, const Request& request)
{
    for (const Export& output : task.exports) {
        const auto asked = request.exports.find(output.option);
        if (output.check && asked != request.exports.end()) output.check(asked->second);
    }
}

/// `state`: what is asked, before it is completed.
void run(const Task& task, project::PanelState state, const Request& request, Stores& stores, Reply& reply,
         const Progress& progress)
{
    Wanted wanted;
    wanted.in_full = request.in_full;
    for (const auto& [option, path] : request.exports) wanted.exports.push_back(option);
    try {
        if (request.complete) request.complete(state, stores, reply.sources);
        requireComplete(task, state);
        reply.state = std::move(state);
        reply.outcome = task.run(reply.state, wanted, stores, reply.sources, progress);
    } catch (...) {
        reply.notes = reply.sources.notes;
        reply.outcome.understanding = understandingOf(reply.notes);
        throw;
    }
    reply.notes = reply.outcome.notes;
    reply.errors = reply.outcome.errors;
    for (const auto& [option, path] : request.exports) {
        const auto writer = reply.outcome.writers.find(option);
        if (writer == reply.outcome.writers.end()) continue;
        // The other files are written all the same.
        gather(reply, [&, &to = path] { writer->second(to, {}, progress); });
    }
}

}  // namespace

Reply reply(const Task& task, const Request& request, const Progress& progress)
{
    Stores stores;
    return reply(task, request, stores, progress);
}

Reply reply(const Task& task, const Request& request, Stores& stores, const Progress& progress)
{
    Reply made;
    gather(made, [&] {
        project::PanelState state = statedState(task, request.operands, request.parameters);
        checkExports(task, request);
        run(task, std::move(state), request, stores, made, progress);
    });
    for (Error& error : made.errors) blame(error, task, made.state);
    return made;
}

Reply reply(const Task& task, const project::PanelState& state, const Completion& complete, Stores& stores,
            const Progress& progress)
{
    Request request;
    request.complete = complete;
    Reply made;
    gather(made, [&] { run(task, state, request, stores, made, progress); });
    for (Error& error : made.errors) blame(error, task, made.state);
    return made;
}

int exitCode(ErrorKind kind)
{
    constexpr int wrongUsage = 2, inputRejected = 3, noAnswer = 4, outputFailed = 5;
    switch (kind) {
        case ErrorKind::WrongUsage: return wrongUsage;
        case ErrorKind::InputRejected: return inputRejected;
        case ErrorKind::NoAnswer: return noAnswer;
        case ErrorKind::OutputFailed: return outputFailed;
    }
    return noAnswer;
}

Json resultOf(const Task& task, const Reply& reply)
{
    Json result = report::resultHead(task.key, reply.sources.inputs, parametersOf(task, reply.state));
    if (reply.outcome.json) result.update(reply.outcome.json());
    report::addRemarks(result, reply.outcome.understanding, reply.errors, reply.notes);
    return result;
}

}  // namespace lathelier::task
