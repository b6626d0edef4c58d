// Text of the help pages, generated from the descriptions of the parameters.
#pragma once

#include <string>

#include "app/cli/verb.h"
#include "engine/task/asked_state.h"

namespace lathelier::cli {

inline constexpr const char* programName = "lathelier-cli";
inline constexpr const char* programSummary =
    "Lathelier on the command line: the engine of the turning workbench, without a display.";
inline constexpr const char* exitCodeHelp =
    "Exit codes: 0 answered, 1 out of tolerance (with --strict), 2 wrong usage, 3 an input was rejected,\n"
    "4 the files are sound but no answer exists, 5 an output could not be written, 130 cancelled by Ctrl-C.";
inline constexpr std::size_t helpColumn = 36;

using task::optionName;

/// Value syntax of the option: "auto|point|comma", "NUMBER", "A:B".
std::string placeholder(const FieldInfo& info);

/// Help text with unit, range and default, wrapped for the help page.
std::string describe(const Option& option);

/// Breaks lines so that they fit beside the column of options.
std::string wrapHelp(const std::string& text);

}  // namespace lathelier::cli
