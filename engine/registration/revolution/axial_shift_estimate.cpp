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

/// Axial shift estimated from one shoulder or taper.
struct ShiftEstimate {
    double shift;
    double variance;
    bool slope;
    int facing;  ///< of a shoulder: direction of its outward normal along z of the reference; of a taper 0
};

constexpr double endSigmas = 3;  // standard uncertainties by which an end face may differ from the other evidence
constexpr double nearSteps = 4;  // of the profiles: a shoulder that far from where it is expected is the same one

/// One estimate for each of `copy` that has its like in `reference`: shoulders, or end faces.
std::vector<ShiftEstimate> matchFaces(const TurnedPart& whole_reference, const TurnedPart& whole_copy,
                                      std::vector<Shoulder> TurnedPart::*faces, double shift)
{
    std::vector<ShiftEstimate> estimates;
    const double step_mm = std::max(whole_reference.fit.profile.step_mm, whole_copy.fit.profile.step_mm);
    const double near = std::max(nearSteps * step_mm, smearedEdge_mm);
    const double floor = 1e-9 * lengthOf(whole_reference.fit.profile);
    for (const Shoulder& c : whole_copy.*faces) {
        const Shoulder* found = nullptr;
        for (const Shoulder& r : whole_reference.*faces) {
            const double height = std::abs(r.after_mm - r.before_mm);
            if (r.facing() != c.facing() || std::abs(r.z_mm - c.z_mm - shift) > near) continue;
            if (std::abs(std::abs(c.after_mm - c.before_mm) - height) > 0.3 * height) continue;
            if (!found || std::abs(r.z_mm - c.z_mm - shift) < std::abs(found->z_mm - c.z_mm - shift)) found = &r;
        }
        if (!found) continue;
        estimates.push_back({found->z_mm - c.z_mm,
                             found->sigma_mm * found->sigma_mm + c.sigma_mm * c.sigma_mm + floor * floor, false,
                             found->facing()});
    }
    return estimates;
}

constexpr double leastSlope = 0.03;
constexpr std::int64_t leastTaperFreedom = 3;   // bins of a taper less one: with fewer its scatter is unknown
constexpr std::int64_t manyFreedoms = 1000000;  // of Student's distribution: the normal one

