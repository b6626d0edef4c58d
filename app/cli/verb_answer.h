// A verb asked once: its answer with everything that was refused, its object, its exit code. The command line runs one
// verb; the chain, here and in the window, several in sequence.
#pragma once

#include "app/cli/arguments.h"
#include "engine/chain/verb_asker.h"
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

/// A request with all parameters at their defaults but `given`. Precondition: the verb has options of these keys.
Request requestOf(const Verb& verb, std::vector<std::string> operands, const Values& given,
                  std::map<std::string, std::string> outputs);

/// Runs a verb of the table by name, with its report: a chain::AskVerb. Precondition: there is one of this name.
chain::VerbReply runVerbByName(const chain::VerbQuestion& question, const Progress& progress);

}  // namespace lathelier::cli
