// Lowest tip radius at each z such that neither insert nor holder collides with the tailstock.
//
// A tip at t covers t ⊕ B with each convex body B of the tool; it overlaps a convex region R of the tailstock if t lies
// in R ⊕ (-B), which is convex as well. The upper sides of these sums, grown by a clearance, are the floor. Where the
// floor falls more steeply than the back angle, a ray at the back angle keeps the back edge clear of the remaining
// stock.
#pragma once

#include "engine/cam/work_frame.h"

namespace lathelier::cam {

inline constexpr double tailstockClearance_mm = 0.5;  ///< between tool and tailstock

/// Lines over [from, to] in z of the tip; overlapping, not an envelope. Empty: no tailstock, a drill, or no overlap
/// with the interval.
Curve tailstockFloor(const Job& job, const JobTool& tool, double from_mm, double to_mm);

/// The lowest tip radius between two z; -1e9 without a limit.
double lowestBesideTailstock_mm(const Job& job, const JobTool& tool, double from_mm, double to_mm);

/// The curve of a tool's nose, lifted to the floor. The tool enters from `front_mm` (z of the tip): the first point is
/// at least as high as the floor between.
Curve liftedOverTailstock(const Job& job, const JobTool& tool, const Curve& curve, double front_mm);

}  // namespace lathelier::cam
