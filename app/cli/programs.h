// Reading NC programs with the options that say how.
#pragma once

#include "app/cli/verb.h"
#include "engine/gcode/toolpath.h"

namespace lathelier::cli {

/// --dialect, --nose-radius-mm, --tip, --integer-words, --tools.
std::vector<Option> programOptions();

/// A program and its moves; the moves may have errors.
struct ProgramRead {
    gcode::Program program;
    gcode::ToolTable tools;
    gcode::Toolpath path;
};

/// Errors of readers carry `path`.
ProgramRead readProgram(const std::string& path, const Request& request, io::InputFiles& inputs,
                        const Progress& progress);

/// The first error among the diagnostics, with `path`; none: the moves are to be trusted.
std::optional<Error> firstError(const gcode::Toolpath& toolpath, const std::string& path);

}  // namespace lathelier::cli
