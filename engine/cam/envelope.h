// The curve that the centre of a tool's nose must stay above, exactly, as lines and arcs.
//
// The tool is a disc of radius r and a wedge between its two edges. With h(u) the drawing, the centre's curve f(u) is
// the upper envelope of the drawing ⊕ disc ⊕ (-wedge). Candidates, each a function on an interval of u:
// - every line, shifted by r along its normal;
// - every arc: convex, radius R + r; hollow, R - r, none where R ≤ r;
// - the upper half of the disc around every corner, both ends of walls among them;
// - a ray that falls at the back angle κ' = 180° - κ - ε from the offset of every corner or convex arc where the
// drawing
//   falls more steeply; in front of it one at κ, where κ < 90°, where the drawing rises more steeply.
// f with r + δ keeps the allowance δ normal to the surface everywhere. The residual material of f is the morphological
// closing of the drawing by the tool; a corner that turns by φ keeps r (1/cos(φ/2) - 1).
//
// A blade of width w has two corners of radius c; the centre of the one toward the chuck stays above the sliding
// maximum of f_c over the window [u - (w - 2c), u]: the envelope of f_c, f_c shifted, and bridges over its summits.
// Cost: some 20 µs for a shaft of ten elements.
#pragma once

#include "engine/cam/contour.h"
#include "engine/cam/curve.h"

namespace lathelier::cam {

/// The part of a tool that its envelope depends on.
struct ToolWedge {
    double radius_mm = 0;            ///< r of the nose, or c of a blade's corners
    double back_angle_deg = 90;      ///< back angle less the margin; ≥ 90: the back edge never limits
    double entering_angle_deg = 90;  ///< κ; ≥ 90: the main edge never limits
};

/// For the centre of the nose, from u = -(r + allowance) to `end_mm` of the contour's last u. Precondition: contour not
/// empty, r + allowance > 0.
Curve noseCurve(const HeightContour& contour, const ToolWedge& tool, double allowance_mm = 0);

/// For the centre of a blade's corner toward the chuck; `span_mm` = w - 2c between the centres.
Curve bladeCurve(const HeightContour& contour, double corner_radius_mm, double span_mm, double allowance_mm = 0);

}  // namespace lathelier::cam
