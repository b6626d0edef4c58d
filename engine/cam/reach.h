// What a set of tools leaves of a drawing, before any path exists: points of the drawing, their distance from the
// curves of the tools' noses, and the intervals where all of them stay away.
//
// left = min over tools (distance of the point from the curve - r), normal to the surface: radial differences mean
// nothing at walls. Of a blade the curves of both corners and the floor between count.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "engine/cam/check/rest_cause.h"
#include "engine/cam/contour.h"
#include "engine/cam/curve.h"

namespace lathelier::cam {

/// How far one tool gets.
struct ToolReach {
    int tool = 0;          ///< number
    Curve curve;           ///< of the centre of its nose; of a blade, of its corner toward the chuck
    double radius_mm = 0;  ///< of nose or corner
    double span_mm = 0;    ///< of a blade, from the centre of one corner to that of the other; else 0
    /// Of a point of the drawing from what the tool cuts, at least -radius; not more than `most_mm`.
    double left_mm(const Eigen::Vector2d& point, double most_mm) const;
};

/// Material that no tool reaches, where it is and why.
struct Unreached {
    double z_start_mm = 0;                     ///< first place of the drawing with more than leastRest_mm
    double z_end_mm = 0;                       ///< last one
    double left_mm = 0;                        ///< the most, normal to the surface
    double z_most_mm = 0;                      ///< where that is
    double x_most_mm = 0;                      ///< radius there
    RestCause cause = RestCause::NoseRadius;   ///< of the tool that gets nearest there
    int tool = 0;                              ///< number of that tool
    double tool_radius_mm = 0;                 ///< its nose, or corner
    std::optional<double> fillet_radius_mm{};  ///< hollow arc of the drawing that is smaller than that
    double path_from_mm = 0, path_to_mm = 0;   ///< the interval as way along the drawing
};

inline constexpr double leastRest_mm = 0.005;   ///< what is less is no rest
inline constexpr double restSpacing_mm = 0.02;  ///< of points along the drawing

/// The intervals where every tool leaves more than leastRest_mm, within [0, length] of the drawing, in its order.
/// Ends and maxima are refined to 1e-5 mm. O(length / spacing · log pieces · tools).
std::vector<Unreached> restOf(const HeightContour& contour, const std::vector<ToolReach>& tools);

/// left = min over tools at a point of the drawing, no more than `most_mm`.
double leftAt_mm(const Eigen::Vector2d& point, const std::vector<ToolReach>& tools, double most_mm);

}  // namespace lathelier::cam
