#include "engine/registration/revolution/axial_shift_estimate.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "engine/registration/revolution/revolution_shift.h"

namespace lathelier::registration {
namespace {

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
        const auto there = readRadius(reference, place);
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

AxialShift mean(const std::vector<Witness>& witnesses)
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
    const AxialShift a = mean(up);
    const AxialShift b = mean(down);
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
    const AxialShift centre = mean(group);
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
AxialShift weigh(const std::vector<Witness>& witnesses)
{
    std::vector<Witness> shoulders, slopes;
    for (const Witness& w : witnesses) (w.slope ? slopes : shoulders).push_back(w);
    removeFacingBias(shoulders);
    settleAmong(shoulders);
    settleAmong(slopes);
    if (shoulders.empty()) return mean(slopes);
    if (slopes.empty()) return mean(shoulders);
    AxialShift a = mean(shoulders);
    AxialShift b = mean(slopes);
    const double contradiction = (a.shift - b.shift) * (a.shift - b.shift) - 6 * (a.variance + b.variance);
    (a.variance < b.variance ? b : a).variance += std::max(0.0, contradiction);
    const double share = b.variance / (a.variance + b.variance);
    return {share * a.shift + (1 - share) * b.shift, share * a.variance};
}

}  // namespace

std::optional<AxialShift> estimateAxialShift(const TurnedPart& reference, const TurnedPart& copy, double shift)
{
    std::vector<Witness> witnesses;
    askShoulders(reference, copy, shift, witnesses);
    askSlopes(reference.fit.profile, copy.fit.profile, shift, witnesses);
    if (witnesses.empty()) return std::nullopt;
    return weigh(witnesses);
}

}  // namespace lathelier::registration
