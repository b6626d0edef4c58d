// Which words of a block the control of its program knows and which of them are modelled.
#pragma once

#include "engine/gcode/program.h"

namespace lathelier::gcode {

/// Marks unknown and unmodelled words of a block and adds a diagnostic for each. Computed G and M words are classified
/// when they are run.
void classifyWords(Program& program, Block& block);

}  // namespace lathelier::gcode
