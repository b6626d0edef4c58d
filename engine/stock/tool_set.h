// The tools of a program as the simulation moves them.
#pragma once

#include <map>
#include <span>
#include <vector>

#include "engine/core/error.h"
#include "engine/gcode/move.h"
#include "engine/stock/turning_insert.h"

namespace lathelier::stock {

/// A convex part of a tool, the imaginary tip at (0, 0).
struct ToolBody {
    ConvexPolygon shape;     ///< its outline
    ConvexPolygon grown;     ///< larger by the clearance that is noted
    bool is_holder = false;  ///< else it cuts
};

struct MountedTool {
    std::vector<ToolBody> bodies;  ///< the insert first
    bool is_stated = false;        ///< listed by the user, by its number or as number 0
    double width_mm = 0;           ///< extents of its bodies along z, together
};

/// The tools of a program, by number.
class ToolSet {
public:
    /// Notes: toolAssumed, toolWithoutHolder. Errors toolImpossible.
    ToolSet(std::span<const gcode::Move> moves, const std::vector<TurningTool>& stated, double clearance_mm,
            Notes& notes);

    /// Precondition: a move of the program has this number.
    const MountedTool& at(int number) const { return mounted_.at(number); }

    double width_mm() const;  ///< of the widest

private:
    std::map<int, MountedTool> mounted_;
};

}  // namespace lathelier::stock
