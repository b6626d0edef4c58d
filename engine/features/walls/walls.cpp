#include "engine/features/walls/walls.h"

#include <algorithm>
#include <bitset>
#include <cmath>
#include <limits>
#include <numeric>

#include "engine/core/parallel.h"
#include "engine/core/statistics.h"
#include "engine/registration/revolution/quick_turn.h"

namespace lathelier::features {
namespace {

constexpr int wallSectors = 144;
using Sectors = std::bitset<wallSectors>;

struct Cluster {
    Wall wall;
    Sectors sectors;
    double low_mm = 0, high_mm = 0;
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
    constexpr std::size_t most = 48, least = 9, in_sector = 5;
    const std::size_t count = std::min(most, points.size() / in_sector);
    if (count < least) return points;
    std::vector<std::vector<float>> radii(count);
    const auto sectorOf = [&](std::uint32_t i) {
        return std::min(count - 1, static_cast<std::size_t>(cloud.turn[i] * static_cast<float>(count)));
    };
    for (const std::uint32_t i : points) radii[sectorOf(i)].push_back(cloud.r_mm[i]);
    std::vector<float> medians(count, std::numeric_limits<float>::quiet_NaN()), there;
    for (std::size_t s = 0; s < count; ++s)
        if (radii[s].size() >= 3) there.push_back(medians[s] = static_cast<float>(medianOf(radii[s])));
    if (there.size() < least) return points;
    const auto agrees = [&](std::size_t s, double level) {
        const double error = 1.25 * sigma_mm / std::sqrt(static_cast<double>(radii[s].size()));
        return std::abs(static_cast<double>(medians[s]) - level) < 3 * error;
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
    if (2 * agreed < there.size() || agreed + 2 >= there.size()) return points;
    std::vector<char> good(count, 0);
    for (std::size_t s = 0; s < count; ++s) good[s] = std::isnan(medians[s]) || agrees(s, level) ? 1 : 0;
    std::vector<std::uint32_t> kept;
    for (const std::uint32_t i : points) {
        const std::size_t s = sectorOf(i);
        if (good[s] && good[(s + 1) % count] && good[(s + count - 1) % count]) kept.push_back(i);
    }
    return kept.size() >= points.size() / 4 ? kept : points;
}

/// A wall from points of one bin; the mean of what lies within 4 robust standard deviations of the median.
Cluster clusterOf(const MeridianCloud& cloud, std::vector<std::uint32_t> points, double sigma_mm, double bin_mm)
{
    std::vector<float> radii, offs;
    const auto at = [&](double share) { return static_cast<double>(lowerQuantileInPlace(radii, share)); };
    const auto takeRadii = [&] {
        radii.clear();
        radii.reserve(points.size());
        for (const std::uint32_t i : points) radii.push_back(cloud.r_mm[i]);
        return medianOf(radii);
    };
    double median = takeRadii();
    const double below = median - at(0.08), above = at(0.92) - median;
    if (below - above > sigma_mm) {
        points = withoutMarks(cloud, points, sigma_mm);
        median = takeRadii();
    }
    for (const float r : radii) offs.push_back(static_cast<float>(std::abs(static_cast<double>(r) - median)));
    const double sigma = std::max(madToSigma * medianOf(offs), 0.3 * sigma_mm);
    Cluster cluster;
    cluster.wall.compact = at(0.92) - at(0.08) <= 4.2 * sigma_mm + 1.2 * bin_mm + 0.15;
    double n = 0, sz = 0, szz = 0, sr = 0, srr = 0;
    cluster.low_mm = 1e300;
    cluster.high_mm = -1e300;
    for (const std::uint32_t i : points) {
        const double r = static_cast<double>(cloud.r_mm[i]), z = static_cast<double>(cloud.z_mm[i]);
        if (std::abs(r - median) > 4 * sigma) continue;
        n += 1;
        sz += z;
        szz += z * z;
        sr += r;
        srr += (r - median) * (r - median);
        cluster.low_mm = std::min(cluster.low_mm, r);
        cluster.high_mm = std::max(cluster.high_mm, r);
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
        if (to - from >= 4) {
            const std::vector<std::uint32_t> own(points.begin() + static_cast<std::ptrdiff_t>(from),
                                                 points.begin() + static_cast<std::ptrdiff_t>(to));
            clusters.push_back(clusterOf(cloud, own, sigma_mm, bin_mm));
        }
        from = to;
    }
    std::reverse(clusters.begin(), clusters.end());
    return clusters;
}

/// A chain that continues behind a short gap ends there when other walls lie in the gap: those of a narrow groove.
void splitAtGrooves(std::vector<Chain>& chains, double bin_mm)
{
    constexpr double longerChainShare = 0.4;
    const double blur = 1.5 * bin_mm;  // the bins at an edge show both levels
    const auto fills = [&](const Chain& chain, double from, double to) {
        return chain.zFirst_mm() > from - blur && chain.zLast_mm() < to + blur &&
               chain.zLast_mm() - chain.zFirst_mm() + bin_mm > longerChainShare * (to - from);
    };
    std::vector<Chain> split;
    for (const Chain& chain : chains) {
        auto first = chain.walls.begin();
        for (auto wall = chain.walls.begin(); wall + 1 < chain.walls.end(); ++wall) {
            const double from = wall->z_mm, to = (wall + 1)->z_mm;
            if (to - from <= 2.6 * bin_mm) continue;
            if (std::none_of(chains.begin(), chains.end(), [&](const Chain& one) { return fills(one, from, to); }))
                continue;
            split.push_back({{first, wall + 1}, false});
            first = wall + 1;
        }
        split.push_back({{first, chain.walls.end()}, false});
    }
    chains = std::move(split);
}

/// Share of the sectors that so many points see when they lie evenly about the circle.
double expectedCoverage(double points)
{
    return 1 - std::exp(-points / wallSectors);
}

}  // namespace

MeridianCloud meridianCloud(const std::vector<Eigen::Vector3d>& points, const Progress& progress)
{
    MeridianCloud cloud;
    const std::size_t n = points.size();
    cloud.z_mm.resize(n);
    cloud.r_mm.resize(n);
    cloud.turn.resize(n);
    parallelFor(n, 32768, progress, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const Eigen::Vector3d& p = points[i];
            cloud.z_mm[i] = static_cast<float>(p.z());
            cloud.r_mm[i] = static_cast<float>(std::sqrt(p.x() * p.x() + p.y() * p.y()));
            const double turn = registration::quickTurn(p.y(), p.x());
            cloud.turn[i] = static_cast<float>(turn < 0 ? turn + 1 : turn);
        }
    });
    if (n == 0) return cloud;
    // Stray points beyond the ends: millimetres with less than a tenth of the median number of points.
    const auto [low, high] = std::minmax_element(cloud.z_mm.begin(), cloud.z_mm.end());
    const double first = static_cast<double>(*low), last = static_cast<double>(*high);
    const auto count = static_cast<std::size_t>((last - first) / 0.25) + 1;
    if (count > 4000000) {
        cloud.z_first_mm = first;
        cloud.z_last_mm = last;
        return cloud;
    }
    std::vector<float> counts(count, 0);
    for (const float z : cloud.z_mm) ++counts[static_cast<std::size_t>((static_cast<double>(z) - first) / 0.25)];
    std::vector<float> there;
    for (const float c : counts)
        if (c > 0) there.push_back(c);
    const double usual = medianOf(there);
    cloud.points_per_mm = usual / 0.25;
    std::size_t from = 0, to = count;
    while (from + 1 < to && static_cast<double>(counts[from]) < 0.1 * usual) ++from;
    while (to > from + 1 && static_cast<double>(counts[to - 1]) < 0.1 * usual) --to;
    cloud.z_first_mm = first + 0.25 * static_cast<double>(from) - 0.25;
    cloud.z_last_mm = first + 0.25 * static_cast<double>(to) + 0.25;
    return cloud;
}

