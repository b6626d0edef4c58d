// Signed distance of a copy's points from the surface of the reference.
// In place of the paper's nearest-point distance, which reads 32 µm where 50 µm are in excess.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "engine/core/error.h"
#include "engine/core/progress.h"
#include "engine/core/scan.h"
#include "engine/registration/general/general_reference.h"

namespace lathelier::registration {

struct SurfaceDeviation {
    std::vector<float>
        deviation_mm;  ///< one per point; NaN beyond max_distance_mm, and where the reference has no surface
    /// One per point: the direction in which the deviation is measured, so that deviation × direction leads from the
    /// surface to the point; zero where there is none.
    std::vector<Eigen::Vector3f> direction;
    bool has_sign = true;  ///< false: unsigned distances, with the note signUndetermined
    Notes notes;           ///< assumptions and repairs of the reference's surface
};

/// Deviation along the surface normal, + where the copy has material in excess. Mesh reference: exact distance to its
/// triangles, signed by the sense of its facets (or by its normals); NaN beside an opening that was not filled
/// (mesh_repair.h), and no sign where the facets' senses contradict each other. Cloud reference: distance to a quadric
/// through about 48 neighbours, split at sharp edges, signed when it carries normals or is evidently closed. Points
/// that are not finite get NaN. Errors: tooFewPoints, for a reference cloud of fewer than 4 points. Throws Cancelled.
SurfaceDeviation surfaceDeviation(const Scan& reference,
                                  const std::vector<Eigen::Vector3d>& copy_points_in_reference_mm,
                                  double max_distance_mm, const Progress& progress = {});

/// The same from a reference that was prepared before (aligned onto, as a rule). Its surface is oriented here.
SurfaceDeviation surfaceDeviation(const GeneralReference& reference,
                                  const std::vector<Eigen::Vector3d>& copy_points_in_reference_mm,
                                  double max_distance_mm, const Progress& progress = {});

}  // namespace lathelier::registration
