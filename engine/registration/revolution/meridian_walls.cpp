#include "engine/registration/revolution/meridian_walls.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

#include "engine/core/statistics.h"
#include "engine/core/units.h"
#include "engine/registration/revolution/quick_turn.h"

namespace lathelier::registration {
namespace {

/// When the radii at one z are those of two walls, a bore and the outside (README, "Thresholds").
struct WallThresholds {
    double part_quantile = 0.99;    ///< of the radii: points further out are spurious
    std::size_t stretches = 120;    ///< at most so many along the part: a bore has few points
    double gap_mm = 0.4;            ///< least distance between two walls
    double gap_share = 0.05;        ///< of the largest radius: the same on small parts
    double gap_scatters = 8;        ///< of the inner wall: the same on noisy ones
    std::size_t least_points = 6;   ///< of each wall
    std::size_t least_percent = 8;  ///< of the points of a stretch on each wall
    double shared_sectors = 0.55;  ///< share of the inner wall's sectors of the turn in which the outer one is seen too
    int stretch_reach = 2;     ///< a bore shows in neighbouring stretches as well: so many to each side are looked at
    int least_neighbours = 2;  ///< and so many of them have to show it
};
constexpr WallThresholds wallThresholds{};

constexpr std::size_t wallSectors = 32;  // bits of the mask of sectors

/// The points in which two walls are sought, by bins along the part.
struct WallSearch {
    const std::vector<Eigen::Vector3d>& sample;
    const Eigen::Isometry3d& axis_T_scan;
    const MeridianSample& places;
    const BinOrder& by_z;

    /// Whether the points within `split` mm from the axis show a wall: those outside lie in the same sectors of the
    /// turn. Those of a mark (the floor of a keyway) lie where the points of the other wall are absent.
    bool isWall(std::size_t from, std::size_t to, double split) const
    {
        std::uint32_t inner = 0, outer = 0;
        for (std::size_t k = from; k < to; ++k) {
            const std::size_t i = by_z.items[k];
            const Eigen::Vector3d p = axis_T_scan * sample[i];
            (places.points[i].r < split ? inner : outer) |= 1u << sectorAbout(p.y(), p.x(), wallSectors);
        }
        return std::popcount(inner & outer) >= wallThresholds.shared_sectors * std::popcount(inner);
    }

    /// The radius in the innermost gap between two walls, of the items from `from` to `to` - 1; NaN: there is one wall.
    double splitOf(std::size_t from, std::size_t to) const
    {
        std::vector<double> radii;
        for (std::size_t k = from; k < to; ++k) radii.push_back(places.points[by_z.items[k]].r);
        const std::size_t least =
            std::max(wallThresholds.least_points, radii.size() * wallThresholds.least_percent / 100);
        if (radii.size() < 2 * least) return notANumber;
        const double gap = std::min(wallThresholds.gap_mm, wallThresholds.gap_share * places.largest_mm);
        const auto [smallest, greatest] = std::minmax_element(radii.begin(), radii.end());
        if (*greatest - *smallest < gap) return notANumber;
        std::sort(radii.begin(), radii.end());
        const auto scatterOfFirst = [&](std::size_t count) {
            std::vector<double> off;
            for (std::size_t k = 0; k < count; ++k) off.push_back(std::abs(radii[k] - radii[count / 2]));
            return madToSigma * upperMedianInPlace(off);
        };
        for (std::size_t place = least; place + least <= radii.size(); ++place) {
            const double wide = radii[place] - radii[place - 1];
            if (wide < gap || wide < wallThresholds.gap_scatters * scatterOfFirst(place)) continue;
            const double split = (radii[place - 1] + radii[place]) / 2;
            if (isWall(from, to, split)) return split;
        }
        return notANumber;
    }
};

}  // namespace

MeridianSample meridianSampleOf(const std::vector<Eigen::Vector3d>& sample, const Eigen::Isometry3d& axis_T_scan)
{
    MeridianSample places;
    places.points.resize(sample.size());
    std::vector<double> radii(sample.size());
    for (std::size_t i = 0; i < sample.size(); ++i) {
        const Eigen::Vector3d p = axis_T_scan * sample[i];
        places.points[i] = {p.z(), p.head<2>().norm()};
        radii[i] = places.points[i].r;
        places.low_mm = std::min(places.low_mm, p.z());
        places.high_mm = std::max(places.high_mm, p.z());
    }
    places.largest_mm = quantileInPlace(radii, wallThresholds.part_quantile);
    return places;
}

std::vector<double> findSplits(const std::vector<Eigen::Vector3d>& sample, const Eigen::Isometry3d& axis_T_scan,
                               const MeridianSample& places, const BinOrder& by_z)
{
    const WallSearch search{sample, axis_T_scan, places, by_z};
    const std::size_t bins = by_z.first.size() - 1;
    const std::size_t merged = (bins + wallThresholds.stretches - 1) / wallThresholds.stretches;
    const std::size_t count = (bins + merged - 1) / merged;
    std::vector<double> splits;
    for (std::size_t b = 0; b < count; ++b)
        splits.push_back(search.splitOf(by_z.first[b * merged], by_z.first[std::min(bins, (b + 1) * merged)]));
    std::vector<double> kept(bins, notANumber);
    for (std::size_t b = 0; b < count; ++b) {
        if (std::isnan(splits[b])) continue;
        int others = 0;
        constexpr std::size_t reach = wallThresholds.stretch_reach;
        for (std::size_t k = b < reach ? 0 : b - reach; k < std::min(count, b + reach + 1); ++k)
            if (k != b && !std::isnan(splits[k])) ++others;
        if (others < wallThresholds.least_neighbours) continue;
        for (std::size_t k = b * merged; k < std::min(bins, (b + 1) * merged); ++k) kept[k] = splits[b];
    }
    return kept;
}

}  // namespace lathelier::registration