Walls findWalls(const MeridianCloud& cloud, double bin_mm, double sigma_mm, const Progress& progress)
{
    const Binned bins = binned(cloud, bin_mm);
    const std::size_t count = bins.start.size() - 1;
    const double gap_mm = std::max(6 * sigma_mm, 0.3);
    std::vector<std::vector<Cluster>> found(count);
    parallelFor(count, 64, progress, [&](std::size_t begin, std::size_t end) {
        for (std::size_t b = begin; b < end; ++b)
            found[b] = clustersOf(cloud, bins.order.data() + bins.start[b], bins.order.data() + bins.start[b + 1],
                                  gap_mm, sigma_mm, bin_mm);
    });
    std::vector<float> counts, covers;
    for (const auto& clusters : found)
        for (const Cluster& cluster : clusters)
            if (cluster.wall.points > 5) {
                counts.push_back(static_cast<float>(cluster.wall.points));
                covers.push_back(static_cast<float>(cluster.wall.coverage / expectedCoverage(cluster.wall.points)));
            }
    Walls walls;
    walls.bin_mm = bin_mm;
    walls.sigma_mm = sigma_mm;
    if (counts.empty()) return walls;
    const double usual_cover = medianOf(covers);
    std::vector<Chain> open, closed;
    for (std::size_t b = 0; b < count; ++b) {
        progress.check();
        std::vector<Cluster>& clusters = found[b];
        // A cluster mostly in sectors without points of the main wall is no separate wall.
        if (clusters.size() > 1) {
            const auto main =
                std::max_element(clusters.begin(), clusters.end(),
                                 [](const Cluster& a, const Cluster& c) { return a.wall.coverage < c.wall.coverage; });
            const Cluster largest = *main;
            std::erase_if(clusters, [&](const Cluster& cluster) {
                if (cluster.sectors == largest.sectors) return false;
                const double own = static_cast<double>(cluster.sectors.count());
                const double apart = static_cast<double>((cluster.sectors & ~largest.sectors).count());
                return apart >= 0.45 * own && own >= 3 && cluster.wall.coverage <= 0.6 * largest.wall.coverage;
            });
        }
        for (const Cluster& cluster : clusters) {
            if (cluster.wall.coverage < 0.35 * usual_cover * expectedCoverage(cluster.wall.points)) continue;
            const double r = cluster.wall.r_mm, z = cluster.wall.z_mm;
            Chain* best = nullptr;
            double nearest = 1e300;
            for (Chain& one : open) {
                const Wall& last = one.walls.back();
                const double dz = z - last.z_mm;
                if (!(dz > 0.2 * bin_mm)) continue;
                const double off = std::abs(r - last.r_mm);
                if (off <= 0.12 + 1.3 * dz && off < nearest) {
                    nearest = off;
                    best = &one;
                }
            }
            if (best)
                best->walls.push_back(cluster.wall);
            else
                open.push_back({{cluster.wall}, false});
        }
        const double z_now = cloud.z_first_mm + static_cast<double>(b + 1) * bin_mm;
        for (auto one = open.begin(); one != open.end();)
            if (z_now - one->zLast_mm() > std::max(2.6 * bin_mm, 1.2)) {
                closed.push_back(std::move(*one));
                one = open.erase(one);
            } else {
                ++one;
            }
    }
    for (Chain& one : open) closed.push_back(std::move(one));
    // Clusters of points of a face are no wall; a rough zone is longer.
    for (Chain& chain : closed) {
        const auto is_face = [&](std::size_t from, std::size_t to) {
            return chain.walls[to - 1].z_mm - chain.walls[from].z_mm < 1.5;
        };
        std::size_t from = 0, to = chain.walls.size();
        while (from < to && !chain.walls[from].compact) ++from;
        if (from > 0 && !is_face(0, from)) from = 0;
        while (to > from && !chain.walls[to - 1].compact) --to;
        if (to < chain.walls.size() && !is_face(to, chain.walls.size())) to = chain.walls.size();
        chain.walls = {chain.walls.begin() + static_cast<std::ptrdiff_t>(from),
                       chain.walls.begin() + static_cast<std::ptrdiff_t>(to)};
    }
    const auto few = [](const Chain& chain) { return chain.walls.size() < 3; };
    std::erase_if(closed, few);
    splitAtGrooves(closed, bin_mm);
    std::erase_if(closed, few);
    // A bore: over most of its length another chain lies outside it by more than 1 mm.
    for (Chain& chain : closed) {
        std::size_t inside = 0;
        for (const Wall& wall : chain.walls)
            for (const Chain& other : closed) {
                if (&other == &chain || other.zFirst_mm() > wall.z_mm || other.zLast_mm() < wall.z_mm) continue;
                const auto near = std::lower_bound(other.walls.begin(), other.walls.end(), wall.z_mm,
                                                   [](const Wall& w, double z) { return w.z_mm < z; });
                if (near != other.walls.end() && near->r_mm > wall.r_mm + 1 &&
                    std::abs(near->z_mm - wall.z_mm) < std::max(3 * bin_mm, 1.0)) {
                    ++inside;
                    break;
                }
            }
        chain.bore = 2 * inside > chain.walls.size();
    }
    std::stable_sort(closed.begin(), closed.end(), [](const Chain& a, const Chain& b) {
        return a.bore != b.bore ? b.bore : a.zFirst_mm() + a.zLast_mm() < b.zFirst_mm() + b.zLast_mm();
    });
    // Noise of single points, from the smooth walls without rough zones.
    std::vector<float> scatter;
    for (const Chain& chain : closed)
        for (const Wall& wall : chain.walls) scatter.push_back(static_cast<float>(wall.sigma_mm));
    if (scatter.size() > 4) {
        const double median = medianOf(scatter);
        std::sort(scatter.begin(), scatter.end());
        const double quiet = static_cast<double>(scatter[scatter.size() / 5]);
        walls.sigma_mm = quiet < median / 1.33 ? quiet : median;
    }
    walls.chains = std::move(closed);
    return walls;
}

}  // namespace lathelier::features
