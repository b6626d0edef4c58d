#include "engine/features/stretches/sections.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>

#include "engine/features/stretches/stretch_limits.h"

namespace lathelier::features {
namespace {

constexpr double notSeen = std::numeric_limits<double>::quiet_NaN();

using SectorRadii = std::vector<double>;

/// Radii of the points by sections, and in these by sectors.
class SortedSections {
public:
    SortedSections(const MeridianCloud& cloud, double length_mm)
        : first_mm_(cloud.z_first_mm),
          length_mm_(length_mm),
          count_(static_cast<std::size_t>(std::max(1.0, std::ceil((cloud.z_last_mm - cloud.z_first_mm) / length_mm))))
    {
        const std::size_t outside = count_ * sectionLimits.sectors;
        const auto cellOf = [&](std::size_t i) {
            const double place = (static_cast<double>(cloud.z_mm[i]) - first_mm_) / length_mm;
            if (!(place >= 0 && place < static_cast<double>(count_))) return outside;
            const auto sector = static_cast<std::size_t>(cloud.turn[i] * static_cast<float>(sectionLimits.sectors));
            return static_cast<std::size_t>(place) * sectionLimits.sectors +
                   std::min(sector, sectionLimits.sectors - 1);
        };
        start_.assign(outside + 2, 0);
        for (std::size_t i = 0; i < cloud.z_mm.size(); ++i) ++start_[cellOf(i) + 1];
        std::partial_sum(start_.begin(), start_.end(), start_.begin());
        radii_mm_.resize(start_.back());
        std::vector<std::size_t> next(start_.begin(), start_.end() - 1);
        for (std::size_t i = 0; i < cloud.z_mm.size(); ++i) radii_mm_[next[cellOf(i)]++] = cloud.r_mm[i];
    }

    std::size_t size() const { return count_; }
    double from_mm(std::size_t section) const { return first_mm_ + static_cast<double>(section) * length_mm_; }

    /// Of each sector the median radius of its outermost wall.
    SectorRadii radii(std::size_t section, double gap_mm)
    {
        SectorRadii radii(sectionLimits.sectors, notSeen);
        for (std::size_t s = 0; s < sectionLimits.sectors; ++s) {
            const std::size_t cell = section * sectionLimits.sectors + s;
            const auto begin = radii_mm_.begin() + static_cast<std::ptrdiff_t>(start_[cell]),
                       end = radii_mm_.begin() + static_cast<std::ptrdiff_t>(start_[cell + 1]);
            if (begin == end) continue;
            std::sort(begin, end, std::greater<>());
            const auto gap =
                std::adjacent_find(begin, end, [&](float a, float b) { return static_cast<double>(a - b) > gap_mm; });
            const auto wall = gap == end ? end : gap + 1;
            radii[s] = static_cast<double>(*(begin + (wall - begin) / 2));
        }
        return radii;
    }

private:
    double first_mm_, length_mm_;
    std::size_t count_;
    std::vector<std::size_t> start_;  ///< of each cell in the radii
    std::vector<float> radii_mm_;
};

/// Mean and rms about it of the sectors that are seen; rms of a difference where both are.
struct SectorSpread {
    double mean_mm = 0, rms_mm = 0, share = 0;
};

template <class Value>
SectorSpread sectorSpread(const Value& value)
{
    double n = 0, sum = 0, squares = 0;
    for (std::size_t s = 0; s < sectionLimits.sectors; ++s) {
        const double one = value(s);
        if (std::isnan(one)) continue;
        n += 1;
        sum += one;
        squares += one * one;
    }
    if (n == 0) return {};
    const double mean = sum / n;
    return {mean, std::sqrt(std::max(0.0, squares / n - mean * mean)), n / static_cast<double>(sectionLimits.sectors)};
}

/// A run under way: sums of its sections.
struct OpenRun {
    double from_mm = 0, to_mm = 0;
    std::vector<double> sum_mm, count;
    std::size_t sections = 0;
    double least_mm = std::numeric_limits<double>::infinity();

    double at(std::size_t s) const { return count[s] > 0 ? sum_mm[s] / count[s] : notSeen; }
    void add(const SectorRadii& radii)
    {
        for (std::size_t s = 0; s < radii.size(); ++s) {
            if (std::isnan(radii[s])) continue;
            sum_mm[s] += radii[s];
            count[s] += 1;
            least_mm = std::min(least_mm, radii[s]);
        }
        ++sections;
    }
    void add(const OpenRun& other)
    {
        for (std::size_t s = 0; s < sum_mm.size(); ++s) {
            sum_mm[s] += other.sum_mm[s];
            count[s] += other.count[s];
        }
        to_mm = other.to_mm;
        sections += other.sections;
        least_mm = std::min(least_mm, other.least_mm);
    }
    SectionRun closed() const { return {from_mm, to_mm, least_mm}; }
};

/// Neighbouring sections that belong together.
struct RunBuilder {
    std::vector<OpenRun> runs;
    bool is_open = false;

