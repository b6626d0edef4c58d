#include "engine/features/walls/wall_chains.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/features/walls/wall_limits.h"

namespace lathelier::features {
namespace {

/// Both parts of a row of points that the border of two bins divides, as one wall. Each part alone is off where noise
/// along the ray moves points across the border.
Wall joined(const Wall& a, const Wall& b)
{
    Wall wall = a.points < b.points ? b : a;
    const double n = a.points + b.points, share = b.points / n, apart = share * (1 - share);
    const auto spread = [&](double of_a, double of_b, double distance) {
        return std::sqrt((1 - share) * of_a * of_a + share * of_b * of_b + apart * distance * distance);
    };
    const double dz = b.z_mm - a.z_mm, dr = b.r_mm - a.r_mm;
    wall.z_mm = a.z_mm + share * dz;
    wall.r_mm = a.r_mm + share * dr;
    wall.sigma_mm = spread(a.sigma_mm, b.sigma_mm, dr);
    wall.width_mm = spread(a.width_mm, b.width_mm, std::sqrt(12) * dz);
    wall.points = n;
    wall.coverage = std::max(a.coverage, b.coverage);
    return wall;
}

/// Too near to each other for two rows, or one of them a few points at the edge of the other.
bool areOneRow(const Wall& last, const Wall& wall, double bin_mm)
{
    const double dz = wall.z_mm - last.z_mm;
    const bool has_few = std::min(last.points, wall.points) < wallLimits.few_share * std::max(last.points, wall.points);
    return dz < (has_few ? wallLimits.one_row_bins : wallLimits.next_wall_bins) * bin_mm &&
           std::abs(wall.r_mm - last.r_mm) < wallLimits.chain_step_mm;
}

}  // namespace

void appendWall(std::vector<Chain>& open, const Wall& wall, double bin_mm)
{
    Chain* best = nullptr;
    double nearest = std::numeric_limits<double>::infinity();
    for (Chain& one : open) {
        Wall& last = one.walls.back();
        if (areOneRow(last, wall, bin_mm)) {
            last = joined(last, wall);
            return;
        }
        const double dz = wall.z_mm - last.z_mm;
        if (!(dz > wallLimits.next_wall_bins * bin_mm)) continue;
        const double off = std::abs(wall.r_mm - last.r_mm);
        // Of a bin with the end of a flank the mean is that of the wall behind it.
        const double steepest = std::max({1.0, std::abs(last.slope), std::abs(wall.slope)});
        if (off <= wallLimits.chain_step_mm + wallLimits.chain_slope * steepest * dz +
                       wallLimits.compact_mm * (steepest - 1) &&
            off < nearest) {
            nearest = off;
            best = &one;
        }
    }
    if (best)
        best->walls.push_back(wall);
    else
        open.push_back({{wall}, false});
}

void splitAtGrooves(std::vector<Chain>& chains, double bin_mm)
{
    const double blur = wallLimits.groove_blur_bins * bin_mm;
    const auto fills = [&](const Chain& chain, double from, double to) {
        return chain.zFirst_mm() > from - blur && chain.zLast_mm() < to + blur &&
               chain.zLast_mm() - chain.zFirst_mm() + bin_mm > wallLimits.groove_fill_share * (to - from);
    };
    std::vector<Chain> split;
    for (const Chain& chain : chains) {
        auto first = chain.walls.begin();
        for (auto wall = chain.walls.begin(); wall + 1 < chain.walls.end(); ++wall) {
            const double from = wall->z_mm, to = (wall + 1)->z_mm;
            if (to - from <= wallLimits.chain_gap_bins * bin_mm) continue;
            if (std::none_of(chains.begin(), chains.end(), [&](const Chain& one) { return fills(one, from, to); }))
                continue;
            split.push_back({{first, wall + 1}, false});
            first = wall + 1;
        }
        split.push_back({{first, chain.walls.end()}, false});
    }
    chains = std::move(split);
}

void trimFaces(Chain& chain)
{
    const auto isFace = [&](std::size_t from, std::size_t to) {
        return chain.walls[to - 1].z_mm - chain.walls[from].z_mm < wallLimits.longest_face_mm;
    };
    std::size_t from = 0, to = chain.walls.size();
    while (from < to && !chain.walls[from].compact) ++from;
    if (from > 0 && !isFace(0, from)) from = 0;
    while (to > from && !chain.walls[to - 1].compact) --to;
    if (to < chain.walls.size() && !isFace(to, chain.walls.size())) to = chain.walls.size();
    chain.walls = {chain.walls.begin() + static_cast<std::ptrdiff_t>(from),
                   chain.walls.begin() + static_cast<std::ptrdiff_t>(to)};
}

bool isBore(const Chain& chain, const std::vector<Chain>& chains, double bin_mm)
{
    const double search_mm = std::max(wallLimits.bore_search_bins * bin_mm, wallLimits.bore_search_mm);
    const auto isInside = [&](const Wall& wall, const Chain& other) {
        if (&other == &chain || other.zFirst_mm() > wall.z_mm || other.zLast_mm() < wall.z_mm) return false;
        const auto near = std::lower_bound(other.walls.begin(), other.walls.end(), wall.z_mm,
                                           [](const Wall& w, double z) { return w.z_mm < z; });
        return near != other.walls.end() && near->r_mm > wall.r_mm + wallLimits.bore_wall_mm &&
               std::abs(near->z_mm - wall.z_mm) < search_mm;
    };
    const auto inside = std::count_if(chain.walls.begin(), chain.walls.end(), [&](const Wall& wall) {
        return std::any_of(chains.begin(), chains.end(), [&](const Chain& other) { return isInside(wall, other); });
    });
    return 2 * static_cast<std::size_t>(inside) > chain.walls.size();
}

}  // namespace lathelier::features
