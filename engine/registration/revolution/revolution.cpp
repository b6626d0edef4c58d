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

/// When two alignments are equally good, and when the shift has settled (README, "Thresholds").
struct AlignmentThresholds {
    double cap_share = 0.02;         ///< of the largest radius: a larger difference of the radii counts as this;
    double cap_sigmas = 6;           ///< the same in standard deviations of the scatter, where that is more
    double as_good_share = 0.005;    ///< of the cap: alignments whose costs differ by less are equally good
    double possible_share = 0.1;     ///< of the cap: of two whose costs differ by more, the costlier is wrong
    double difference_sigmas = 3;    ///< of the mean differences of two alignments: by chance in 0.3 %
    double same_overlap = 0.01;      ///< difference of two overlaps that is none
    double near_share = 0.1;         ///< of the length: the reach of a search near the pose as scanned
    double kept_overlap = 0.5;       ///< for the pose as scanned to be kept, without a determined shift
    int most_iterations = 10;        ///< of the shift
    double last_step_sigmas = 1e-6;  ///< standard uncertainties of the shift: a smaller step is the last,
    double last_step_share = 1e-12;  ///< and so is one below this share of the length
    double settled_sigmas = 0.01;    ///< a shift whose last step is smaller has settled
};
constexpr AlignmentThresholds alignmentThresholds{};

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
               double initial_shift, double as_good_mm)
{
    Settled result;
    result.match = start;
    for (bool done = false; !done && result.iterations < alignmentThresholds.most_iterations;) {
        ++result.iterations;
        const auto found = estimateAxialShift(reference, copy, result.match.shift);
        if (!found) {
            // Where the parts agree as they were scanned they stay there.
            result = {start, 0, false, true, result.iterations};
            const ShiftMatch as_scanned = search.at(initial_shift);
            if (as_scanned.overlap >= alignmentThresholds.kept_overlap &&
                as_scanned.difference_mm < start.difference_mm + as_good_mm)
                result.match = as_scanned;
            return result;
        }
        const double change = std::abs(found->shift - result.match.shift);
        const double sigma = std::sqrt(found->variance);
        done = change < alignmentThresholds.last_step_sigmas * sigma ||
               change < alignmentThresholds.last_step_share * lengthOf(reference.fit.profile);
        result.is_settled = done || change < alignmentThresholds.settled_sigmas * sigma;
        result.match.shift = found->shift;
        result.variance = found->variance;
        result.is_determined = true;
    }
    result.match = search.at(result.match.shift);
    return result;
}

/// An alignment of the copy in one direction of its axis.
struct AlignmentCandidate {
    TurnedPart copy;
    double angle = 0;  ///< by which the copy is turned from its initial pose, rad
    double off_initial = 0;
    Settled settled;
};

/// Whether the radii of one alignment agree better than those of another, where the costs leave both possible.
bool isSurelyBetter(const ShiftMatch& a, const ShiftMatch& b)
{
    const double noise_mm =
        alignmentThresholds.difference_sigmas * std::hypot(a.difference_sigma_mm, b.difference_sigma_mm);
    return a.difference_mm < b.difference_mm - noise_mm;
}

/// Where the cost leaves both possible, because one of them has a little more in common, the one whose radii agree
/// better is right. A part that is symmetric end for end keeps the smaller rotation, one that fits at several shifts
/// the smaller shift.
bool isBetter(const AlignmentCandidate& candidate, const AlignmentCandidate& other, double cap_mm)
{
    const ShiftMatch& a = candidate.settled.match;
    const ShiftMatch& b = other.settled.match;
    const double cost_difference_mm = std::abs(a.cost - b.cost);
    if (cost_difference_mm < alignmentThresholds.possible_share * cap_mm &&
        (isSurelyBetter(a, b) || isSurelyBetter(b, a)))
        return isSurelyBetter(a, b);
    if (cost_difference_mm >= alignmentThresholds.as_good_share * cap_mm) return a.cost < b.cost;
    return candidate.angle != other.angle ? candidate.angle < other.angle : candidate.off_initial < other.off_initial;
}

