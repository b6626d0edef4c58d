#include "engine/registration/revolution/revolution.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

#include "engine/core/units.h"
#include "engine/registration/registration_codes.h"
#include "engine/registration/revolution/axial_shift_estimate.h"
#include "engine/registration/revolution/revolution_shift.h"

namespace lathelier::registration {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;

constexpr double capShare = 0.02;              // of the largest radius: a larger difference of the radii counts as this
constexpr double capSigmas = 6;                // the same in standard deviations of the scatter, where that is more
constexpr double asGoodShare = 0.005;          // of the cap: alignments whose costs differ by less are equally good
constexpr double possibleShare = 0.1;          // of the cap: of two whose costs differ by more, the dearer is wrong
constexpr double differenceSigmas = 3;         // of the mean differences of two alignments, when not by chance
constexpr double sameOverlap = 0.01;           // difference of two overlaps that is none
constexpr double nearShare = 0.1;              // of the length: the reach of a search near the pose as scanned
constexpr double leastOverlapAsScanned = 0.5;  // without a determined shift, for the pose as scanned to be kept

/// The part with z reversed.
TurnedPart reversedPart(const TurnedPart& part)
{
    TurnedPart result{reversed(part.fit), part.shoulders, part.ends};
    for (std::vector<Shoulder>* faces : {&result.shoulders, &result.ends}) {
        std::reverse(faces->begin(), faces->end());
        for (Shoulder& s : *faces) {
            s.z_mm = -s.z_mm;
            std::swap(s.before_mm, s.after_mm);
        }
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

/// An alignment from one start.
struct Settled {
    ShiftMatch match;            ///< at the shift found
    double variance = 0;         ///< of the shift, mm²
    bool is_determined = false;  ///< shoulders, tapers or ends determine the shift
    bool is_settled = true;      ///< the last step was far below the uncertainty
    int iterations = 0;
};

Settled settle(const TurnedPart& reference, const TurnedPart& copy, const ShiftSearch& search, const ShiftMatch& start,
               double home, double as_good_mm)
{
    constexpr int mostIterations = 10;
    Settled result;
    result.match = start;
    for (bool done = false; !done && result.iterations < mostIterations;) {
        ++result.iterations;
        const auto found = estimateAxialShift(reference, copy, result.match.shift);
        if (!found) {
            // Where the parts agree as they were scanned they stay there.
            result = {start, 0, false, true, result.iterations};
            const ShiftMatch as_scanned = search.at(home);
            if (as_scanned.overlap >= leastOverlapAsScanned &&
                as_scanned.difference_mm < start.difference_mm + as_good_mm)
                result.match = as_scanned;
            return result;
        }
        const double change = std::abs(found->shift - result.match.shift);
        done = change < 1e-6 * std::sqrt(found->variance) || change < 1e-12 * lengthOf(reference.fit.profile);
        result.is_settled = done || change < 0.01 * std::sqrt(found->variance);
        result.match.shift = found->shift;
        result.variance = found->variance;
        result.is_determined = true;
    }
    result.match = search.at(result.match.shift);
    return result;
}

/// A direction of the copy's axis with the best alignment in it.
struct Way {
    TurnedPart copy;
    double angle = 0;  ///< by which the copy is turned from its initial pose, rad
    double off_home = 0;
    Settled settled;
};

/// Whether the radii of one alignment agree better than those of another, where the costs leave both possible.
bool isSurelyBetter(const ShiftMatch& a, const ShiftMatch& b)
{
    const double noise_mm = differenceSigmas * std::hypot(a.difference_sigma_mm, b.difference_sigma_mm);
    return a.difference_mm < b.difference_mm - noise_mm;
}

/// Where the cost leaves both possible, because one of them has a little more in common, the one whose radii agree
/// better is right. A part that is symmetric end for end keeps the smaller rotation, one that fits at several shifts
/// the smaller shift.
bool isBetter(const Way& way, const Way& other, double cap_mm)
{
    const ShiftMatch& a = way.settled.match;
    const ShiftMatch& b = other.settled.match;
    const double dearer_mm = std::abs(a.cost - b.cost);
    if (dearer_mm < possibleShare * cap_mm && (isSurelyBetter(a, b) || isSurelyBetter(b, a)))
        return isSurelyBetter(a, b);
    if (dearer_mm >= asGoodShare * cap_mm) return a.cost < b.cost;
    return way.angle != other.angle ? way.angle < other.angle : way.off_home < other.off_home;
}

/// Turned end for end the two fit as well, but other parts of them lie on each other: scans of a symmetric part that
/// lost its ends. Which way is right, and so where along the axis, cannot be known.
bool isAmbiguous(const Way& best, const Way& other, double cap_mm)
{
    const ShiftMatch& a = best.settled.match;
    const ShiftMatch& b = other.settled.match;
    return best.angle != other.angle && std::abs(a.cost - b.cost) < possibleShare * cap_mm && !isSurelyBetter(a, b) &&
           std::abs(a.overlap - b.overlap) > sameOverlap;
}

/// The alignment with the least difference, of all starts in both directions.
std::optional<Way> findBestWay(const TurnedPart& reference, const TurnedPart& copy, InitialPose initial)
{
    const RadiusProfile& ref = reference.fit.profile;
    double largest = 0;
    for (const double r : ref.radius_mm)
        if (!std::isnan(r)) largest = std::max(largest, r);
    const double cap_mm =
        std::max(capShare * largest, capSigmas * std::hypot(reference.fit.sigma_mm, copy.fit.sigma_mm));
    const double as_good_mm = asGoodShare * cap_mm;
    std::vector<Way> ways;
    for (const bool is_turned : {false, true}) {
        Way way;
        way.copy = is_turned ? reversedPart(copy) : copy;
        const Isometry3d& frame = way.copy.fit.axis_T_scan;
        const double cosine = (reference.fit.axis_T_scan.linear() * frame.linear().transpose())(2, 2);
        if (initial == InitialPose::Identity && cosine < 0) continue;
        way.angle = std::acos(std::clamp(cosine, -1.0, 1.0));
        // Where the copy's middle lies along the reference's axis in the initial pose.
        const RadiusProfile& own = way.copy.fit.profile;
        const Vector3d middle = frame.inverse() * Vector3d(0, 0, middleOf(own));
        const double home = (reference.fit.axis_T_scan * middle).z() - middleOf(own);
        const ShiftSearch search(reference, way.copy, cap_mm);
        const bool is_near = initial == InitialPose::Identity;
        const auto starts =
            is_near ? search.starts(home, nearShare * lengthOf(own), home)
                    : search.starts(middleOf(ref) - middleOf(own), (lengthOf(ref) + lengthOf(own)) / 2, home);
        for (const ShiftMatch& start : starts) {
            way.settled = settle(reference, way.copy, search, start, home, as_good_mm);
            way.off_home = std::abs(way.settled.match.shift - home);
            if (!std::isfinite(way.settled.match.cost)) continue;
            ways.push_back(way);
        }
    }
    if (ways.empty()) return std::nullopt;
    Way best = ways.front();
    for (const Way& other : ways)
        if (isBetter(other, best, cap_mm)) best = other;
    if (std::any_of(ways.begin(), ways.end(), [&](const Way& other) { return isAmbiguous(best, other, cap_mm); }))
        best.settled.is_determined = false;
    return best;
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
    const std::optional<Way> best = findBestWay(reference, copy, initial);
    if (!best) throw Error(errors::partsDoNotMatch, {{"overlap_percent", 0.0}});

    Alignment result;
    const Settled& settled = best->settled;
    result.iterations = reference.fit.iterations + copy.fit.iterations + settled.iterations;
    result.converged = settled.is_settled && reference.fit.converged && copy.fit.converged;
    result.reference_T_copy = withLeastRoll(reference.fit.axis_T_scan, best->copy.fit.axis_T_scan, settled.match.shift);

    const Axis axis = axisOf(reference.fit);
    result.reference_axis = axis;
    result.free_motions.push_back({FreeMotion::Kind::Rotation, axis.direction, axis.point_mm});
    result.notes.push_back({notes::rollNotDetermined, {}});
    if (!settled.is_determined) {
        result.free_motions.push_back({FreeMotion::Kind::Translation, axis.direction, axis.point_mm});
        result.notes.push_back(
            {notes::motionNotDetermined, {{"kind", LT_TEXT("Engine", "translation along the axis")}}});
    }
    if ((result.reference_T_copy.linear() * (copy.fit.axis_T_scan.linear().row(2).transpose()))
            .dot(copy.fit.axis_T_scan.linear().row(2)) < 0)
        result.notes.push_back({notes::endForEnd, {}});

    const Eigen::Matrix4d covariance = reference.fit.covariance + copy.fit.covariance;
    result.uncertainty.axial_um = settled.is_determined ? 2 * um_per_mm * std::sqrt(settled.variance) : notANumber;
    result.uncertainty.radial_um = 2 * um_per_mm * std::sqrt(covariance(0, 0) + covariance(1, 1));
    result.uncertainty.axis_deg = 2 * std::sqrt(covariance(2, 2) + covariance(3, 3)) * 180 / std::numbers::pi;
    return result;
}

}  // namespace lathelier::registration
