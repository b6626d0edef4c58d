// How deep a program cuts into the drawing and how much it leaves on it, exactly: at each point of the drawing the
// clearance m = min over all strokes of (distance - radius). Gouge = -m, left = m. Radial differences would mean
// nothing at walls.
//
// m changes by no more than the way between two points (it is 1-Lipschitz), so of the strokes seen from the middle of a
// stretch only those count whose clearance is within twice the stretch's half length of the least one. Stretches are
// halved until few strokes are left: a point sees near moves only. O(points + strokes · log), one core.
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
    std::size_t own = 0;                ///< how many are the program's
};

/// Where the bar's surface is: no more can be left than stands there.
struct BarLimits {
    double radius_mm = 0;  ///< of the bar
    double end_z_mm = 0;   ///< of its raw end, at most 0
};

/// At one point of the drawing.
struct Clearance {
    double left_mm = 0;         ///< m, of all strokes, no more than the bar allows
    std::int32_t nearest = -1;  ///< stroke that comes nearest; -1: the bar's surface does, or there is none
    double own_mm = 0;          ///< m of the program's own strokes
    std::int32_t own = -1;      ///< the nearest of these; -1: there is none
};

/// A stretch of the drawing where material stays.
struct LeftStretch {
    std::size_t first = 0, last = 0;  ///< points of the drawing, both included
    double z_start_mm = 0;            ///< smallest z
    double z_end_mm = 0;              ///< largest z
    double left_mm = 0;               ///< largest, normal to the surface
    std::uint32_t piece = 0;          ///< of the drawing, where it is largest
    double t = 0;                     ///< share of that piece
    std::int32_t nearest = -1;        ///< stroke that comes nearest there
};

/// The deepest place that a block cuts below the drawing.
struct BlockGouge {
    std::int64_t line = 0;  ///< block
    double depth_mm = 0;    ///< normal to the surface
    Corner at;              ///< on the drawing
};

struct SurfaceDeviation {
    std::vector<Clearance> clearances;  ///< for each point of the drawing
    double gouge_mm = 0;                ///< the deepest, or 0
    Corner gouge_at;                    ///< where
    std::int64_t gouge_line = 0;        ///< of which block; 0: none
    std::vector<BlockGouge> blocks;     ///< with more than `gouge_limit_mm`, in the order of lines
    std::vector<LeftStretch> left;      ///< with more than `left_limit_mm`, in the order of the drawing
    double left_max_mm = 0;             ///< the largest anywhere, or 0
    double left_max_z_mm = 0;           ///< where
};

/// `looked_at`: where material that stays counts, by z; none: everywhere. Throws Cancelled.
SurfaceDeviation surfaceDeviation(const DrawnContour& drawing, const AllStrokes& all, const BarLimits& bar,
                                  const std::optional<Interval>& looked_at, double gouge_limit_mm, double left_limit_mm,
                                  const Progress& progress = {});

}  // namespace lathelier::cam
