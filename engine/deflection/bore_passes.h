// Moves of a tool in a bore, which are no outside turning: the work is pushed the other way there.
//
// A program does not say on which side of the material its tool is; its ways in and out do. Along the work a tool in a
// bore can be at radii within the bore, and it retracts toward the axis; a tool outside can be beyond the stock, and it
// retracts away from the axis. Where a way shows neither, it counts by the radius that it comes from. Only hollow stock
// and work that the program has drilled have a bore.
#pragma once

#include <span>
#include <vector>

#include "engine/deflection/tool_path.h"
#include "engine/shaft/shaft.h"

namespace lathelier::deflection {

/// For each move: true if it lies in a bore.
std::vector<bool> movesInBores(std::span<const ToolMove> moves, const Shaft& stock);

}  // namespace lathelier::deflection
