#include "engine/registration/revolution/revolution_shift.h"

#include <algorithm>
#include <cmath>

#include "engine/core/units.h"

namespace lathelier::registration {
namespace {

/// The search over the shift between two parts (README, "Thresholds").
struct ShiftSearchThresholds {
    std::ptrdiff_t closed_bins = 10;          ///< unknown bins of a shoulder; a longer gap is a place without data
    double least_overlap = 0.25;              ///< of the shorter part: with less there is no cost
    double missing_cost = 0.5;                ///< of the cap: cost of what does not overlap
    double end_slack_steps = 2;               ///< of the profiles, beyond an end face: noise
    double even_share = 1e-3;                 ///< of the cap: differences of costs below it are noise
    double worthwhile_share = 0.25;           ///< of the cap: a start whose cost is above the least by more is none
    std::size_t most_starts = 4;              ///< that are followed
    std::ptrdiff_t start_distance_steps = 8;  ///< starts nearer to each other than that lead to the same place
    std::size_t coarse_stride = 4;            ///< bins of the copy from one to the next in the coarse scan
    double fine_reach_steps = 16;             ///< to both sides of the best place, of each finer scan,
    double most_reach_steps = 4;              ///< but no further than so many steps of the profiles
};
constexpr ShiftSearchThresholds searchThresholds{};

/// Where z lies between the middles of two bins.
struct BetweenBins {
    std::size_t first;  ///< bin
    double share;       ///< of the way to the next bin
};

std::optional<BetweenBins> betweenBins(const RadiusProfile& p, double z)
{
    const double place = (z - p.z_start_mm) / p.step_mm - 0.5;
    if (!(place >= 0) || place >= static_cast<double>(p.size()) - 1) return std::nullopt;
    const auto first = static_cast<std::size_t>(place);
    return BetweenBins{first, place - static_cast<double>(first)};
}

double radiusAt(const RadiusProfile& p, const BetweenBins& at)
{
    return (1 - at.share) * p.radius_mm[at.first] + at.share * p.radius_mm[at.first + 1];
}

/// Short gaps take the radius of their nearer side.
void closeShoulders(std::vector<double>& radius_mm)
{
    const auto count = static_cast<std::ptrdiff_t>(radius_mm.size());
    const auto at = [&](std::ptrdiff_t i) -> double& { return radius_mm[static_cast<std::size_t>(i)]; };
    std::ptrdiff_t before = -1;
    for (std::ptrdiff_t i = 0; i < count; ++i) {
        if (std::isnan(at(i))) continue;
        if (before >= 0 && i - before - 1 <= searchThresholds.closed_bins)
            for (std::ptrdiff_t k = before + 1; k < i; ++k) at(k) = at(k - before <= i - k ? before : i);
        before = i;
    }
}

/// Those whose cost no neighbour within the distance of two starts undercuts.
std::vector<ShiftMatch> leastOfTheirPlace(const std::vector<ShiftMatch>& matches)
{
    const auto count = static_cast<std::ptrdiff_t>(matches.size());
    std::vector<ShiftMatch> least;
    for (std::ptrdiff_t k = 0; k < count; ++k) {
        const auto from = matches.begin() + std::max<std::ptrdiff_t>(0, k - searchThresholds.start_distance_steps);
        const auto to = matches.begin() + std::min(count, k + searchThresholds.start_distance_steps + 1);
        const double cost = matches[static_cast<std::size_t>(k)].cost;
        if (std::isfinite(cost) && std::all_of(from, to, [cost](const ShiftMatch& m) { return cost <= m.cost; }))
            least.push_back(matches[static_cast<std::size_t>(k)]);
    }
    return least;
}

}  // namespace

double lengthOf(const RadiusProfile& p)
{
    return p.step_mm * static_cast<double>(p.size());
}
double middleOf(const RadiusProfile& p)
{
    return p.z_start_mm + lengthOf(p) / 2;
}

std::optional<RadiusReading> readRadius(const RadiusProfile& p, double z)
{
    const auto at = betweenBins(p, z);
    if (!at) return std::nullopt;
    const double radius = radiusAt(p, *at);
    if (std::isnan(radius)) return std::nullopt;
    const std::size_t i = at->first;
    const double own = (1 - at->share) * p.sigma_mm[i], next = at->share * p.sigma_mm[i + 1];
    return RadiusReading{radius, (p.radius_mm[i + 1] - p.radius_mm[i]) / p.step_mm, std::sqrt(own * own + next * next)};
}

ShiftSearch::ShiftSearch(const TurnedPart& reference, const TurnedPart& copy, double cap_mm)
    : reference_(partOf(reference)),
      copy_(partOf(copy)),
      cap_mm_(cap_mm),
      step_mm_(std::max(reference.fit.profile.step_mm, copy.fit.profile.step_mm))
{
}

ShiftSearch::Part ShiftSearch::partOf(const TurnedPart& part)
{
    Part result;
    result.profile = part.fit.profile;
    RadiusProfile& p = result.profile;
    closeShoulders(p.radius_mm);
    result.first_mm = result.last_mm = p.z_start_mm;
    for (std::size_t i = 0; i < p.size(); ++i) {
        if (std::isnan(p.radius_mm[i])) continue;
        if (result.known_mm == 0) result.first_mm = p.middle_mm(i) - p.step_mm / 2;
        result.known_mm += p.step_mm;
        result.last_mm = p.middle_mm(i) + p.step_mm / 2;
    }
    for (const Shoulder& end : part.ends) {
        if (end.facing() < 0) result.face_first_mm = end.z_mm;
        if (end.facing() > 0) result.face_last_mm = end.z_mm;
    }
    return result;
}

ShiftMatch ShiftSearch::at(double shift, std::size_t stride) const
{
    const double weight_mm = copy_.profile.step_mm * static_cast<double>(stride);
    double sum = 0;
    double squares = 0;
    double both = 0;
    for (std::size_t i = 0; i < copy_.profile.size(); i += stride) {
        const double radius = copy_.profile.radius_mm[i];
        if (std::isnan(radius)) continue;
        const auto at = betweenBins(reference_.profile, copy_.profile.middle_mm(i) + shift);
        const double there = at ? radiusAt(reference_.profile, *at) : notANumber;
        if (std::isnan(there)) continue;
        ++both;
        const double off = std::min(cap_mm_, std::abs(there - radius));
        sum += off;
        squares += off * off;
    }
    // Lengths of one part beyond an end face of the other; a few steps of noise are none.
    const double slack_mm = searchThresholds.end_slack_steps * step_mm_;
    const auto beyond = [&](double from, double to) { return std::max(0.0, to - from - slack_mm); };
    const double outside_mm = beyond(copy_.first_mm + shift, reference_.face_first_mm) +
                              beyond(reference_.face_last_mm, copy_.last_mm + shift) +
                              beyond(reference_.first_mm, copy_.face_first_mm + shift) +
                              beyond(copy_.face_last_mm + shift, reference_.last_mm);
    ShiftMatch match;
    match.shift = shift;
    match.overlap = std::min(1.0, both * weight_mm / std::min(copy_.known_mm, reference_.known_mm));
    if (match.overlap < searchThresholds.least_overlap) return match;
    match.difference_mm = (sum * weight_mm + cap_mm_ * outside_mm) / (both * weight_mm + outside_mm);
    match.difference_sigma_mm = std::sqrt(std::max(0.0, squares - sum * sum / both)) / both;
    match.cost = match.difference_mm + searchThresholds.missing_cost * cap_mm_ * (1 - match.overlap);
    return match;
}

std::vector<ShiftMatch> ShiftSearch::scan(double from, double to, double step, std::size_t stride) const
{
    const int count = static_cast<int>((to - from) / step) + 1;
    std::vector<ShiftMatch> matches;
    matches.reserve(static_cast<std::size_t>(count) + 1);
    for (int k = 0; k <= count; ++k) matches.push_back(at(from + k * step, stride));
    return matches;
}

/// The least cost; among equal ones the nearest to `initial_shift`. Not empty.
ShiftMatch ShiftSearch::best(const std::vector<ShiftMatch>& matches, double initial_shift) const
{
    double least = std::numeric_limits<double>::infinity();
    for (const ShiftMatch& m : matches) least = std::min(least, m.cost);
    ShiftMatch best = matches.front();
    bool found = false;
    for (const ShiftMatch& m : matches) {
        if (m.cost > least + searchThresholds.even_share * cap_mm_) continue;
        if (!found || std::abs(m.shift - initial_shift) < std::abs(best.shift - initial_shift)) best = m;
        found = true;
    }
    return best;
}

std::vector<ShiftMatch> ShiftSearch::starts(double centre, double reach, double initial_shift) const
{
    // The first is the best of all, also where a plateau of equal costs reaches to `initial_shift`.
    const std::vector<ShiftMatch> all = scan(centre - reach, centre + reach, step_mm_, searchThresholds.coarse_stride);
    std::vector<ShiftMatch> chosen{best(all, initial_shift)};
    if (!std::isfinite(chosen.front().cost)) return {};
    std::vector<ShiftMatch> others = leastOfTheirPlace(all);
    std::stable_sort(others.begin(), others.end(),
                     [](const ShiftMatch& a, const ShiftMatch& b) { return a.cost < b.cost; });
    const double distance_mm = static_cast<double>(searchThresholds.start_distance_steps) * step_mm_;
    const double most_cost = chosen.front().cost + searchThresholds.worthwhile_share * cap_mm_;
    for (const ShiftMatch& m : others) {
        if (chosen.size() == searchThresholds.most_starts || m.cost > most_cost) break;
        if (std::all_of(chosen.begin(), chosen.end(),
                        [&](const ShiftMatch& c) { return std::abs(c.shift - m.shift) > distance_mm; }))
            chosen.push_back(m);
    }
    for (ShiftMatch& start : chosen)
        for (const double step : {step_mm_, step_mm_ / 4, step_mm_ / 16}) {
            const double width =
                std::min(searchThresholds.fine_reach_steps * step, searchThresholds.most_reach_steps * step_mm_);
            start = best(scan(start.shift - width, start.shift + width, step, 1), initial_shift);
        }
    return chosen;
}

}  // namespace lathelier::registration
