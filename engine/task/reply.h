// A task asked once by operands and options, with everything that was refused: the command line asks one, a chain
// several in sequence.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "engine/task/asked_state.h"
#include "engine/task/task.h"

namespace lathelier::task {

struct Request {
    std::vector<std::string> operands;
    Values parameters;                           ///< by key: options of inputs, fields, reading options
    std::map<std::string, std::string> exports;  ///< by Export::option: path of the file to write
    bool in_full = true;                         ///< Wanted::in_full
    Completion complete = {};                    ///< none: the request stands as it is
};

struct Reply {
    project::PanelState state;  ///< as asked; empty where the request was refused
    Sources sources;            ///< what was read
    Outcome outcome;            ///< without functions where an error ended the run
    Notes notes;                ///< of the outcome, else those of the readers
    std::vector<Error> errors;  ///< empty: answered, and every file was written
};

/// Runs the task and writes the files. Errors are part of the reply, each with the file that it is about. Throws
/// Cancelled.
Reply reply(const Task& task, const Request& request, const Progress& progress);

/// The same with files read by `stores`, which keep them for the next request.
Reply reply(const Task& task, const Request& request, Stores& stores, const Progress& progress);

/// A state asked as it stands, in full and without files to write: that of a recipe.
Reply reply(const Task& task, const project::PanelState& state, const Completion& complete, Stores& stores,
            const Progress& progress);

/// The exit code of the command line for an error of this kind.
int exitCode(ErrorKind kind);

/// The whole object: head, keys of the result, `error`, notes.
Json resultOf(const Task& task, const Reply& reply);

}  // namespace lathelier::task
