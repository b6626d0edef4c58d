#include "engine/registration/revolution/axial_shift_estimate.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "engine/core/statistics.h"
#include "engine/registration/revolution/revolution_shift.h"
#include "engine/registration/scanner_spot.h"

namespace lathelier::registration {
namespace {

/// What counts as the same shoulder, a taper and a cylinder, and how their shifts are weighed (README, "Thresholds").
struct AxialShiftThresholds {
    double end_sigmas = 3;  ///< an end face that differs by more from the other evidence is a deviation: 99.7 %
    double same_shoulder_steps = 4;    ///< of the profiles: a shoulder that near its expected place is the same one
    double same_height_share = 0.3;    ///< largest relative difference of the heights of one shoulder
    double least_sigma_share = 1e-9;   ///< of the length: least standard uncertainty of a shift, for exact meshes
    double least_slope = 0.03;         ///< dR/dz of a taper; below it the radius determines no shift
    double level_step_share = 0.1;     ///< of a bin: largest change of the radius to the next bin of a cylinder
    double slope_change_share = 0.25;  ///< largest relative change of the slope to the next bin of a taper
    int kink_bins = 8;                 ///< beside a taper, within which its cylinder has to begin
    int cylinder_bins = 48;            ///< longest stretch of a cylinder that its radius is extrapolated from
    int skipped_bins = 4;              ///< of a cylinder: their slope may exceed the limit by noise alone
    double least_line_bins = 6;        ///< of a cylinder, for a line through them
    double own_variance_share = 0.03 * 0.03;  ///< of the mean square difference of form: what a taper differs by itself
    std::size_t smeared_part = 4;             ///< at most this part (1 / n) of a taper is left out at each of its ends
    std::int64_t least_taper_freedom = 3;     ///< bins of a taper less one: with fewer its scatter is unknown
    double radius_variance_share = 1e-18;     ///< of R²: least variance of a difference of radii, for exact meshes
    double contradiction_variances = 6;       ///< of the difference of two groups: (√6 σ)², a chance of 1.4 %
};
constexpr AxialShiftThresholds shiftThresholds{};

constexpr double twoSided95 = 0.975;            // probability of Student's quantile for 95 % to both sides
constexpr std::int64_t manyFreedoms = 1000000;  // Student's distribution is the normal one

/// Axial shift estimated from one shoulder or taper.
struct ShiftEstimate {
    double shift;
    double variance;
    bool slope;
    int facing;  ///< of a shoulder: direction of its outward normal along z of the reference; of a taper 0
};

/// Two profiles at one axial shift: reference z = copy z + shift.
struct ShiftedPair {
    const RadiusProfile& reference;
    const RadiusProfile& copy;
    double shift;

