// Faces across the axis of a body of revolution (its ends and shoulders), as far as the scan shows them.
#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "engine/core/progress.h"
#include "engine/registration/revolution/revolution_axis.h"
#include "engine/registration/scanner_spot.h"

namespace lathelier::registration {

/// A ring across the axis, in the axis frame, where a face is sought.
struct FaceCandidate {
    double z_mm = 0;                    ///< expected place along the axis
    double inner_mm = 0;                ///< radius where it begins
    double outer_mm = 0;                ///< radius where it ends
    int facing = 1;                     ///< direction of its outward normal along z
    double margin_mm = smearedEdge_mm;  ///< points nearer to its two edges are left out
};

/// A face that the points show: z in rings, wider where there are few points.
struct MeasuredFace {
    double sought_mm = 0;               ///< where it was sought
    int facing = 1;                     ///< direction of its outward normal along z
    std::vector<Eigen::Vector2d> line;  ///< (z, r) of each ring that has points, by growing radius
    double z_mm = 0;                    ///< mean of its points with Tukey weights
    double inner_mm = 0;                ///< radius where the first of these rings begins
    double outer_mm = 0;                ///< radius where the last ends
    double ring_mm = 0;                 ///< width of a ring but for those with few points
    double sigma_mm = 0;                ///< standard uncertainty of z in one ring
    double place_sigma_mm = 0;          ///< standard uncertainty of `z_mm`, from the scatter over its sectors
    double density_ratio = 0;           ///< points for each mm² over those of the sides

    /// z of the face at a radius; beyond the rings that of the outermost.
    double zAt_mm(double radius_mm) const;
};

/// Those of the faces sought (in order of z) that lie across the axis, within 1 mm of where they are sought and nearer
/// to that than to the next one, and have points all over, about as dense as on the sides of `profile` and not
/// scattered as stray points are. No ring is narrower than the profile's bins. Throws Cancelled.
std::vector<MeasuredFace> measureFaces(const std::vector<Eigen::Vector3d>& points_mm,
                                       const Eigen::Isometry3d& axis_T_points, const RadiusProfile& profile,
                                       const std::vector<FaceCandidate>& sought, const Progress& progress = {});

}  // namespace lathelier::registration
