// Exact gouge depth and residual material of a program: at each point of the nominal contour the clearance m = min over
// all strokes of (distance - radius). Gouge = -m, left = m. Distances are normal to the surface, as radial differences
// are undefined at walls.
//
// m is 1-Lipschitz along the contour. So only strokes whose clearance at the middle of a stretch exceeds the minimum
// there by at most its length can be nearest anywhere in it. Stretches are bisected until few candidate strokes remain.
// O(points + strokes · log), one core.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "engine/cam/check/cutter_path.h"
#include "engine/cam/check/drawn_contour.h"
#include "engine/core/progress.h"

namespace lathelier::cam {

/// Strokes of a program that is checked, and of one that ran before it in another clamping.
struct AllStrokes {
    std::vector<CutterStroke> strokes;  ///< those of the program first
    std::size_t own = 0;                ///< number of strokes of the checked program
};

/// Surface of the bar; an upper bound of the residual material.
struct BarLimits {
    double radius_mm = 0;
    double end_z_mm = 0;  ///< z of its raw end, ≤ 0
};

/// At one point of the drawing.
struct Clearance {
    double left_mm = 0;         ///< m over all strokes, limited by the surface of the bar
    std::int32_t nearest = -1;  ///< nearest stroke; -1: the surface of the bar is nearer, or there is no stroke
    double own_mm = 0;          ///< m over the strokes of the checked program
    std::int32_t own = -1;      ///< nearest of these; -1: none
};

/// A contour stretch with residual material.
struct LeftStretch {
    std::size_t first = 0, last = 0;  ///< points of the drawing, both included
    double z_start_mm = 0;
    double z_end_mm = 0;
    double left_mm = 0;         ///< largest, normal to the surface
    std::uint32_t piece = 0;    ///< of the drawing, where it is largest
    double t = 0;               ///< share of that piece
    std::int32_t nearest = -1;  ///< nearest stroke there
};

/// Deepest gouge of one block.
struct BlockGouge {
    std::int64_t line = 0;  ///< block
    double depth_mm = 0;    ///< normal to the surface
    Corner at;              ///< on the drawing
};

struct SurfaceDeviation {
    std::vector<Clearance> clearances;  ///< for each point of the drawing
    double gouge_mm = 0;                ///< the deepest, or 0
    Corner gouge_at;
    std::int64_t gouge_line = 0;     ///< line of the block that causes it; 0: no gouge
    std::vector<BlockGouge> blocks;  ///< with more than `gouge_limit_mm`, in the order of lines
    std::vector<LeftStretch> left;   ///< with more than `left_limit_mm`, in the order of the drawing
    double left_max_mm = 0;          ///< the largest anywhere, or 0
    double left_max_z_mm = 0;
};

/// `looked_at`: z interval in which residual material is evaluated; none: everywhere. Throws Cancelled.
SurfaceDeviation surfaceDeviation(const DrawnContour& drawing, const AllStrokes& all, const BarLimits& bar,
                                  const std::optional<Interval>& looked_at, double gouge_limit_mm, double left_limit_mm,
                                  const Progress& progress = {});

}  // namespace lathelier::cam