    /// `is_part`: no round one; `isLike`: does it continue the run?
    template <class IsLike>
    void add(double from_mm, double to_mm, const SectorRadii& radii, bool is_part, const IsLike& isLike)
    {
        if (!is_part) {
            is_open = false;
            return;
        }
        if (!is_open || !isLike(runs.back())) {
            const std::vector<double> nothing(sectionLimits.sectors, 0);
            runs.push_back({from_mm, 0, nothing, nothing});
            is_open = true;
        }
        runs.back().add(radii);
        runs.back().to_mm = to_mm;
    }
};

/// Do two sections have one shape? `spread_mm`: departure of the first one from a circle.
template <class A, class B>
bool areAlike(const A& a, const B& b, double spread_mm, double sigma_mm)
{
    const SectorSpread off = sectorSpread([&](std::size_t s) { return a(s) - b(s); });
    return off.share >= sectionLimits.least_seen_share &&
           std::abs(off.mean_mm) < sectionLimits.like_mean_mm + sectionLimits.like_mean_sigmas * sigma_mm &&
           off.rms_mm < std::max(sectionLimits.like_spread * spread_mm, sectionLimits.like_sigmas * sigma_mm);
}

/// Runs that an odd section divides are one.
std::vector<OpenRun> joinedRuns(const std::vector<OpenRun>& runs, double sigma_mm)
{
    std::vector<OpenRun> joined;
    for (const OpenRun& run : runs) {
        const auto own = [&](std::size_t s) { return run.at(s); };
        if (!joined.empty() && run.from_mm - joined.back().to_mm < sectionLimits.join_mm) {
            const OpenRun& last = joined.back();
            const auto other = [&](std::size_t s) { return last.at(s); };
            if (areAlike(own, other, sectorSpread(own).rms_mm / 2, sigma_mm)) {
                joined.back().add(run);
                continue;
            }
        }
        joined.push_back(run);
    }
    return joined;
}

}  // namespace

SectionRuns notRoundRuns(const MeridianCloud& cloud, double sigma_mm, const Progress& progress)
{
    const double whole_mm = cloud.z_last_mm - cloud.z_first_mm;
    const double length_mm = std::max(std::clamp(sectionLimits.points_per_section / std::max(1e-9, cloud.points_per_mm),
                                                 sectionLimits.shortest_mm, sectionLimits.longest_mm),
                                      whole_mm / sectionLimits.most_sections);
    SortedSections sections(cloud, length_mm);
    const double gap_mm = std::max(sectionLimits.wall_gap_mm, sectionLimits.wall_gap_sigmas * sigma_mm);
    const double least_mm = std::max(sectionLimits.least_spread_mm, sectionLimits.least_spread_sigmas * sigma_mm);
    RunBuilder alike, deep;
    for (std::size_t i = 0; i < sections.size(); ++i) {
        progress.check();
        const SectorRadii radii = sections.radii(i, gap_mm);
        const auto own = [&](std::size_t s) { return radii[s]; };
        const SectorSpread spread = sectorSpread(own);
        const bool is_round = spread.share < sectionLimits.least_seen_share || spread.rms_mm < least_mm;
        const auto isLike = [&](const OpenRun& run) {
            return areAlike(
                own, [&](std::size_t s) { return run.at(s); }, spread.rms_mm, sigma_mm);
        };
        const double from = sections.from_mm(i), to = sections.from_mm(i + 1);
        alike.add(from, to, radii, !is_round, isLike);
        deep.add(from, to, radii, !is_round && spread.rms_mm > helixLimits.least_spread_mm,
                 [](const OpenRun&) { return true; });
    }
    std::erase_if(alike.runs, [](const OpenRun& run) { return run.sections < sectionLimits.least_sections; });
    SectionRuns found;
    for (const OpenRun& run : joinedRuns(alike.runs, sigma_mm))
        if (run.to_mm - run.from_mm >= sectionLimits.least_run_mm) found.alike.push_back(run.closed());
    for (const OpenRun& run : deep.runs) {
        const bool is_alike = std::any_of(found.alike.begin(), found.alike.end(), [&](const SectionRun& other) {
            return other.to_mm > run.from_mm && other.from_mm < run.to_mm &&
                   2 * (other.to_mm - other.from_mm) > run.to_mm - run.from_mm;
        });
        if (!is_alike && run.to_mm - run.from_mm >= helixLimits.least_zone_mm) found.winding.push_back(run.closed());
    }
    return found;
}

}  // namespace lathelier::features
