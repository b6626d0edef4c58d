#include "engine/registration/revolution.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

namespace lathelier {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;

constexpr double kToUm = 1e3;

/// The part with z reversed.
TurnedPart reversed(const TurnedPart& part)
{
    TurnedPart result{lathelier::reversed(part.fit), part.shoulders};
    std::reverse(result.shoulders.begin(), result.shoulders.end());
    for (Shoulder& s : result.shoulders) {
        s.z_mm = -s.z_mm;
        std::swap(s.before_mm, s.after_mm);
    }
    return result;
}

/// Radius at z between two known bins, with slope and uncertainty; nullopt where either is unknown.
struct Reading {
    double radius, slope, sigma;
};
std::optional<Reading> read(const RadiusProfile& p, double z)
{
    const double place = (z - p.z_start_mm) / p.step_mm - 0.5;
    if (!(place >= 0) || place >= static_cast<double>(p.size()) - 1) return std::nullopt;
    const auto i = static_cast<std::size_t>(place);
    const double t = place - static_cast<double>(i);
    const double radius = (1 - t) * p.radius_mm[i] + t * p.radius_mm[i + 1];
    if (std::isnan(radius)) return std::nullopt;
    return Reading{radius, (p.radius_mm[i + 1] - p.radius_mm[i]) / p.step_mm,
                   std::hypot((1 - t) * p.sigma_mm[i], t * p.sigma_mm[i + 1])};
}

struct Match {
    double shift = 0;  ///< reference z = copy z + shift
    double cost = std::numeric_limits<double>::infinity();
};

/// Cost of one shift: mean difference of the radii, capped, plus half the cap for what does not overlap.
double costOf(const RadiusProfile& reference, const RadiusProfile& copy, double shift, double cap, std::size_t stride)
{
    double sum = 0;
    double both = 0;
    double all = 0;
    for (std::size_t i = 0; i < copy.size(); i += stride) {
        if (std::isnan(copy.radius_mm[i])) continue;
        ++all;
        const auto there = read(reference, copy.middle_mm(i) + shift);
        if (!there) continue;
        ++both;
        sum += std::min(cap, std::abs(there->radius - copy.radius_mm[i]));
    }
    double known = 0;
    for (const double r : reference.radius_mm) known += std::isnan(r) ? 0 : 1;
    const double length = std::min(all * copy.step_mm * static_cast<double>(stride), known * reference.step_mm);
    const double overlap = std::min(1.0, both * copy.step_mm * static_cast<double>(stride) / length);
    if (overlap < 0.25) return std::numeric_limits<double>::infinity();
    return sum / both + 0.5 * cap * (1 - overlap);
}

double lengthOf(const RadiusProfile& p)
{
    return p.step_mm * static_cast<double>(p.size());
}
double middleOf(const RadiusProfile& p)
{
    return p.z_start_mm + lengthOf(p) / 2;
}

/// Best shift within `reach` of `centre`: a coarse scan, then finer ones around the best. `home` breaks ties: among
/// equally good shifts the nearest to it wins.
Match findShift(const RadiusProfile& reference, const RadiusProfile& copy, double centre, double reach, double home,
                double cap)
{
    Match best;
    double step = std::max(reference.step_mm, copy.step_mm);
    const double even = 1e-3 * cap;  // differences below this are noise
    const auto scan = [&](double from, double to, std::size_t stride) {
        const int count = static_cast<int>((to - from) / step) + 1;
        std::vector<Match> matches;
        for (int k = 0; k <= count; ++k) {
            const double shift = from + k * step;
            matches.push_back({shift, costOf(reference, copy, shift, cap, stride)});
        }
        double least = std::numeric_limits<double>::infinity();
        for (const Match& m : matches) least = std::min(least, m.cost);
        for (const Match& m : matches)
            if (m.cost <= least + even &&
                (best.cost > least + even || std::abs(m.shift - home) < std::abs(best.shift - home)))
                best = m;
    };
    scan(centre - reach, centre + reach, 4);
    if (!std::isfinite(best.cost)) return best;
    for (int i = 0; i < 3; ++i) {
        const double around = best.shift;
        const double width = 4 * step;
        if (i > 0) step /= 4;
        best.cost = std::numeric_limits<double>::infinity();
        scan(around - width, around + width, 1);
    }
    return best;
}

/// What one shoulder or slope says about the shift.
struct Witness {
    double shift;
    double variance;
    bool slope;
    int facing;  ///< of a shoulder, in the reference
};

void askShoulders(const TurnedPart& reference, const TurnedPart& copy, double shift, std::vector<Witness>& witnesses)
{
    const double near = 4 * std::max(reference.fit.profile.step_mm, copy.fit.profile.step_mm);
    for (const Shoulder& c : copy.shoulders) {
        const Shoulder* found = nullptr;
        for (const Shoulder& r : reference.shoulders) {
            const double height = std::abs(r.after_mm - r.before_mm);
            if (r.facing() != c.facing() || std::abs(r.z_mm - c.z_mm - shift) > near) continue;
            if (std::abs(std::abs(c.after_mm - c.before_mm) - height) > 0.3 * height) continue;
            if (!found || std::abs(r.z_mm - c.z_mm - shift) < std::abs(found->z_mm - c.z_mm - shift)) found = &r;
        }
        if (!found) continue;
        const double floor = 1e-9 * lengthOf(reference.fit.profile);
        witnesses.push_back({found->z_mm - c.z_mm,
                             found->sigma_mm * found->sigma_mm + c.sigma_mm * c.sigma_mm + floor * floor, false,
                             found->facing()});
    }
}

constexpr double kLeastSlope = 0.03;

/// Difference of the radii (copy less reference) in a bin where both are cylinders, with its variance.
struct Difference {
    double off, variance;
};
std::optional<Difference> levelDifference(const RadiusProfile& reference, const RadiusProfile& copy, double shift,
                                          std::size_t bin)
{
    const auto level = [](const RadiusProfile& p, std::size_t i) {  // and no kink next to it
        if (i < 1 || i + 1 >= p.size() || !(std::abs(p.slope[i]) < kLeastSlope)) return false;
        const double most = 0.1 * p.step_mm;
        return std::abs(p.radius_mm[i] - p.radius_mm[i - 1]) < most &&
               std::abs(p.radius_mm[i + 1] - p.radius_mm[i]) < most;
    };
    const double place = copy.middle_mm(bin) + shift;
    const auto there = read(reference, place);
    if (!level(copy, bin) || !there) return std::nullopt;
    if (!level(reference, static_cast<std::size_t>((place - reference.z_start_mm) / reference.step_mm)))
        return std::nullopt;
    return Difference{copy.radius_mm[bin] - there->radius,
                      there->sigma * there->sigma + copy.sigma_mm[bin] * copy.sigma_mm[bin]};
}

/// How much the radii of the two parts differ where they are cylinders, beyond the scatter: mean square, mm².
double differenceOfForm(const RadiusProfile& reference, const RadiusProfile& copy, double shift)
{
    double sum = 0, count = 0;
    for (std::size_t i = 0; i < copy.size(); ++i)
        if (const auto d = levelDifference(reference, copy, shift, i)) {
            sum += d->off * d->off - d->variance;
            count += 1;
        }
    return count > 0 ? std::max(0.0, sum / count) : 0;
}

/// Difference of the radii where a cylinder meets the slope that begins or ends beside bin `from`: a line through the
/// nearest bins of the cylinder, extended to that place. nullopt: no cylinder there.
std::optional<Difference> differenceBeside(const RadiusProfile& reference, const RadiusProfile& copy, double shift,
                                           std::ptrdiff_t from, std::ptrdiff_t step)
{
    constexpr int kKink = 8, kBins = 48;
    int patience = 4;  // with bins whose slope is only noise
    double n = 0, sx = 0, sxx = 0, sy = 0, sxy = 0, variance = 0;
    for (std::ptrdiff_t k = 0; k < kKink + kBins; ++k) {
        const std::ptrdiff_t i = from + step * k;
        if (i < 0 || i >= static_cast<std::ptrdiff_t>(copy.size())) break;
        const auto d = levelDifference(reference, copy, shift, static_cast<std::size_t>(i));
        if (!d && (n > 0 ? --patience : kKink - k) <= 0) break;
        if (!d) continue;
        const auto x = static_cast<double>(k);
        n += 1;
        sx += x;
        sxx += x * x;
        sy += d->off;
        sxy += x * d->off;
        variance += d->variance;
    }
    const double spread = n * sxx - sx * sx;
    if (n < 6 || spread <= 0) return std::nullopt;
    return Difference{(sxx * sy - sx * sxy) / spread, variance / n * sxx / spread};
}

/// Slopes: in every run of bins that slope the same way, the shift that brings the radii together. A slope tells the
/// place only as well as the copy has the radii of the reference: its radius is taken to differ by what that of the
/// cylinders beside it does (they were turned together), as far as that can be told from noise, and by 3 % of what
/// radii differ on the whole; without a cylinder beside it, by all of that.
void askSlopes(const RadiusProfile& reference, const RadiusProfile& copy, double shift, std::vector<Witness>& witnesses)
{
    constexpr double kOwn = 0.03 * 0.03;
    const double whole = differenceOfForm(reference, copy, shift);
    double weight = 0, sum = 0, lever = 0;
    int sign = 0;
    std::ptrdiff_t first = 0;
    const auto finish = [&](std::size_t end) {
        if (weight > 0) {
            double difference = 0, sides = 0;
            for (const auto& beside : {differenceBeside(reference, copy, shift, first - 1, -1),
                                       differenceBeside(reference, copy, shift, static_cast<std::ptrdiff_t>(end), 1)})
                if (beside && whole > 0) {
                    // what is expected, given that radii differ by `whole` in the mean square and this is what was seen
                    const double trust = whole / (whole + beside->variance);
                    difference += trust * trust * beside->off * beside->off + trust * beside->variance;
                    sides += 1;
                }
            difference = sides > 0 ? difference / sides + kOwn * whole : whole;
            const double bias = lever / weight;
            witnesses.push_back({shift + sum / weight, 1 / weight + difference * bias * bias, true, 0});
        }
        weight = sum = lever = 0;
        sign = 0;
    };
    const auto smooth = [](const RadiusProfile& p, std::size_t i) {  // no kink and no edge next to it
        if (i < 1 || i + 1 >= p.size()) return false;
        const double q = p.slope[i];
        for (const std::size_t k : {i - 1, i + 1})
            if (std::isnan(p.radius_mm[k]) || std::abs(p.slope[k] - q) > 0.25 * std::abs(q)) return false;
        return true;
    };
    for (std::size_t i = 0; i < copy.size(); ++i) {
        const double q = copy.slope[i];
        const bool sloped = !std::isnan(copy.radius_mm[i]) && std::abs(q) > kLeastSlope && smooth(copy, i);
        if (!sloped || (sign != 0 && (q > 0) != (sign > 0))) finish(i);
        if (!sloped) continue;
        const double place = copy.middle_mm(i) + shift;
        const auto there = read(reference, place);
        const double bin = (place - reference.z_start_mm) / reference.step_mm;
        if (!there || !smooth(reference, static_cast<std::size_t>(bin))) continue;
        if (sign == 0) first = static_cast<std::ptrdiff_t>(i);
        sign = q > 0 ? 1 : -1;
        const double slope = (there->slope + q) / 2;
        const double variance =
            there->sigma * there->sigma + copy.sigma_mm[i] * copy.sigma_mm[i] + 1e-18 * there->radius * there->radius;
        // reference(z + shift + d) = copy(z): slope · d = copy - reference
        weight += slope * slope / variance;
        lever += slope / variance;
        sum += slope * (copy.radius_mm[i] - there->radius) / variance;
    }
    finish(copy.size());
}

struct Shift {
    double shift;
    double variance;
};

Shift mean(const std::vector<Witness>& witnesses)
{
    double weight = 0, sum = 0;
    for (const Witness& w : witnesses) {
        weight += 1 / w.variance;
        sum += w.shift / w.variance;
    }
    return {sum / weight, 1 / weight};
}

/// Two scans may see every shoulder moved outward by a different amount (another spot, another handling of mixed
/// pixels). Shoulders that face both ways tell: half of what the two kinds differ beyond their uncertainty is taken out
/// as a displacement that all share, with its own prior variance; shoulders that all face one way stay as they are.
void removeFacingBias(std::vector<Witness>& shoulders)
{
    std::vector<Witness> up, down;
    for (const Witness& w : shoulders) (w.facing > 0 ? up : down).push_back(w);
    if (up.empty() || down.empty()) return;
    const Shift a = mean(up);
    const Shift b = mean(down);
    const double half = (a.shift - b.shift) / 2;
    const double noise = (a.variance + b.variance) / 4;
    const double prior = half * half - 2 * noise;
    if (prior <= 0) return;
    const double bias = half * prior / (prior + noise);
    for (Witness& w : shoulders) w.shift -= w.facing > 0 ? bias : -bias;
}

/// Adds to the variances of a group what its members differ beyond their own uncertainty (the moment estimator of
/// DerSimonian and Laird, 1986).
void settleAmong(std::vector<Witness>& group)
{
    if (group.size() < 2) return;
    const Shift centre = mean(group);
    double q = 0, w1 = 0, w2 = 0;
    for (const Witness& w : group) {
        q += (w.shift - centre.shift) * (w.shift - centre.shift) / w.variance;
        w1 += 1 / w.variance;
        w2 += 1 / (w.variance * w.variance);
    }
    const double excess = (q - 2 * (static_cast<double>(group.size()) - 1)) / (w1 - w2 / w1);
    for (Witness& w : group) w.variance += std::max(0.0, excess);
}

/// Inverse-variance mean of shoulders and slopes, each kind settled among itself first. Where the two kinds contradict
/// each other, the one that is less sure gives way.
Shift weigh(const std::vector<Witness>& witnesses)
{
    std::vector<Witness> shoulders, slopes;
    for (const Witness& w : witnesses) (w.slope ? slopes : shoulders).push_back(w);
    removeFacingBias(shoulders);
    settleAmong(shoulders);
    settleAmong(slopes);
    if (shoulders.empty()) return mean(slopes);
    if (slopes.empty()) return mean(shoulders);
    Shift a = mean(shoulders);
    Shift b = mean(slopes);
    const double contradiction = (a.shift - b.shift) * (a.shift - b.shift) - 6 * (a.variance + b.variance);
    (a.variance < b.variance ? b : a).variance += std::max(0.0, contradiction);
    const double share = b.variance / (a.variance + b.variance);
    return {share * a.shift + (1 - share) * b.shift, share * a.variance};
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
        Match match;
        double home;
        double angle;
    };
    double largest = 0;
    for (const double r : ref.radius_mm)
        if (!std::isnan(r)) largest = std::max(largest, r);
    const double cap = std::max(0.02 * largest, 6 * std::hypot(reference.fit.sigma_mm, copy.fit.sigma_mm));
    std::optional<Way> best;
    for (const bool turned : {false, true}) {
        Way way{turned ? reversed(copy) : copy, {}, 0, 0};
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
        // A part that looks the same from both ends keeps the smaller rotation.
        const bool as_good = best && std::abs(way.match.cost - best->match.cost) < 0.005 * cap;
        if (!best || (as_good ? way.angle < best->angle : way.match.cost < best->match.cost)) best = way;
    }
    if (!best || !std::isfinite(best->match.cost)) throw Error(ErrorCode::PartsDoNotMatch, {{"overlap_percent", 0.0}});

