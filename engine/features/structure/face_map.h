// Holes in the faces across the axis: round places without points on a face that is seen.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "engine/core/progress.h"
#include "engine/features/outline/outline.h"

namespace lathelier::features {

/// Thresholds of the search.
struct FaceThresholds {
    double cell_points = 10;  ///< mean of the points of a cell: one of 10⁴ is empty by chance
    double least_cell_mm = 0.5;
    double most_cell_mm = 2;     ///< coarser cells show no holes of 6 mm
    double near_sigmas = 5;      ///< points this near the plane belong to the face
    double near_mm = 0.1;        ///< besides
    double rim_mm = 0.8;         ///< beside the edges of the face: blurred, chamfered
    double empty_share = 0.2;    ///< of the mean: less is empty
    double seen_share = 0.5;     ///< of the cells that hold points: else the face is not seen
    double least_hole_mm2 = 3;   ///< a hole of 2 mm
    double most_aspect = 1.6;    ///< of a round region
    double most_fill = 0.92;     ///< of its box
    double most_missing = 0.15;  ///< share of the face in other places without points: seen in patches only
};
inline constexpr FaceThresholds faceThresholds{};

/// A round place without points on a face.
struct FaceHole {
    double x_mm = 0, y_mm = 0;  ///< its middle across the axis
    double area_mm2 = 0;
};

/// A plane of the model with the ring of it that is judged.
struct SeenFace {
    double z_mm = 0, inner_mm = 0, outer_mm = 0;
    std::vector<Eigen::Vector2d> places_mm;  ///< of its points
    std::vector<FaceHole> holes;
};

/// Faces of a surface scan that are seen, in order of z, in the frame of the outline. Throws Cancelled.
std::vector<SeenFace> seenFaces(const MeridianCloud& cloud, const Outline& outside, const Outline* bore,
                                const Progress& progress = {});

/// Holes by face that no mark of kind BoltCircle names: kind NoPoints, z of the face.
std::vector<UnexplainedStructure> holesInFaces(const std::vector<SeenFace>& faces, const std::vector<ShaftMark>& marks);

}  // namespace lathelier::features