    /// z of a bin of the copy along the reference.
    double place_mm(std::size_t bin) const { return copy.middle_mm(bin) + shift; }
    /// Bin of the reference at that z, which has to lie within its profile.
    std::size_t referenceBin(std::size_t bin) const
    {
        return static_cast<std::size_t>((place_mm(bin) - reference.z_start_mm) / reference.step_mm);
    }
};

/// One estimate for each of `copy` that has its like in `reference`: shoulders, or end faces.
std::vector<ShiftEstimate> matchFaces(const TurnedPart& whole_reference, const TurnedPart& whole_copy,
                                      std::vector<Shoulder> TurnedPart::*faces, double shift)
{
    std::vector<ShiftEstimate> estimates;
    const double step_mm = std::max(whole_reference.fit.profile.step_mm, whole_copy.fit.profile.step_mm);
    const double near = std::max(shiftThresholds.same_shoulder_steps * step_mm, smearedEdge_mm);
    const double floor = shiftThresholds.least_sigma_share * lengthOf(whole_reference.fit.profile);
    for (const Shoulder& c : whole_copy.*faces) {
        const Shoulder* found = nullptr;
        for (const Shoulder& r : whole_reference.*faces) {
            const double height = std::abs(r.after_mm - r.before_mm);
            if (r.facing() != c.facing() || std::abs(r.z_mm - c.z_mm - shift) > near) continue;
            if (std::abs(std::abs(c.after_mm - c.before_mm) - height) > shiftThresholds.same_height_share * height)
                continue;
            if (!found || std::abs(r.z_mm - c.z_mm - shift) < std::abs(found->z_mm - c.z_mm - shift)) found = &r;
        }
        if (!found) continue;
        estimates.push_back({found->z_mm - c.z_mm,
                             found->sigma_mm * found->sigma_mm + c.sigma_mm * c.sigma_mm + floor * floor, false,
                             found->facing()});
    }
    return estimates;
}

/// A bin of a cylinder: neither a slope nor a kink next to it.
bool isLevel(const RadiusProfile& p, std::size_t i)
{
    if (i < 1 || i + 1 >= p.size() || !(std::abs(p.slope[i]) < shiftThresholds.least_slope)) return false;
    const double most = shiftThresholds.level_step_share * p.step_mm;
    return std::abs(p.radius_mm[i] - p.radius_mm[i - 1]) < most && std::abs(p.radius_mm[i + 1] - p.radius_mm[i]) < most;
}

/// A bin of a slope that goes on to both sides: no kink and no edge next to it.
bool isWithinSlope(const RadiusProfile& p, std::size_t i)
{
    if (i < 1 || i + 1 >= p.size()) return false;
    const double q = p.slope[i];
    for (const std::size_t k : {i - 1, i + 1})
        if (std::isnan(p.radius_mm[k]) || std::abs(p.slope[k] - q) > shiftThresholds.slope_change_share * std::abs(q))
            return false;
    return true;
}

/// Difference of the radii (copy less reference), with its variance.
struct Difference {
    double off, variance;
};

/// That of a bin where both are cylinders.
std::optional<Difference> levelDifference(const ShiftedPair& pair, std::size_t bin)
{
    const auto there = readRadius(pair.reference, pair.place_mm(bin));
    if (!isLevel(pair.copy, bin) || !there) return std::nullopt;
    if (!isLevel(pair.reference, pair.referenceBin(bin))) return std::nullopt;
    return Difference{pair.copy.radius_mm[bin] - there->radius,
                      there->sigma * there->sigma + pair.copy.sigma_mm[bin] * pair.copy.sigma_mm[bin]};
}

/// How much the radii of the two parts differ where they are cylinders, beyond the scatter: mean square, mm².
double differenceOfForm(const ShiftedPair& pair)
{
    double sum = 0, count = 0;
    for (std::size_t i = 0; i < pair.copy.size(); ++i)
        if (const auto d = levelDifference(pair, i)) {
            sum += d->off * d->off - d->variance;
            count += 1;
        }
    return count > 0 ? std::max(0.0, sum / count) : 0;
}

/// Difference of the radii where a cylinder meets the slope that begins or ends beside bin `from`: a line through the
/// nearest bins of the cylinder, extended to that place. nullopt: no cylinder there.
std::optional<Difference> differenceBeside(const ShiftedPair& pair, std::ptrdiff_t from, std::ptrdiff_t step)
{
    constexpr int kinkBins = shiftThresholds.kink_bins;
    int skips_left = shiftThresholds.skipped_bins;
    double n = 0, sx = 0, sxx = 0, sy = 0, sxy = 0, variance = 0;
    for (std::ptrdiff_t k = 0; k < kinkBins + shiftThresholds.cylinder_bins; ++k) {
        const std::ptrdiff_t i = from + step * k;
        if (i < 0 || i >= static_cast<std::ptrdiff_t>(pair.copy.size())) break;
        const auto d = levelDifference(pair, static_cast<std::size_t>(i));
        if (!d && (n > 0 ? --skips_left : kinkBins - k) <= 0) break;
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
    if (n < shiftThresholds.least_line_bins || spread <= 0) return std::nullopt;
    return Difference{(sxx * sy - sx * sxy) / spread, variance / n * sxx / spread};
}

/// A bin of the copy on a slope, with the reference there.
struct SlopedBin {
    double slope, off;      ///< off: radius of the copy less that of the reference
    double variance;        ///< of that
    double whole_variance;  ///< with that of the reference's bin for the mean of two: neighbours share it
};

/// A run of such bins with slopes of one sign.
struct SlopeRun {
    std::vector<SlopedBin> bins;
    int sign = 0;              ///< of the slopes; 0: no bin yet
    std::ptrdiff_t first = 0;  ///< bin of the copy in which it begins
};

/// nullopt where the reference is unknown or no slope.
std::optional<SlopedBin> slopedBinAt(const ShiftedPair& pair, std::size_t i)
{
    const auto there = readRadius(pair.reference, pair.place_mm(i));
    if (!there) return std::nullopt;
    const std::size_t bin = pair.referenceBin(i);
    if (!isWithinSlope(pair.reference, bin)) return std::nullopt;
    const RadiusProfile& copy = pair.copy;
    const double slope = (there->slope + copy.slope[i]) / 2;
    const double variance = there->sigma * there->sigma + copy.sigma_mm[i] * copy.sigma_mm[i] +
                            shiftThresholds.radius_variance_share * there->radius * there->radius;
    const double own = pair.reference.sigma_mm[bin];
    const double shared_variance = std::max(0.0, own * own - there->sigma * there->sigma);
    // reference(z + shift + d) = copy(z): slope · d = copy - reference
    return SlopedBin{slope, copy.radius_mm[i] - there->radius, variance, variance + shared_variance};
}

/// Mean square difference of the radii over a taper from bin `first` to `end` - 1, as its adjoining cylinders show it.
/// `whole`: that of the two parts.
double differenceOfTaper(const ShiftedPair& pair, std::ptrdiff_t first, std::ptrdiff_t end, double whole)
{
    double difference = 0, sides = 0;
    for (const auto& beside : {differenceBeside(pair, first - 1, -1), differenceBeside(pair, end, 1)})
        if (beside && whole > 0) {
            // posterior mean square of the difference: prior variance `whole`, one observation
            const double shrinkage = whole / (whole + beside->variance);
            difference += shrinkage * shrinkage * beside->off * beside->off + shrinkage * beside->variance;
            sides += 1;
        }
    return sides > 0 ? difference / sides + shiftThresholds.own_variance_share * whole : whole;
}

/// The shift that makes the radii of a run, which ends before bin `end`, equal. nullopt: too few bins.
std::optional<ShiftEstimate> shiftOfTaper(const ShiftedPair& pair, const SlopeRun& run, std::size_t end, double whole)
{
    // The spot smears the kinks at both ends of the slope.
    const auto margin = std::min(run.bins.size() / shiftThresholds.smeared_part,
                                 static_cast<std::size_t>(smearedEdge_mm / pair.copy.step_mm));
    double weight = 0, sum = 0, lever = 0, squares = 0, shared = 0;
    for (std::size_t k = margin; k + margin < run.bins.size(); ++k) {
        const SlopedBin& bin = run.bins[k];
        weight += bin.slope * bin.slope / bin.variance;
        lever += bin.slope / bin.variance;
        sum += bin.slope * bin.off / bin.variance;
        squares += bin.off * bin.off / bin.variance;
        shared += bin.slope * bin.slope * bin.whole_variance / (bin.variance * bin.variance);
    }
    if (!(weight > 0)) return std::nullopt;
    // A spot scatters the points of a slope more than those of the sides.
    const auto freedom = static_cast<std::int64_t>(run.bins.size() - 2 * margin) - 1;
    if (freedom < shiftThresholds.least_taper_freedom) return std::nullopt;
    const double scatter =
        std::max(1.0, (squares - sum * sum / weight) / static_cast<double>(freedom)) *
        std::pow(studentQuantile(twoSided95, freedom) / studentQuantile(twoSided95, manyFreedoms), 2);
    const double difference = differenceOfTaper(pair, run.first, static_cast<std::ptrdiff_t>(end), whole);
    const double bias = lever / weight;
    return ShiftEstimate{pair.shift + sum / weight, scatter * shared / (weight * weight) + difference * bias * bias,
                         true, 0};
}

/// Tapers: for every run of bins with slopes of one sign, the shift that makes the radii equal. A difference of the
/// radii between copy and reference biases that shift. Its variance is estimated from the radius difference of the
/// adjoining cylinders (turned in the same pass), shrunk by its noise, plus 3 % (standard deviation) of the overall
/// radius difference; without an adjoining cylinder, it is the overall mean square.
void addTaperEstimates(const ShiftedPair& pair, std::vector<ShiftEstimate>& estimates)
{
    const RadiusProfile& copy = pair.copy;
    const double whole = differenceOfForm(pair);
    SlopeRun run;
    const auto finish = [&](std::size_t end) {
        if (const auto estimate = shiftOfTaper(pair, run, end, whole)) estimates.push_back(*estimate);
        run.bins.clear();
        run.sign = 0;
    };
    for (std::size_t i = 0; i < copy.size(); ++i) {
        const double q = copy.slope[i];
        const bool sloped =
            !std::isnan(copy.radius_mm[i]) && std::abs(q) > shiftThresholds.least_slope && isWithinSlope(copy, i);
        if (!sloped || (run.sign != 0 && (q > 0) != (run.sign > 0))) finish(i);
        if (!sloped) continue;
        const auto bin = slopedBinAt(pair, i);
        if (!bin) continue;
        if (run.sign == 0) run.first = static_cast<std::ptrdiff_t>(i);
        run.sign = q > 0 ? 1 : -1;
        run.bins.push_back(*bin);
    }
    finish(copy.size());
}

AxialShift weightedMeanShift(const std::vector<ShiftEstimate>& estimates)
{
    double weight = 0, sum = 0;
    for (const ShiftEstimate& w : estimates) {
        weight += 1 / w.variance;
        sum += w.shift / w.variance;
    }
    return {sum / weight, 1 / weight};
}

/// Two scans may displace all shoulders outward by different amounts (spot size, treatment of mixed pixels). With
/// shoulders that face both ways this bias is observable: half the difference of the two group means, shrunk by its
/// noise, is subtracted from each estimate. Shoulders that all face one way are not corrected.
void removeFacingBias(std::vector<ShiftEstimate>& shoulders)
{
    std::vector<ShiftEstimate> up, down;
    for (const ShiftEstimate& w : shoulders) (w.facing > 0 ? up : down).push_back(w);
    if (up.empty() || down.empty()) return;
    const AxialShift a = weightedMeanShift(up);
    const AxialShift b = weightedMeanShift(down);
    const double half = (a.shift - b.shift) / 2;
    const double noise = (a.variance + b.variance) / 4;
    const double prior = half * half - 2 * noise;
    if (prior <= 0) return;
    const double bias = half * prior / (prior + noise);
    for (ShiftEstimate& w : shoulders) w.shift -= w.facing > 0 ? bias : -bias;
}

/// Adds the between-estimate variance to the variances of a group (moment estimator of DerSimonian and Laird, 1986).
void inflateVariances(std::vector<ShiftEstimate>& group)
{
    if (group.size() < 2) return;
    const AxialShift centre = weightedMeanShift(group);
    double q = 0, w1 = 0, w2 = 0;
    for (const ShiftEstimate& w : group) {
        q += (w.shift - centre.shift) * (w.shift - centre.shift) / w.variance;
        w1 += 1 / w.variance;
        w2 += 1 / (w.variance * w.variance);
    }
    const double excess = (q - 2 * (static_cast<double>(group.size()) - 1)) / (w1 - w2 / w1);
    for (ShiftEstimate& w : group) w.variance += std::max(0.0, excess);
}

/// Inverse-variance mean of shoulders and tapers, after adding the variance within each group. Where the two group
/// means differ by more than √6 standard uncertainties, the variance of the less certain group is inflated by the
/// excess.
AxialShift combineEstimates(const std::vector<ShiftEstimate>& estimates)
{
    std::vector<ShiftEstimate> shoulders, slopes;
    for (const ShiftEstimate& w : estimates) (w.slope ? slopes : shoulders).push_back(w);
    removeFacingBias(shoulders);
    inflateVariances(shoulders);
    inflateVariances(slopes);
    if (shoulders.empty()) return weightedMeanShift(slopes);
    if (slopes.empty()) return weightedMeanShift(shoulders);
    AxialShift a = weightedMeanShift(shoulders);
    AxialShift b = weightedMeanShift(slopes);
    const double contradiction =
        (a.shift - b.shift) * (a.shift - b.shift) - shiftThresholds.contradiction_variances * (a.variance + b.variance);
    (a.variance < b.variance ? b : a).variance += std::max(0.0, contradiction);
    const double share = b.variance / (a.variance + b.variance);
    return {share * a.shift + (1 - share) * b.shift, share * a.variance};
}

/// Within what chance allows.
bool agrees(const ShiftEstimate& end, const AxialShift& other)
{
    return std::pow(end.shift - other.shift, 2) <
           shiftThresholds.end_sigmas * shiftThresholds.end_sigmas * (end.variance + other.variance);
}

/// Whether every end of the part that both scans show has its like in `matched`, all at one shift. A part with no
/// shoulder whose length differs has no axial position.
bool isOneLength(const TurnedPart& reference, const TurnedPart& copy, const std::vector<ShiftEstimate>& matched)
{
    std::size_t both = 0;
    for (const Shoulder& c : copy.ends)
        for (const Shoulder& r : reference.ends) both += r.facing() == c.facing() ? 1U : 0U;
    return matched.size() == both && std::all_of(matched.begin(), matched.end(), [&](const ShiftEstimate& end) {
               return agrees(end, {matched.front().shift, matched.front().variance});
           });
}

}  // namespace

std::optional<AxialShift> estimateAxialShift(const TurnedPart& reference, const TurnedPart& copy, double shift)
{
    std::vector<ShiftEstimate> estimates = matchFaces(reference, copy, &TurnedPart::shoulders, shift);
    addTaperEstimates({reference.fit.profile, copy.fit.profile, shift}, estimates);
    const std::vector<ShiftEstimate> ends = matchFaces(reference, copy, &TurnedPart::ends, shift);
    if (estimates.empty()) {
        if (ends.empty() || !isOneLength(reference, copy, ends)) return std::nullopt;
        return combineEstimates(ends);
    }
    // A length may differ: an end that contradicts all the rest is a deviation of the copy.
    const AxialShift inner = combineEstimates(estimates);
    for (const ShiftEstimate& end : ends)
        if (agrees(end, inner)) estimates.push_back(end);
    return combineEstimates(estimates);
}

}  // namespace lathelier::registration