    Alignment result;
    result.iterations = reference.fit.iterations + copy.fit.iterations;
    const RadiusProfile& own = best->part.fit.profile;
    double shift = best->match.shift;
    double variance = 0;
    bool settled = false;  // the last step was far below the uncertainty
    bool done = false;     // nothing moves any more
    for (int i = 0; i < 10 && !done; ++i, ++result.iterations) {
        std::vector<Witness> witnesses;
        askShoulders(reference, best->part, shift, witnesses);
        askSlopes(ref, own, shift, witnesses);
        if (witnesses.empty()) {
            shift = best->home;
            settled = true;
            const Vector3d direction = reference.fit.axis_T_scan.linear().row(2);
            result.free_motions.push_back({FreeMotion::Kind::Translation, direction, Vector3d::Zero()});
            break;
        }
        const Shift verdict = weigh(witnesses);
        const double change = std::abs(verdict.shift - shift);
        done = change < 1e-6 * std::sqrt(verdict.variance) || change < 1e-12 * lengthOf(ref);
        settled = done || change < 0.01 * std::sqrt(verdict.variance);
        shift = verdict.shift;
        variance = verdict.variance;
    }
    result.converged = settled && reference.fit.converged && copy.fit.converged;
    result.reference_T_copy = withLeastRoll(reference.fit.axis_T_scan, best->part.fit.axis_T_scan, shift);

