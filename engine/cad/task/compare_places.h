// Places of a comparison, in the coordinates of all views.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "engine/cad/task/compare_task.h"
#include "engine/core/mesh_place.h"

namespace lathelier::cad {

/// A place of the part. Every function below that gives one has as precondition that addViews() was called.
struct ComparePlace {
    Eigen::Vector3d reference_mm = Eigen::Vector3d::Zero();  ///< in the reference's frame
    std::optional<double> z_mm;                              ///< along the axis from its first data
    std::optional<double> angle_deg;                         ///< about the axis from its x, 0…360
    std::optional<std::size_t> point;                        ///< of the copy, a cloud
    std::optional<MeshPlace> surface;                        ///< of the copy, a mesh
    std::optional<double> deviation_mm;                      ///< signed; none where the place is excluded
    std::optional<double> local_mean_mm;                     ///< local mean deviation, where significant
};

/// A point of the copy (or, with `of_reference`, of the reference).
ComparePlace placeOfPoint(const CompareOutcome& outcome, std::size_t point, bool of_reference = false);

/// A place on the surface of the copy (or of the reference), which is a mesh. Its deviation is that of the corners in
/// proportion, as drawn.
ComparePlace placeOnMesh(const CompareOutcome& outcome, const MeshPlace& surface, bool of_reference = false);

/// A place on form.skin, which has to be there. Its local mean is that of the corners in proportion.
ComparePlace placeOnSkin(const CompareOutcome& outcome, const MeshPlace& place);

/// The place as form.skin draws it with its error magnified, in the reference's frame; without a skin as it is.
Eigen::Vector3d shownPlace_mm(const CompareOutcome& outcome, const Eigen::Vector3d& reference_mm, double factor);

/// The place on the reference's meridian; body of revolution only.
ComparePlace placeOnSurface(const CompareOutcome& outcome, double z_mm, double angle_deg);

/// A difference that views mark on the part.
struct CompareFlag {
    Eigen::Vector3d reference_mm = Eigen::Vector3d::Zero();  ///< in the reference's frame
    double value_mm = 0;                                     ///< of the finding
    std::optional<double> limit_mm;                          ///< none: no limit
    std::optional<Verdict> verdict;                          ///< none: no limit
};

/// The findings of the answer that have a place on the surface, in their order.
std::vector<CompareFlag> flagsOf(const CompareOutcome& outcome);

/// Wireframe of the original (rings at the ends of its smooth sections and lines along them) in its frame, shown with a
/// copy drawn with magnified error. Empty without an axis.
std::vector<std::vector<Eigen::Vector3d>> outlineOf(const registration::CompareResult& result);

}  // namespace lathelier::cad
