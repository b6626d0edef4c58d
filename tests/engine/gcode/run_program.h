// A program from text to toolpath, for tests.
#pragma once

#include <fstream>
#include <iterator>
#include <string>

#include "engine/gcode/toolpath.h"

namespace lathelier::gcode {

inline Toolpath pathOf(const std::string& text, std::string_view control = automaticControl,
                       ToolpathParameters parameters = {}, const ToolTable& tools = {})
{
    Program program = readProgram(text, controlNamed(control));
    return findToolpath(program, parameters, tools);
}

inline std::string keptProgram(const std::string& name)
{
    std::ifstream file(LATHELIER_SOURCE_DIR "/tests/data/nc/" + name, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

inline const Diagnostic* diagnosticOf(const Toolpath& path, const std::string& code)
{
    for (const Diagnostic& diagnostic : path.diagnostics)
        if (diagnostic.code == code) return &diagnostic;
    return nullptr;
}

}  // namespace lathelier::gcode
