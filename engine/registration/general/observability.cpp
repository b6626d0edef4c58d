#include "engine/registration/general/observability.h"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "engine/core/small_solve.h"

namespace lathelier::registration {
namespace {

constexpr double freeMotionLimit = 3e-3;
constexpr double weakMotionLimit = 0.05;
constexpr double translationRotationShare = 0.2;  // rotation part of a unit motion

// Turns a basis of motions into translations and rotations about axes.
std::vector<FreeMotion> motionsOf(const std::vector<Vector6d>& basis, const MotionSystem& system)
{
    if (basis.empty()) return {};
    Eigen::MatrixXd motions(6, static_cast<Eigen::Index>(basis.size()));
    for (std::size_t i = 0; i < basis.size(); ++i) motions.col(static_cast<Eigen::Index>(i)) = basis[i];
    // Combinations in order of decreasing rotation part: the last ones are translations.
    const Eigen::MatrixXd sorted = motions * rightSingularVectors(motions.topRows(3));
    std::vector<FreeMotion> result;
    std::vector<Eigen::Vector3d> translations;
    for (Eigen::Index i = sorted.cols() - 1; i >= 0; --i) {
        const Eigen::Vector3d turn = sorted.col(i).head<3>() / system.gyration_mm;
        Eigen::Vector3d shift = sorted.col(i).tail<3>();
        FreeMotion motion;
        if (turn.norm() * system.gyration_mm < translationRotationShare) {
            motion.kind = FreeMotion::Kind::Translation;
            motion.direction = shift.normalized();
            motion.point_mm = system.centre_mm;
            translations.push_back(motion.direction);
        } else {
            for (const Eigen::Vector3d& t : translations) shift -= t * t.dot(shift);
            motion.direction = turn.normalized();
            motion.point_mm = system.centre_mm + turn.cross(shift) / turn.squaredNorm();
        }
        Eigen::Index largest = 0;
        motion.direction.cwiseAbs().maxCoeff(&largest);
        if (motion.direction[largest] < 0) motion.direction = -motion.direction;
        result.insert(result.begin(), motion);
    }
    return result;
}

// Radius that holds a normal vector of these variances with 95.45 %: the sum of squares as a scaled chi-square of equal
// mean and variance (F. E. Satterthwaite, Biometrics Bulletin 2, 1946), its quantile after Wilson and Hilferty.
double expandedRadius(const Eigen::Vector3d& variances)
{
    const Eigen::Vector3d v = variances.cwiseMax(0);
    const double mean = v.sum();
    if (!(mean > 0)) return 0;
    const double freedom = mean * mean / v.squaredNorm();
    constexpr double quantile = 1.717;  // 1.690, corrected so that one degree of freedom gives 2² exactly
    const double root = 1 - 2 / (9 * freedom) + quantile * std::sqrt(2 / (9 * freedom));
    return std::sqrt(mean * root * root * root);
}

}  // namespace

Observability analyse(const MotionSystem& system)
{
    Observability result;
    const SymmetricAxes<6> axes = symmetricAxes(system.information);
    const double strongest = axes.values[5];
    std::vector<Vector6d> free_basis;
    std::vector<Vector6d> weak_basis;
    result.determined.setZero();
    for (int i = 0; i < 6; ++i) {
        const Vector6d direction = axes.vectors.col(i);
        const double value = axes.values[i] - direction.dot(system.noise * direction);
        if (!(value >= freeMotionLimit * strongest)) {
            free_basis.push_back(direction);
            continue;
        }
        if (value < weakMotionLimit * strongest) weak_basis.push_back(direction);
        result.determined += direction * direction.transpose();
        result.inverse += direction * direction.transpose() / axes.values[i];
    }
    result.free_motions = motionsOf(free_basis, system);
    result.weak_motions = motionsOf(weak_basis, system);
    return result;
}

Eigen::Isometry3d motion(const MotionSystem& system, const Vector6d& x)
{
    const Eigen::Vector3d turn = x.head<3>() / system.gyration_mm;
    const double angle = turn.norm();
    Eigen::Isometry3d result = Eigen::Isometry3d::Identity();
    if (angle > 0) result.linear() = Eigen::AngleAxisd(angle, turn / angle).toRotationMatrix();
    result.translation() = system.centre_mm + x.tail<3>() - result.linear() * system.centre_mm;
    return result;
}

Vector6d difference(const MotionSystem& system, const Eigen::Isometry3d& from, const Eigen::Isometry3d& to)
{
    const Eigen::Isometry3d change = to * from.inverse();
    const Eigen::AngleAxisd turn(change.linear());
    double angle = turn.angle();
    if (angle > std::numbers::pi) angle -= 2 * std::numbers::pi;
    Vector6d x;
    x.head<3>() = angle * turn.axis() * system.gyration_mm;
    x.tail<3>() = change * system.centre_mm - system.centre_mm;
    return x;
}

AlignmentUncertainty uncertaintyOf(const MotionSystem& system, const Matrix6d& covariance)
{
    const Eigen::Vector3d shift = symmetricAxes(Eigen::Matrix3d(covariance.bottomRightCorner<3, 3>())).values;
    const Eigen::Vector3d turn = symmetricAxes(Eigen::Matrix3d(covariance.topLeftCorner<3, 3>())).values;
    AlignmentUncertainty result;
    result.axial_um = 1000 * expandedRadius(shift);
    result.radial_um = 1000 * expandedRadius(Eigen::Vector3d(shift[0], shift[1], 0));
    result.axis_deg = expandedRadius(turn) / system.gyration_mm * 180 / std::numbers::pi;
    return result;
}

AlignmentUncertainty uncertainty(const MotionSystem& system, const Observability& observability, double sigma_mm)
{
    return uncertaintyOf(system, sigma_mm * sigma_mm * observability.inverse);
}

}  // namespace lathelier::registration