    const Axis axis = axisOf(reference.fit);
    result.reference_axis = axis;
    for (FreeMotion& motion : result.free_motions) {
        motion.direction = axis.direction;
        motion.point_mm = axis.point_mm;
        result.notes.push_back(
            {NoteCode::MotionNotDetermined, {{"kind", LT_TEXT("Engine", "translation along the axis")}}});
    }
    result.free_motions.insert(result.free_motions.begin(),
                               {FreeMotion::Kind::Rotation, axis.direction, axis.point_mm});
    result.notes.insert(result.notes.begin(), {NoteCode::RollNotDetermined, {}});
    if ((result.reference_T_copy.linear() * (copy.fit.axis_T_scan.linear().row(2).transpose()))
            .dot(copy.fit.axis_T_scan.linear().row(2)) < 0)
        result.notes.push_back({NoteCode::EndForEnd, {}});

    const Eigen::Matrix4d covariance = reference.fit.covariance + copy.fit.covariance;
    result.uncertainty.axial_um = 2 * kToUm * std::sqrt(variance);
    result.uncertainty.radial_um = 2 * kToUm * std::sqrt(covariance(0, 0) + covariance(1, 1));
    result.uncertainty.axis_deg = 2 * std::sqrt(covariance(2, 2) + covariance(3, 3)) * 180 / std::numbers::pi;
    return result;
}

}  // namespace lathelier
