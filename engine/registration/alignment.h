// Pose of the copy in the reference's frame, the motions that the data determine, and their uncertainty.
#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <vector>

#include "engine/core/error.h"

namespace lathelier::registration {

/// A straight line in space.
struct Axis {
    Eigen::Vector3d point_mm = Eigen::Vector3d::Zero();    ///< a point of the line
    Eigen::Vector3d direction = Eigen::Vector3d::UnitZ();  ///< unit vector
};

/// A motion the geometry does not determine: a rotation about, or a translation along, `direction` through `point_mm`.
struct FreeMotion {
    enum class Kind { Rotation, Translation };
    Kind kind = Kind::Rotation;                            ///< about, or along, the direction
    Eigen::Vector3d direction = Eigen::Vector3d::UnitZ();  ///< unit vector in the reference's frame
    Eigen::Vector3d point_mm = Eigen::Vector3d::Zero();    ///< a point of the axis of a rotation, in that frame
};

/// Expanded uncertainty (k = 2) of the determined motions. Body of revolution: along and across its axis. General part:
/// radius of the translation, the same across its largest direction, rotation (general_uncertainty.h).
struct AlignmentUncertainty {
    double axial_um = 0;   ///< revolution: along the axis, NaN when that motion is free; else of the translation
    double radial_um = 0;  ///< revolution: across the axis; else of the translation across its largest direction
    double axis_deg = 0;   ///< revolution: of the direction of the axis; else of the rotation
};

/// The result of any registration.
struct Alignment {
    Eigen::Isometry3d reference_T_copy = Eigen::Isometry3d::Identity();  ///< from the copy's frame to the reference's
    bool converged = false;                ///< the last step was small against the uncertainty
    int iterations = 0;                    ///< steps of all stages together
    std::vector<FreeMotion> free_motions;  ///< those that the geometry leaves undetermined
    AlignmentUncertainty uncertainty;      ///< of the motions that are determined
    std::optional<Axis> reference_axis;  ///< of a body of revolution; toward the larger coordinate on its dominant axis
    Notes notes;                         ///< free and weak motions, several poses, turned end for end
};

}  // namespace lathelier::registration
