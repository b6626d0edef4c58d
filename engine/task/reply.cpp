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

void run(const Task& task, const Request& request, Reply& reply, const Progress& progress)
{
    project::PanelState state = statedState(task, request.operands, request.parameters);
    checkExports(task, request);
    Wanted wanted;
    wanted.in_full = request.in_full;
    for (const auto& [option, path] : request.exports) wanted.exports.push_back(option);
    Stores stores;
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
    Reply made;
    gather(made, [&] { run(task, request, made, progress); });
    for (Error& error : made.errors) blame(error, task, made.state);
    return made;
}

Json resultOf(const Task& task, const Reply& reply)
{
    Json result = report::resultHead(task.key, reply.sources.inputs, parametersOf(task, reply.state));
    if (reply.outcome.json) result.update(reply.outcome.json());
    report::addRemarks(result, reply.outcome.understanding, reply.errors, reply.notes);
    return result;
}

}  // namespace lathelier::task
