// Where the copy lies in the reference's frame, which motions the data determine, and how well.
#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <vector>

#include "engine/core/error.h"

namespace lathelier::registration {

/// A straight line in space.
struct Axis {
    Eigen::Vector3d point_mm = Eigen::Vector3d::Zero();
    Eigen::Vector3d direction = Eigen::Vector3d::UnitZ();
};

/// A motion the geometry does not determine: a rotation about, or a translation along, `direction` through `point_mm`.
struct FreeMotion {
    enum class Kind { Rotation, Translation };
    Kind kind = Kind::Rotation;
    Eigen::Vector3d direction = Eigen::Vector3d::UnitZ();
    Eigen::Vector3d point_mm = Eigen::Vector3d::Zero();
};

/// Expanded uncertainty (k = 2) of the determined motions. Body of revolution: along and across its axis. General part:
/// radius of the translation, the same across its largest direction, rotation (general_uncertainty.h).
struct AlignmentUncertainty {
    double axial_um = 0;
    double radial_um = 0;
    double axis_deg = 0;
};

/// The result of any registration.
struct Alignment {
    Eigen::Isometry3d reference_T_copy = Eigen::Isometry3d::Identity();
    bool converged = false;
    int iterations = 0;
    std::vector<FreeMotion> free_motions;
    AlignmentUncertainty uncertainty;
    std::optional<Axis> reference_axis;  ///< of a body of revolution; toward the larger coordinate on its dominant axis
    Notes notes;
};

}  // namespace lathelier::registration
