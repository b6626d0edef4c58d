// Which motions of a part the data determine, and how well.
// Source: N. Gelfand et al., "Geometrically stable sampling for the ICP algorithm", 3DIM 2003; limits from the
// project's measurements on shafts (a free roll 1e-4…5e-4 of the strongest motion, an axial motion held by shoulders 3
// %).
#pragma once

#include <Eigen/Core>
#include <vector>

#include "engine/registration/alignment.h"

namespace lathelier::registration {

using Matrix6d = Eigen::Matrix<double, 6, 6>;
using Vector6d = Eigen::Matrix<double, 6, 1>;

/// Normal equations of small motions about `centre_mm`: x = (rotation vector × gyration_mm, translation), both in mm.
struct MotionSystem {
    Eigen::Vector3d centre_mm = Eigen::Vector3d::Zero();
    double gyration_mm = 1;                   ///< root mean square distance of the points from the centre
    Matrix6d information = Matrix6d::Zero();  ///< sum of weight × J Jᵀ
    Matrix6d noise = Matrix6d::Zero();        ///< what noise of the normals contributes to `information`
    Vector6d gradient = Vector6d::Zero();     ///< sum of weight × J × residual
    double weight = 0;                        ///< sum of weights
};

/// The motions split by the data.
struct Observability {
    Matrix6d determined = Matrix6d::Identity();  ///< projects a motion to what the data determine
    Matrix6d inverse = Matrix6d::Zero();         ///< of `information`, on the determined motions
    std::vector<FreeMotion> free_motions;        ///< below 3e-3 of the strongest motion
    std::vector<FreeMotion> weak_motions;        ///< below 5 %
};

Observability analyse(const MotionSystem& system);

/// The rigid motion of x; exact for any angle.
Eigen::Isometry3d motion(const MotionSystem& system, const Vector6d& x);

/// The x whose motion turns `from` into `to`; the rotation is below 180°.
Vector6d difference(const MotionSystem& system, const Eigen::Isometry3d& from, const Eigen::Isometry3d& to);

/// Expanded uncertainty (k = 2) of a motion x with this covariance: the radius that holds the translation of the centre
/// with 95.45 % (twice the standard deviation where one direction dominates), the same across its largest direction,
/// and of the rotation.
AlignmentUncertainty uncertaintyOf(const MotionSystem& system, const Matrix6d& covariance);

/// The same for independent residuals of standard deviation `sigma_mm`.
AlignmentUncertainty uncertainty(const MotionSystem& system, const Observability& observability, double sigma_mm);

}  // namespace lathelier::registration
