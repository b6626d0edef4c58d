// Which words of a block leave its path alone when it is changed or divided. Internal to the room.
#pragma once

#include "engine/gcode/toolpath.h"

namespace lathelier::gcode {

/// States the radius of an arc.
bool isRadius(const Program& program, const Word& word);

/// The word that states the radius of an arc; nullptr: I and K state its centre.
const Word* radiusWord(const Program& program, const Block& block);

/// Chamfers, roundings and angles, as comma words or names.
bool shapesItsEnd(const Program& program, const Word& word);

/// Of a block that moves; what is not known to be harmless may shape its end, move another axis or call a program.
bool isHarmless(const Program& program, const Word& word, const BlockState& state);

/// Ends the program, leaves it or stops it or its spindle: not to be done before the rest of its block.
bool stops(const Control& control, const Word& word);

}  // namespace lathelier::gcode
