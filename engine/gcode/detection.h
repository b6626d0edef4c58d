// Which control a program is for, from its text (the rules stand in evidence.h).
#pragma once

#include <string_view>

#include "engine/gcode/control.h"

namespace lathelier::gcode {

/// Result of detectControl().
struct ControlFound {
    ControlPtr control;      ///< most probable one of allControls(), also one that is not read
    ControlPtr rival;        ///< one that is read and as probable; nullptr: none
    long line = 0;           ///< first line that points to it, from 1; 0: none does
    long nc_lines = 0;       ///< examined lines that are blocks of an NC program
    long other_lines = 0;    ///< examined lines that are neither blocks, nor empty, nor comments
    bool has_codes = false;  ///< some line has a G or M word, or is the head of a program
    bool has_head = false;   ///< starts with %, an O number (":0100" too) or %_N_
    bool has_axes = false;   ///< some line has a coordinate: two controls read different numbers
};

/// Examines the first 2000 lines. `name`: of the file, with its path or without; empty: unknown. Neither capitals, nor
/// blank lines, nor ";" at the ends of blocks (the end-of-block sign of ISO code) tell anything. Cost: one pass.
ControlFound detectControl(std::string_view text, std::string_view name = {});

}  // namespace lathelier::gcode
