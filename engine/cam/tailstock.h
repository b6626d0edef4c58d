// Where a tip may stand beside the tailstock: the lowest radius at each z, so that neither insert nor holder meets it.
//
// A tip at t covers t ⊕ B with each convex body B of the tool; it meets a convex region R of the tailstock where t lies
// in R ⊕ (-B), which is convex as well. The upper sides of these sums, grown by a clearance, are the floor. Behind a
// place where the floor falls more steeply than the back edge may follow, a ray at the back angle keeps the edge off
// the stock that stays there.
#pragma once

#include "engine/cam/work_frame.h"

namespace lathelier::cam {

inline constexpr double tailstockClearance_mm = 0.5;  ///< between tool and tailstock

/// Lines over [from, to] in z of the tip; overlapping, not an envelope. Empty: no tailstock, a drill, or nothing there.
Curve tailstockFloor(const Job& job, const JobTool& tool, double from_mm, double to_mm);

/// The lowest radius of the tip between two places; -1e9 where nothing stands in the way.
double lowestBesideTailstock_mm(const Job& job, const JobTool& tool, double from_mm, double to_mm);

/// The curve of a tool's nose, lifted to the floor. Entered from `front_mm` (z of the tip), so its first place is as
/// high as the floor from there on.
Curve liftedOverTailstock(const Job& job, const JobTool& tool, const Curve& curve, double front_mm);

}  // namespace lathelier::cam
