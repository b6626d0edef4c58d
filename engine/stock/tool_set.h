// The tools of a program as convex bodies.
#pragma once

#include <map>
#include <span>
#include <vector>

#include "engine/core/error.h"
#include "engine/gcode/move.h"
#include "engine/stock/tool_outline.h"

namespace lathelier::stock {

/// A convex part of a tool, the imaginary tip at (0, 0).
struct ToolBody {
    ConvexPolygon shape;
    ConvexPolygon grown;     ///< enlarged by the noted clearance
    bool is_holder = false;  ///< false: cutting part
};

struct MountedTool {
    std::vector<ToolBody> bodies;  ///< the insert first
    bool is_stated = false;        ///< given by the user, by number or as number 0
    double width_mm = 0;           ///< total extent of its bodies along z
};

/// The tools of a program, by number.
class ToolSet {
public:
    /// Notes: toolAssumed, toolWithoutHolder. Errors toolImpossible.
    ToolSet(std::span<const gcode::Move> moves, const std::vector<Tool>& stated, double clearance_mm, Notes& notes);

    /// Precondition: a move of the program has this number.
    const MountedTool& at(int number) const { return mounted_.at(number); }

    double width_mm() const;  ///< of the widest

private:
    std::map<int, MountedTool> mounted_;
};

}  // namespace lathelier::stock
