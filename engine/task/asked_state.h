// A task asked by operands and options: from the command line, or by a step of a chain.
#pragma once

#include <string>
#include <vector>

#include "engine/task/task.h"

namespace lathelier::task {

/// Of the command line: `--tolerance-mm` of the key tolerance_mm.
std::string optionName(const std::string& key);

/// Name of an operand on help pages: "REFERENCE" of the role reference.
std::string operandOf(const Input& input);

/// Whether the command line can give it.
bool isOfCommandLine(const Input& input);

/// Gives what a request leaves open, before it is checked: `sources` receives what it read and its notes.
using Completion = std::function<void(project::PanelState& state, Stores& stores, Sources& sources)>;

/// `operands` in the order of the inputs without an option; `parameters` by key: options of inputs, fields of the
/// question, and reading options, which are those of every file. Not checked.
project::PanelState statedState(const Task& task, const std::vector<std::string>& operands, const Values& parameters);

/// Errors: valueNotUnderstood where a required input is not given, oneNeeded, oneOnly, onlyWith.
void requireComplete(const Task& task, const project::PanelState& state);

/// Adds the file that an error of a computation is about: the operand whose role it names, else the last operand; of
/// several of one role the task knows which. An error that names its file stays as it is.
void blame(Error& error, const Task& task, const project::PanelState& state);

}  // namespace lathelier::task
