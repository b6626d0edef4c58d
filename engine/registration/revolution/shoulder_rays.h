// Rays of a scan near the shoulders of a body of revolution.
#pragma once

#include <optional>
#include <vector>

#include "engine/registration/revolution/profile_edges.h"
#include "engine/registration/revolution/revolution_axis.h"

namespace lathelier::registration {

/// One ray near an edge: its height where it passes the larger radius, and whether it hit it.
struct Ray {
    double height;  ///< z times the sign of its edge, in mm
    bool hit;       ///< true: the ray ended at the larger radius
};

struct EdgeRays {
    Edge edge;                 ///< where the radius jumps
    std::vector<Ray> rays;     ///< in order of height
    double lean_sigma_mm = 0;  ///< common standard uncertainty of the heights, from that of the rays' direction
};

/// The height with as many rays below it as there are misses in total; nullopt with too few hits or misses.
std::optional<double> balance(const std::vector<Ray>& rays);

/// All edges higher than 8 times the scatter with their rays.
/// The rays are those of the scanner's axis when the points come row by row (scanner_axis.h); else their lean is found
/// from the shadow that leaning rays leave beside a shoulder on the side turned away, which displaces the balance there
/// by half the shadow.
std::vector<EdgeRays> findEdgeRays(const std::vector<Eigen::Vector3d>& points, const RevolutionFit& fit,
                                   const Progress& progress = {});

/// The same for edges that are known, in order of z.
std::vector<EdgeRays> findEdgeRays(const std::vector<Eigen::Vector3d>& points, const RevolutionFit& fit,
                                   const std::vector<Edge>& edges, const Progress& progress = {});

}  // namespace lathelier::registration
