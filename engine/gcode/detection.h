// Which control a program is for, from its text (the rules stand in evidence.h).
#pragma once

#include <string_view>

#include "engine/gcode/control.h"

namespace lathelier::gcode {

/// Result of detectControl().
struct ControlFound {
    ControlPtr control;      ///< most probable one of allControls(), also one that is not read
    long line = 0;           ///< first line that points to it, from 1; 0: none does
    long nc_lines = 0;       ///< examined lines that are blocks of an NC program
    long other_lines = 0;    ///< examined lines that are neither blocks, nor empty, nor comments
    bool has_codes = false;  ///< some line has a G or M word, or is the head of a program
    bool has_head = false;   ///< starts with %, an O number or %_N_
};

/// Examines the first 2000 lines, without comments. Cost: one pass.
ControlFound detectControl(std::string_view text);

}  // namespace lathelier::gcode