/// Difference of the radii (copy less reference) in a bin where both are cylinders, with its variance.
struct Difference {
    double off, variance;
};
std::optional<Difference> levelDifference(const RadiusProfile& reference, const RadiusProfile& copy, double shift,
                                          std::size_t bin)
{
    const auto level = [](const RadiusProfile& p, std::size_t i) {  // and no kink next to it
        if (i < 1 || i + 1 >= p.size() || !(std::abs(p.slope[i]) < leastSlope)) return false;
        const double most = 0.1 * p.step_mm;
        return std::abs(p.radius_mm[i] - p.radius_mm[i - 1]) < most &&
               std::abs(p.radius_mm[i + 1] - p.radius_mm[i]) < most;
    };
    const double place = copy.middle_mm(bin) + shift;
    const auto there = readRadius(reference, place);
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
    constexpr int kinkBins = 8, longestStretch_bins = 48;
    int skips_left = 4;  // bins with a slope above the limit from noise alone that may be skipped
    double n = 0, sx = 0, sxx = 0, sy = 0, sxy = 0, variance = 0;
    for (std::ptrdiff_t k = 0; k < kinkBins + longestStretch_bins; ++k) {
        const std::ptrdiff_t i = from + step * k;
        if (i < 0 || i >= static_cast<std::ptrdiff_t>(copy.size())) break;
        const auto d = levelDifference(reference, copy, shift, static_cast<std::size_t>(i));
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
    if (n < 6 || spread <= 0) return std::nullopt;
    return Difference{(sxx * sy - sx * sxy) / spread, variance / n * sxx / spread};
}

/// Tapers: for every run of bins with slopes of one sign, the shift that makes the radii equal. A difference of the
/// radii between copy and reference biases that shift. Its variance is estimated from the radius difference of the
/// adjoining cylinders (turned in the same pass), shrunk by its noise, plus 3 % (standard deviation) of the overall
/// radius difference; without an adjoining cylinder, it is the overall mean square.
void addTaperEstimates(const RadiusProfile& reference, const RadiusProfile& copy, double shift,
                       std::vector<ShiftEstimate>& estimates)
{
    constexpr double ownVarianceShare = 0.03 * 0.03;
    const double whole = differenceOfForm(reference, copy, shift);
    struct SlopedBin {
        double slope, off;      // off: radius of the copy less that of the reference
        double variance;        // of that
        double whole_variance;  // with that of the reference's bin for the mean of two: neighbours share it
    };
    std::vector<SlopedBin> run;
    int sign = 0;
    std::ptrdiff_t first = 0;
    const auto clear = [&] {
        run.clear();
        sign = 0;
    };
    const auto finish = [&](std::size_t end) {
        // The spot smears the kinks at both ends of the slope.
        const auto margin = std::min(run.size() / 4, static_cast<std::size_t>(smearedEdge_mm / copy.step_mm));
        double weight = 0, sum = 0, lever = 0, squares = 0, shared = 0;
        for (std::size_t k = margin; k + margin < run.size(); ++k) {
            const SlopedBin& bin = run[k];
            weight += bin.slope * bin.slope / bin.variance;
            lever += bin.slope / bin.variance;
            sum += bin.slope * bin.off / bin.variance;
            squares += bin.off * bin.off / bin.variance;
            shared += bin.slope * bin.slope * bin.whole_variance / (bin.variance * bin.variance);
        }
        if (weight > 0) {
            // A spot scatters the points of a slope more than those of the sides.
            const auto freedom = static_cast<std::int64_t>(run.size() - 2 * margin) - 1;
            if (freedom < leastTaperFreedom) return clear();
            const double scatter = std::max(1.0, (squares - sum * sum / weight) / static_cast<double>(freedom)) *
                                   std::pow(studentQuantile(0.975, freedom) / studentQuantile(0.975, manyFreedoms), 2);
            double difference = 0, sides = 0;
            for (const auto& beside : {differenceBeside(reference, copy, shift, first - 1, -1),
                                       differenceBeside(reference, copy, shift, static_cast<std::ptrdiff_t>(end), 1)})
                if (beside && whole > 0) {
                    // posterior mean square of the difference: prior variance `whole`, one observation
                    const double shrinkage = whole / (whole + beside->variance);
                    difference += shrinkage * shrinkage * beside->off * beside->off + shrinkage * beside->variance;
                    sides += 1;
                }
            difference = sides > 0 ? difference / sides + ownVarianceShare * whole : whole;
            const double bias = lever / weight;
            estimates.push_back(
                {shift + sum / weight, scatter * shared / (weight * weight) + difference * bias * bias, true, 0});
        }
        clear();
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
        const bool sloped = !std::isnan(copy.radius_mm[i]) && std::abs(q) > leastSlope && smooth(copy, i);
        if (!sloped || (sign != 0 && (q > 0) != (sign > 0))) finish(i);
        if (!sloped) continue;
        const double place = copy.middle_mm(i) + shift;
        const auto there = readRadius(reference, place);
        const double bin = (place - reference.z_start_mm) / reference.step_mm;
        if (!there || !smooth(reference, static_cast<std::size_t>(bin))) continue;
        if (sign == 0) first = static_cast<std::ptrdiff_t>(i);
        sign = q > 0 ? 1 : -1;
        const double slope = (there->slope + q) / 2;
        const double variance =
            there->sigma * there->sigma + copy.sigma_mm[i] * copy.sigma_mm[i] + 1e-18 * there->radius * there->radius;
        const double own = reference.sigma_mm[static_cast<std::size_t>(bin)];
        const double shared_variance = std::max(0.0, own * own - there->sigma * there->sigma);
        // reference(z + shift + d) = copy(z): slope · d = copy - reference
        run.push_back({slope, copy.radius_mm[i] - there->radius, variance, variance + shared_variance});
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
    const double contradiction = (a.shift - b.shift) * (a.shift - b.shift) - 6 * (a.variance + b.variance);
    (a.variance < b.variance ? b : a).variance += std::max(0.0, contradiction);
    const double share = b.variance / (a.variance + b.variance);
    return {share * a.shift + (1 - share) * b.shift, share * a.variance};
}

/// Within what chance allows.
bool agrees(const ShiftEstimate& end, const AxialShift& other)
{
    return std::pow(end.shift - other.shift, 2) < endSigmas * endSigmas * (end.variance + other.variance);
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
    addTaperEstimates(reference.fit.profile, copy.fit.profile, shift, estimates);
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
