// LinuxCNC's tool table: one tool a line, "T1 P1 D1.6 Q2 ;remark". D is twice the corner radius in mm, Q the
// orientation as LinuxCNC counts it (2 is Fanuc's tip 3, for its X points the other way).
#pragma once

#include <string_view>

#include "engine/gcode/toolpath.h"

namespace lathelier::gcode {

/// Errors toolTableMalformed (line, column), fileEmpty. Tools without D have no corner and are omitted.
ToolTable readToolTable(std::string_view text);

}  // namespace lathelier::gcode
