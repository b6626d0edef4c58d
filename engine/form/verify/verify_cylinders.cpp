#include <Eigen/Geometry>
#include <numbers>

#include "engine/core/random.h"
#include "engine/core/units.h"
#include "engine/form/cylinder/cylindricity.h"
#include "engine/form/cylinder/straightness.h"
#include "engine/form/verify/form_verification.h"

namespace lathelier::form {
namespace {

using Eigen::Vector3d;

Eigen::Isometry3d pose(int k)
{
    const Vector3d axis(std::sin(1.3 * k), std::cos(0.7 * k), 0.4);
    return Eigen::Translation3d(40.0 * k, -25, 10.0 * k) * Eigen::AngleAxisd(0.9 * k, axis.normalized()) *
           Eigen::Isometry3d::Identity();
}

/// Sections of points in any pose, `deviation(angle, u)` with u from -1 to 1 along the axis.
template <class Deviation>
std::vector<Vector3d> stack(double radius, double length, const Eigen::Isometry3d& at, Deviation deviation)
{
    constexpr int sections = 11, angles = 60;
    std::vector<Vector3d> points;
    for (int s = 0; s < sections; ++s)
        for (int i = 0; i < angles; ++i) {
            const double t = 2 * std::numbers::pi * i / angles, u = 2.0 * s / (sections - 1) - 1;
            const double r = radius + deviation(t, u);
            points.push_back(at * Vector3d(r * std::cos(t), r * std::sin(t), u * length / 2));
        }
    return points;
}

/// Distance between the axis found and the true one (z of `at`): at the middle and at half a length from it.
double axisError(const FittedCylinder& cylinder, const Eigen::Isometry3d& at, double length)
{
    const Vector3d axis = at.linear().col(2);
    const Vector3d off = cylinder.axis_point_mm - at.translation();
    const double tilt = cylinder.axis_direction.cross(axis).norm();
    return (off - axis * axis.dot(off)).norm() + tilt * length / 2;
}

const auto threeLobes = [](double t, double) { return 0.004 * std::cos(3 * t); };

}  // namespace

VerifyKind verifyLeastSquaresCylinders(const Progress& progress)
{
    VerifyTally tally("least_squares_cylinder", LT_TEXT("Engine", "Least-squares cylinder"), unit::mm, answerLimit_mm);
    for (int k = 0; k < 6; ++k) {
        const double length = k % 3 == 0 ? 8 : k % 3 == 1 ? 80 : 600;
        const Eigen::Isometry3d at = pose(k);
        const CylindricityResult result =
            cylindricity(stack(25, length, at, threeLobes), {}, progress.part(0, 0), NoiseEstimate::LeftOut);
        tally.nextSet();
        tally.take(axisError(result.LSCY, at, length));
        tally.compare(result.LSCY.radius_mm, 25);
        tally.compare(result.LSCY.CYLt_um / 1000, 0.008);
    }
    return tally.done();
}

VerifyKind verifyMinimumZoneCylinders(const Progress& progress)
{
    VerifyTally tally("minimum_zone_cylinder", LT_TEXT("Engine", "Minimum-zone cylinder"), unit::mm, answerLimit_mm);
    const auto zone = [&](const std::vector<Vector3d>& points) {
        tally.nextSet();
        return cylindricity(points, {}, progress.part(0, 0), NoiseEstimate::LeftOut).MZCY.CYLt_um / 1000;
    };
    for (int k = 0; k < 3; ++k) {
        tally.compare(zone(stack(25, 80, pose(k), threeLobes)), 0.008);
        tally.compare(zone(stack(25, 80, pose(k), [](double, double u) { return 0.0025 * u; })), 0.005);
        tally.compare(zone(stack(25, 80, pose(k), [](double, double u) { return 0.006 * u * u; })), 0.006);
    }
    return tally.done();
}

VerifyKind verifyStraightness()
{
    VerifyTally tally("straightness", LT_TEXT("Engine", "Straightness of an axis"), unit::mm, answerLimit_mm);
    for (int k = 0; k < 4; ++k) {
        std::vector<Vector3d> bow;  // x = 6 µm · u²: the mean of u² is 2/3, all residuals lie on one side of a plane
        for (const double u : {-1.0, 0.0, 1.0}) bow.push_back(pose(k) * Vector3d(0.006 * u * u, 0, 50 * u));
        const StraightnessResult result = straightness(bow);
        tally.nextSet();
        tally.compare(result.STRt_LSLI_um / 1000, 0.008);
        tally.compare(result.axis_straightness_um / 1000, 0.006);
    }
    return tally.done();
}

}  // namespace lathelier::form
