#include "engine/features/walls/walls.h"

#include <algorithm>
#include <bitset>
#include <cmath>
#include <limits>
#include <numeric>

#include "engine/core/parallel.h"
#include "engine/core/statistics.h"
#include "engine/features/walls/steep_walls.h"
#include "engine/features/walls/wall_chains.h"
#include "engine/features/walls/wall_limits.h"

namespace lathelier::features {
namespace {

constexpr int wallSectors = 144;  // of the circle: the resolution of a wall's coverage
using Sectors = std::bitset<wallSectors>;

struct Cluster {
    Wall wall;
    Sectors sectors;
};

double medianOf(std::vector<float>& values)
{
    return static_cast<double>(upperMedianInPlace(values));
}

/// Points of the cloud by bins: `order[start[b] … start[b+1]]`.
struct Binned {
    std::vector<std::uint32_t> order, start;
};

Binned binned(const MeridianCloud& cloud, double bin_mm)
{
    const auto count =
        static_cast<std::size_t>(std::max(1.0, std::ceil((cloud.z_last_mm - cloud.z_first_mm) / bin_mm)));
    Binned result;
    result.start.assign(count + 1, 0);
    const auto place = [&](std::size_t i) {
        return static_cast<std::size_t>((static_cast<double>(cloud.z_mm[i]) - cloud.z_first_mm) / bin_mm);
    };
    const auto inside = [&](std::size_t i) {
        const auto z = static_cast<double>(cloud.z_mm[i]);
        return z >= cloud.z_first_mm && place(i) < count;
    };
    for (std::size_t i = 0; i < cloud.z_mm.size(); ++i)
        if (inside(i)) ++result.start[place(i) + 1];
    std::partial_sum(result.start.begin(), result.start.end(), result.start.begin());
    result.order.resize(result.start.back());
    std::vector<std::uint32_t> next(result.start.begin(), result.start.end() - 1);
    for (std::size_t i = 0; i < cloud.z_mm.size(); ++i)
        if (inside(i)) result.order[next[place(i)]++] = static_cast<std::uint32_t>(i);
    return result;
}

/// Points on a flat or in a slot lie below the wall, near its rim by less than the noise: sectors whose median differs
/// from the modal one are left out, with their neighbours. Nothing when less than half of the sectors agree.
std::vector<std::uint32_t> withoutMarks(const MeridianCloud& cloud, const std::vector<std::uint32_t>& points,
                                        double sigma_mm)
{
    const WallLimits& limits = wallLimits;
    const std::size_t count = std::min(limits.most_mark_sectors, points.size() / limits.points_per_mark_sector);
    if (count < limits.least_mark_sectors) return points;
    std::vector<std::vector<float>> radii(count);
    const auto sectorOf = [&](std::uint32_t i) {
        return std::min(count - 1, static_cast<std::size_t>(cloud.turn[i] * static_cast<float>(count)));
    };
    for (const std::uint32_t i : points) radii[sectorOf(i)].push_back(cloud.r_mm[i]);
    std::vector<float> medians(count, std::numeric_limits<float>::quiet_NaN()), there;
    for (std::size_t s = 0; s < count; ++s)
        if (radii[s].size() >= limits.least_median_points)
            there.push_back(medians[s] = static_cast<float>(medianOf(radii[s])));
    if (there.size() < limits.least_mark_sectors) return points;
    const auto agrees = [&](std::size_t s, double level) {
        const double error = limits.median_error_factor * sigma_mm / std::sqrt(static_cast<double>(radii[s].size()));
        return std::abs(static_cast<double>(medians[s]) - level) < limits.agreeing_errors * error;
    };
    // The level with which most sectors agree: that of the wall, even if a mark covers nearly half of them.
    std::sort(there.begin(), there.end());
    std::size_t agreed = 0;
    double level = 0;
    for (const float candidate : there) {
        std::size_t number = 0;
        for (std::size_t s = 0; s < count; ++s)
            if (!std::isnan(medians[s]) && agrees(s, static_cast<double>(candidate))) ++number;
        if (number <= agreed) continue;
        agreed = number;
        level = static_cast<double>(candidate);
    }
    if (2 * agreed < there.size() || agreed + limits.most_odd_sectors >= there.size()) return points;
    std::vector<char> good(count, 0);
    for (std::size_t s = 0; s < count; ++s) good[s] = std::isnan(medians[s]) || agrees(s, level) ? 1 : 0;
    std::vector<std::uint32_t> kept;
    for (const std::uint32_t i : points) {
        const std::size_t s = sectorOf(i);
        if (good[s] && good[(s + 1) % count] && good[(s + count - 1) % count]) kept.push_back(i);
    }
    return kept.size() >= points.size() / limits.least_kept_part ? kept : points;
}

/// A wall from points of one bin; the mean of what lies within 4 robust standard deviations of the median.
Cluster clusterOf(const MeridianCloud& cloud, std::vector<std::uint32_t> points, double sigma_mm, double bin_mm)
{
    const WallLimits& limits = wallLimits;
    std::vector<float> radii, offs;
    const auto at = [&](double share) { return static_cast<double>(lowerQuantileInPlace(radii, share)); };
    const auto takeRadii = [&] {
        radii.clear();
        radii.reserve(points.size());
        for (const std::uint32_t i : points) radii.push_back(cloud.r_mm[i]);
        return medianOf(radii);
    };
    double median = takeRadii();
    const double below = median - at(limits.low_share), above = at(limits.high_share) - median;
    if (below - above > sigma_mm) {
        points = withoutMarks(cloud, points, sigma_mm);
        median = takeRadii();
    }
    for (const float r : radii) offs.push_back(static_cast<float>(std::abs(static_cast<double>(r) - median)));
    const double sigma = std::max(madToSigma * medianOf(offs), limits.least_sigma_share * sigma_mm);
    Cluster cluster;
    cluster.wall.spread_mm = at(limits.high_share) - at(limits.low_share);
    cluster.wall.compact =
        cluster.wall.spread_mm <= limits.compact_sigmas * sigma_mm + limits.compact_bins * bin_mm + limits.compact_mm;
    double n = 0, sz = 0, szz = 0, sr = 0, srr = 0;
    for (const std::uint32_t i : points) {
        const double r = static_cast<double>(cloud.r_mm[i]), z = static_cast<double>(cloud.z_mm[i]);
        if (std::abs(r - median) > limits.outlier_sigmas * sigma) continue;
        n += 1;
        sz += z;
        szz += z * z;
        sr += r;
        srr += (r - median) * (r - median);
        cluster.sectors.set(
            std::min<std::size_t>(wallSectors - 1, static_cast<std::size_t>(cloud.turn[i] * wallSectors)));
    }
    Wall& wall = cluster.wall;
    wall.points = n;
    wall.z_mm = sz / n;
    wall.r_mm = sr / n;
    wall.width_mm = std::sqrt(12 * std::max(0.0, szz / n - wall.z_mm * wall.z_mm));
    wall.sigma_mm = std::sqrt(std::max(0.0, srr / n - (wall.r_mm - median) * (wall.r_mm - median)));
    wall.coverage = static_cast<double>(cluster.sectors.count()) / wallSectors;
    return cluster;
}

/// Points of a bin in clusters, by falling radius; they are apart by more than `gap_mm`.
std::vector<Cluster> clustersOf(const MeridianCloud& cloud, const std::uint32_t* begin, const std::uint32_t* end,
                                double gap_mm, double sigma_mm, double bin_mm)
{
    std::vector<std::uint32_t> points(begin, end);
    std::sort(points.begin(), points.end(), [&](std::uint32_t a, std::uint32_t b) {
        return cloud.r_mm[a] != cloud.r_mm[b] ? cloud.r_mm[a] < cloud.r_mm[b] : a < b;
    });
    std::vector<Cluster> clusters;
    for (std::size_t from = 0; from < points.size();) {
        std::size_t to = from + 1;
        while (to < points.size() && static_cast<double>(cloud.r_mm[points[to]] - cloud.r_mm[points[to - 1]]) <= gap_mm)
            ++to;
        if (to - from >= wallLimits.least_cluster_points) {
            const std::vector<std::uint32_t> own(points.begin() + static_cast<std::ptrdiff_t>(from),
                                                 points.begin() + static_cast<std::ptrdiff_t>(to));
            clusters.push_back(clusterOf(cloud, own, sigma_mm, bin_mm));
        }
        from = to;
    }
    std::reverse(clusters.begin(), clusters.end());
    return clusters;
}

/// Share of the sectors that so many points see when they lie evenly about the circle.
double expectedCoverage(double points)
{
    return 1 - std::exp(-points / wallSectors);
}

using ClustersOfBins = std::vector<std::vector<Cluster>>;

ClustersOfBins clustersOfBins(const MeridianCloud& cloud, const Binned& bins, double bin_mm, double sigma_mm,
                              const Progress& progress)
{
    const std::size_t count = bins.start.size() - 1;
    const double gap_mm = clusterGap_mm(sigma_mm);
    ClustersOfBins found(count);
    parallelFor(count, 64, progress, [&](std::size_t begin, std::size_t end) {
        for (std::size_t b = begin; b < end; ++b)
            found[b] = clustersOf(cloud, bins.order.data() + bins.start[b], bins.order.data() + bins.start[b + 1],
                                  gap_mm, sigma_mm, bin_mm);
    });
    return found;
}

/// Median of the clusters' coverage against that of evenly spread points; NaN without clusters.
double usualCoverage(const ClustersOfBins& found)
{
    std::vector<float> coverages;
    for (const auto& clusters : found)
        for (const Cluster& cluster : clusters)
            if (cluster.wall.points > wallLimits.least_counted_points)
                coverages.push_back(static_cast<float>(cluster.wall.coverage / expectedCoverage(cluster.wall.points)));
    return medianOf(coverages);
}

/// A cluster mostly in sectors without points of the main wall is no separate wall.
void eraseMarks(std::vector<Cluster>& clusters)
{
    if (clusters.size() < 2) return;
    const Cluster largest = *std::max_element(clusters.begin(), clusters.end(), [](const Cluster& a, const Cluster& c) {
        return a.wall.coverage < c.wall.coverage;
    });
    std::erase_if(clusters, [&](const Cluster& cluster) {
        if (cluster.sectors == largest.sectors) return false;
        const double own = static_cast<double>(cluster.sectors.count());
        const double apart = static_cast<double>((cluster.sectors & ~largest.sectors).count());
        return apart >= wallLimits.apart_share * own && own >= wallLimits.least_apart_sectors &&
               cluster.wall.coverage <= wallLimits.mark_coverage_share * largest.wall.coverage;
    });
}

/// Walls of neighbouring bins in chains, in the order in which the chains end.
std::vector<Chain> linkedChains(const MeridianCloud& cloud, ClustersOfBins& found, double bin_mm,
                                const Progress& progress)
{
    const double usual_coverage = usualCoverage(found);
    if (std::isnan(usual_coverage)) return {};
    std::vector<Chain> open, closed;
    for (std::size_t b = 0; b < found.size(); ++b) {
        progress.check();
        eraseMarks(found[b]);
        for (const Cluster& cluster : found[b])
            if (!(cluster.wall.coverage <
                  wallLimits.least_coverage_share * usual_coverage * expectedCoverage(cluster.wall.points)))
                appendWall(open, cluster.wall, bin_mm);
        const double z_now = cloud.z_first_mm + static_cast<double>(b + 1) * bin_mm;
        for (auto one = open.begin(); one != open.end();)
            if (z_now - one->zLast_mm() > std::max(wallLimits.chain_gap_bins * bin_mm, wallLimits.chain_gap_mm)) {
                closed.push_back(std::move(*one));
                one = open.erase(one);
            } else {
                ++one;
            }
    }
    for (Chain& one : open) closed.push_back(std::move(one));
    return closed;
}

/// Noise of single points from the smooth walls, without rough zones; `stated_mm` where there are too few.
double noiseOf_mm(const std::vector<Chain>& chains, double stated_mm)
{
    std::vector<float> scatter;
    for (const Chain& chain : chains)
        for (const Wall& wall : chain.walls) scatter.push_back(static_cast<float>(wall.sigma_mm));
    if (scatter.size() < wallLimits.least_noise_walls) return stated_mm;
    const double median = medianOf(scatter);
    const double quiet = static_cast<double>(quantileInPlace(scatter, wallLimits.quiet_share));
    return quiet < median / wallLimits.quiet_ratio ? quiet : median;
}

}  // namespace

double clusterGap_mm(double sigma_mm)
{
    return std::max(wallLimits.cluster_gap_sigmas * sigma_mm, wallLimits.cluster_gap_mm);
}

Walls findWalls(const MeridianCloud& cloud, double bin_mm, double sigma_mm, const Progress& progress)
{
    ClustersOfBins found = clustersOfBins(cloud, binned(cloud, bin_mm), bin_mm, sigma_mm, progress);
    std::vector<std::vector<Wall*>> walls_of_bins(found.size());
    for (std::size_t b = 0; b < found.size(); ++b)
        for (Cluster& cluster : found[b]) walls_of_bins[b].push_back(&cluster.wall);
    findSteepWalls(walls_of_bins, sigma_mm, bin_mm);
    Walls walls;
    walls.bin_mm = bin_mm;
    std::vector<Chain> chains = linkedChains(cloud, found, bin_mm, progress);
    for (Chain& chain : chains) trimFaces(chain);
    const auto isShort = [](const Chain& chain) { return chain.walls.size() < wallLimits.least_chain_walls; };
    std::erase_if(chains, isShort);
    splitAtGrooves(chains, bin_mm);
    std::erase_if(chains, isShort);
    for (Chain& chain : chains) chain.bore = isBore(chain, chains, bin_mm);
    std::stable_sort(chains.begin(), chains.end(), [](const Chain& a, const Chain& b) {
        return a.bore != b.bore ? b.bore : a.zFirst_mm() + a.zLast_mm() < b.zFirst_mm() + b.zLast_mm();
    });
    walls.sigma_mm = noiseOf_mm(chains, sigma_mm);
    walls.chains = std::move(chains);
    return walls;
}

Walls withSharedErrors(Walls walls, double variance_ratio, double passes_mm)
{
    for (Chain& chain : walls.chains)
        for (Wall& wall : chain.walls) {
            const double independent = wall.sigma_mm * wall.sigma_mm / std::max(1.0, wall.points);
            wall.shared_mm =
                std::hypot(wall.shared_mm, std::sqrt((variance_ratio - 1) * independent + passes_mm * passes_mm));
        }
    return walls;
}

}  // namespace lathelier::features
