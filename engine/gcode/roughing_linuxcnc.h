// G70, G71 and G72 of LinuxCNC over a contour. Sources: the manual of LinuxCNC for the words; the moves that rs274 of
// release 2.9 prints, against which tests compare.
//
// Everything in the unit of the program (mm or inch) and as radii, in the coordinates of the program.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "engine/core/text.h"
#include "engine/gcode/cycles.h"

namespace lathelier::gcode {

struct SubroutineCycle {
    enum class Kind : std::uint8_t { Finish, Turn, Face };         ///< G70, G71, G72
    enum class Pockets : std::uint8_t { Cut, LeftOut, OnlyThey };  ///< G71, G71.1, G71.2
    Kind kind = Kind::Turn;
    Pockets pockets = Pockets::Cut;
    Point start;           ///< X and Z of the block, else the position
    double distance = 0;   ///< D: left to the contour; of Finish: of the first pass
    double last = 0;       ///< E of Finish: of the last pass
    double depth = 1;      ///< I
    double retreat = 0.5;  ///< R, along both axes
    int passes = 1;        ///< P of Finish
};

/// The moves, or why there are none.
struct SubroutineCycleMoves {
    CycleMoves moves;
    std::optional<Text> refused;  ///< the interpreter refuses the contour
    bool is_modelled = true;      ///< false: what it does with such a contour is not modelled
};

/// `contour`: one piece or more; the first one is replaced by the way from the start to its end.
SubroutineCycleMoves subroutineCycle(const SubroutineCycle& cycle, const std::vector<Piece>& contour);

}  // namespace lathelier::gcode
