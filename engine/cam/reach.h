// Residual material of a set of tools before path planning: distances of contour points from the nose curves of all
// tools, and the intervals where every tool leaves material.
//
// left = min over tools (distance of the point from the curve - r), normal to the surface: as radial differences are
// undefined at walls. For a blade: the curves of both corners and the straight edge between them.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "engine/cam/check/rest_cause.h"
#include "engine/cam/contour.h"
#include "engine/cam/curve.h"

namespace lathelier::cam {

/// Reachable region of one tool.
struct ToolReach {
    int tool = 0;
    Curve curve;           ///< of the centre of its nose; of a blade, of its corner toward the chuck
    double radius_mm = 0;  ///< of nose or corner
    double span_mm = 0;    ///< of a blade, from the centre of one corner to that of the other; else 0
    /// Distance of a contour point from the region cut by the tool, from -radius to `most_mm`.
    double left_mm(const Eigen::Vector2d& point, double most_mm) const;
};

/// Residual material that no tool reaches, with location and cause.
struct Unreached {
    double z_start_mm = 0;  ///< first place of the drawing with more than leastRest_mm
    double z_end_mm = 0;
    double left_mm = 0;  ///< largest residual, normal to the surface
    double z_most_mm = 0;
    double x_most_mm = 0;
    RestCause cause = RestCause::NoseRadius;   ///< of the tool that gets nearest there
    int tool = 0;                              ///< number of that tool
    double tool_radius_mm = 0;                 ///< its nose, or corner
    std::optional<double> fillet_radius_mm{};  ///< hollow arc of the drawing that is smaller than that
    double path_from_mm = 0, path_to_mm = 0;   ///< the interval as way along the drawing
};

inline constexpr double leastRest_mm = 0.005;   ///< smaller residuals are ignored
inline constexpr double restSpacing_mm = 0.02;  ///< of points along the drawing

/// The intervals where every tool leaves more than leastRest_mm, within [0, length] of the drawing, in its order.
/// Ends and maxima are refined to 1e-5 mm. O(length / spacing · log pieces · tools).
std::vector<Unreached> restOf(const HeightContour& contour, const std::vector<ToolReach>& tools);

/// left = min over tools at a point of the drawing, no more than `most_mm`.
double leftAt_mm(const Eigen::Vector2d& point, const std::vector<ToolReach>& tools, double most_mm);

}  // namespace lathelier::cam
