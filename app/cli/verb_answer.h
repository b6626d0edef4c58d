// A verb asked once: its answer with everything that was refused, its object, its exit code.
#pragma once

#include "app/cli/arguments.h"
#include "engine/core/failure.h"

namespace lathelier::cli {

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

/// Runs the verb. Errors become part of the answer, each with the file that it is about. Throws Cancelled.
Answer ask(const Verb& verb, const Request& request, io::InputFiles& inputs, const Progress& progress);

/// What was read for the answer.
std::vector<InputFile> inputsOf(const Answer& answer, io::InputFiles& inputs);

/// The whole object: head, the verb's keys, `error`, notes.
Json envelope(const Verb& verb, const Request& request, io::InputFiles& inputs, const Answer& answer);

/// The exit code that scripts rely on.
int exitCode(const Answer& answer, bool strict);

}  // namespace lathelier::cli
