#include "engine/registration/revolution/revolution.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "engine/core/units.h"
#include "engine/registration/registration_codes.h"
#include "engine/registration/revolution/axial_shift_estimate.h"
#include "engine/registration/revolution/revolution_shift.h"

namespace lathelier::registration {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;

/// The part with z reversed.
TurnedPart reversedPart(const TurnedPart& part)
{
    TurnedPart result{reversed(part.fit), part.shoulders};
    std::reverse(result.shoulders.begin(), result.shoulders.end());
    for (Shoulder& s : result.shoulders) {
        s.z_mm = -s.z_mm;
        std::swap(s.before_mm, s.after_mm);
    }
    return result;
}

/// The smallest rotation that the free roll about z allows between reference and copy axis frames.
Isometry3d withLeastRoll(const Isometry3d& reference_axis, const Isometry3d& copy_axis, double shift)
{
    const Eigen::Matrix3d m = copy_axis.linear() * reference_axis.linear().transpose();
    const double roll = std::atan2(m(0, 1) - m(1, 0), m(0, 0) + m(1, 1));
    return reference_axis.inverse() * Eigen::Translation3d(0, 0, shift) * Eigen::AngleAxisd(roll, Vector3d::UnitZ()) *
           copy_axis;
}

}  // namespace

Axis axisOf(const RevolutionFit& fit)
{
    Axis axis;
    axis.direction = fit.axis_T_scan.linear().row(2);
    axis.point_mm = fit.axis_T_scan.inverse() * Vector3d(0, 0, middleOf(fit.profile));
    Eigen::Index dominant = 0;
    axis.direction.cwiseAbs().maxCoeff(&dominant);
    if (axis.direction[dominant] < 0) axis.direction = -axis.direction;
    return axis;
}

Alignment alignRevolution(const TurnedPart& reference, const TurnedPart& copy, InitialPose initial)
{
    const RadiusProfile& ref = reference.fit.profile;
    struct Way {
        TurnedPart part;
        ShiftMatch match;
        double home;
        double angle;
    };
    double largest = 0;
    for (const double r : ref.radius_mm)
        if (!std::isnan(r)) largest = std::max(largest, r);
    const double cap = std::max(0.02 * largest, 6 * std::hypot(reference.fit.sigma_mm, copy.fit.sigma_mm));
    std::optional<Way> best;
    for (const bool turned : {false, true}) {
        Way way{turned ? reversedPart(copy) : copy, {}, 0, 0};
        const Isometry3d& frame = way.part.fit.axis_T_scan;
        const double cosine = (reference.fit.axis_T_scan.linear() * frame.linear().transpose())(2, 2);
        if (initial == InitialPose::Identity && cosine < 0) continue;
        way.angle = std::acos(std::clamp(cosine, -1.0, 1.0));
        // Where the copy's middle lies along the reference's axis in the initial pose.
        const RadiusProfile& own = way.part.fit.profile;
        const Vector3d middle = frame.inverse() * Vector3d(0, 0, middleOf(own));
        way.home = (reference.fit.axis_T_scan * middle).z() - middleOf(own);
        const double span = (lengthOf(ref) + lengthOf(own)) / 2;
        way.match = initial == InitialPose::Identity
                        ? findShift(ref, own, way.home, 0.1 * lengthOf(own), way.home, cap)
                        : findShift(ref, own, middleOf(ref) - middleOf(own), span, way.home, cap);
        // A part that is symmetric end for end keeps the smaller rotation.
        const bool as_good = best && std::abs(way.match.cost - best->match.cost) < 0.005 * cap;
        if (!best || (as_good ? way.angle < best->angle : way.match.cost < best->match.cost)) best = way;
    }
    if (!best || !std::isfinite(best->match.cost)) throw Error(errors::partsDoNotMatch, {{"overlap_percent", 0.0}});

    Alignment result;
    result.iterations = reference.fit.iterations + copy.fit.iterations;
    double shift = best->match.shift;
    double variance = 0;
    bool is_settled = false;  // the last step was far below the uncertainty
    bool done = false;        // converged
    for (int i = 0; i < 10 && !done; ++i, ++result.iterations) {
        const auto verdict = estimateAxialShift(reference, best->part, shift);
        if (!verdict) {
            shift = best->home;
            is_settled = true;
            const Vector3d direction = reference.fit.axis_T_scan.linear().row(2);
            result.free_motions.push_back({FreeMotion::Kind::Translation, direction, Vector3d::Zero()});
            break;
        }
        const double change = std::abs(verdict->shift - shift);
        done = change < 1e-6 * std::sqrt(verdict->variance) || change < 1e-12 * lengthOf(ref);
        is_settled = done || change < 0.01 * std::sqrt(verdict->variance);
        shift = verdict->shift;
        variance = verdict->variance;
    }
    result.converged = is_settled && reference.fit.converged && copy.fit.converged;
    result.reference_T_copy = withLeastRoll(reference.fit.axis_T_scan, best->part.fit.axis_T_scan, shift);

    const Axis axis = axisOf(reference.fit);
    result.reference_axis = axis;
    for (FreeMotion& motion : result.free_motions) {
        motion.direction = axis.direction;
        motion.point_mm = axis.point_mm;
        result.notes.push_back(
            {notes::motionNotDetermined, {{"kind", LT_TEXT("Engine", "translation along the axis")}}});
    }
    result.free_motions.insert(result.free_motions.begin(),
                               {FreeMotion::Kind::Rotation, axis.direction, axis.point_mm});
    result.notes.insert(result.notes.begin(), {notes::rollNotDetermined, {}});
    if ((result.reference_T_copy.linear() * (copy.fit.axis_T_scan.linear().row(2).transpose()))
            .dot(copy.fit.axis_T_scan.linear().row(2)) < 0)
        result.notes.push_back({notes::endForEnd, {}});

    const Eigen::Matrix4d covariance = reference.fit.covariance + copy.fit.covariance;
    result.uncertainty.axial_um = 2 * um_per_mm * std::sqrt(variance);
    result.uncertainty.radial_um = 2 * um_per_mm * std::sqrt(covariance(0, 0) + covariance(1, 1));
    result.uncertainty.axis_deg = 2 * std::sqrt(covariance(2, 2) + covariance(3, 3)) * 180 / std::numbers::pi;
    return result;
}

}  // namespace lathelier::registration