/// Turned end for end the two fit as well, but other parts of them lie on each other: scans of a symmetric part that
/// lost its ends. Which direction is right, and so where along the axis, cannot be known.
bool isAmbiguous(const AlignmentCandidate& best, const AlignmentCandidate& other, double cap_mm)
{
    const ShiftMatch& a = best.settled.match;
    const ShiftMatch& b = other.settled.match;
    return best.angle != other.angle && std::abs(a.cost - b.cost) < alignmentThresholds.possible_share * cap_mm &&
           !isSurelyBetter(a, b) && std::abs(a.overlap - b.overlap) > alignmentThresholds.same_overlap;
}

/// The alignments of one direction from all starts that are worth while. `candidate`: the copy in that direction, with
/// its angle.
void addCandidates(const TurnedPart& reference, AlignmentCandidate candidate, InitialPose initial, double cap_mm,
                   std::vector<AlignmentCandidate>& candidates)
{
    const RadiusProfile& ref = reference.fit.profile;
    const RadiusProfile& own = candidate.copy.fit.profile;
    // Where the copy's middle lies along the reference's axis in the initial pose.
    const Vector3d middle = candidate.copy.fit.axis_T_scan.inverse() * Vector3d(0, 0, middleOf(own));
    const double initial_shift = (reference.fit.axis_T_scan * middle).z() - middleOf(own);
    const ShiftSearch search(reference, candidate.copy, cap_mm);
    const auto starts =
        initial == InitialPose::Identity
            ? search.starts(initial_shift, alignmentThresholds.near_share * lengthOf(own), initial_shift)
            : search.starts(middleOf(ref) - middleOf(own), (lengthOf(ref) + lengthOf(own)) / 2, initial_shift);
    for (const ShiftMatch& start : starts) {
        candidate.settled =
            settle(reference, candidate.copy, search, start, initial_shift, alignmentThresholds.as_good_share * cap_mm);
        candidate.off_initial = std::abs(candidate.settled.match.shift - initial_shift);
        if (std::isfinite(candidate.settled.match.cost)) candidates.push_back(candidate);
    }
}

/// The alignment with the least difference, of all starts in both directions.
std::optional<AlignmentCandidate> findBestCandidate(const TurnedPart& reference, const TurnedPart& copy,
                                                    InitialPose initial)
{
    const double noise_mm = std::hypot(reference.fit.sigma_mm, copy.fit.sigma_mm);
    const double cap_mm = std::max(alignmentThresholds.cap_share * reference.fit.profile.largestRadius_mm(),
                                   alignmentThresholds.cap_sigmas * noise_mm);
    std::vector<AlignmentCandidate> candidates;
    for (const bool is_turned : {false, true}) {
        AlignmentCandidate candidate;
        candidate.copy = is_turned ? reversedPart(copy) : copy;
        const double cosine =
            (reference.fit.axis_T_scan.linear() * candidate.copy.fit.axis_T_scan.linear().transpose())(2, 2);
        if (initial == InitialPose::Identity && cosine < 0) continue;
        candidate.angle = std::acos(std::clamp(cosine, -1.0, 1.0));
        addCandidates(reference, std::move(candidate), initial, cap_mm, candidates);
    }
    if (candidates.empty()) return std::nullopt;
    AlignmentCandidate best = candidates.front();
    for (const AlignmentCandidate& other : candidates)
        if (isBetter(other, best, cap_mm)) best = other;
    if (std::any_of(candidates.begin(), candidates.end(),
                    [&](const AlignmentCandidate& other) { return isAmbiguous(best, other, cap_mm); }))
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
    const std::optional<AlignmentCandidate> best = findBestCandidate(reference, copy, initial);
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
