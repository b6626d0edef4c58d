#include "engine/features/structure/bore_proof.h"

#include <algorithm>
#include <bitset>
#include <cmath>

#include "engine/core/statistics.h"

namespace lathelier::features {
namespace {

using FineSectors = std::bitset<static_cast<std::size_t>(boreThresholds.sectors)>;
using AroundSectors = std::bitset<static_cast<std::size_t>(boreThresholds.around_sectors)>;

/// Sectors where a wall is seen, by cell along z.
struct SeenSectors {
    std::vector<FineSectors> by_z;
    AroundSectors around;

    void add(std::size_t row, float turn)
    {
        const auto in = [turn](int count) {
            return std::min(static_cast<std::size_t>(count) - 1,
                            static_cast<std::size_t>(turn * static_cast<float>(count)));
        };
        by_z[row].set(in(boreThresholds.sectors));
        around.set(in(boreThresholds.around_sectors));
    }
};

/// Points at the axis itself, as on the floor of a cross hole, lie on no side of it.
bool isAtAxis(const Chain& chain, double near_mm)
{
    std::vector<double> radii_mm;
    radii_mm.reserve(chain.walls.size());
    for (const Wall& wall : chain.walls) radii_mm.push_back(wall.r_mm);
    return upperMedianInPlace(radii_mm) < near_mm;
}

double radiusOf_mm(const Chain& chain, double z_mm)
{
    const auto next = std::lower_bound(chain.walls.begin(), chain.walls.end(), z_mm,
                                       [](const Wall& wall, double z) { return wall.z_mm < z; });
    return next == chain.walls.end() ? chain.walls.back().r_mm : next->r_mm;
}

/// Is the chain seen where the outside is, and around?
bool isBore(const MeridianCloud& cloud, const SurfaceTable& outside, double sigma_mm, const Chain& chain)
{
    const double first = chain.zFirst_mm(), near = boreThresholds.near_sigmas * sigma_mm + mapThresholds.far_mm;
    if (isAtAxis(chain, near)) return false;
    const auto rows = static_cast<std::size_t>((chain.zLast_mm() - first) / boreThresholds.cell_mm) + 1;
    SeenSectors inner{std::vector<FineSectors>(rows), {}}, outer{std::vector<FineSectors>(rows), {}};
    AroundSectors around;
    for (std::size_t i = 0; i < cloud.z_mm.size(); ++i) {
        const auto z = static_cast<double>(cloud.z_mm[i]), r = static_cast<double>(cloud.r_mm[i]);
        const SurfaceTable::Place& place = outside.at(z);
        const bool on_outside = place.run >= 0 && std::abs(r - static_cast<double>(place.radius_mm)) < near;
        if (on_outside)
            around.set(std::min(around.size() - 1,
                                static_cast<std::size_t>(cloud.turn[i] * static_cast<float>(around.size()))));
        const double row = (z - first) / boreThresholds.cell_mm;
        if (row < 0 || row >= static_cast<double>(rows)) continue;
        if (on_outside) outer.add(static_cast<std::size_t>(row), cloud.turn[i]);
        if (std::abs(r - radiusOf_mm(chain, z)) < near) inner.add(static_cast<std::size_t>(row), cloud.turn[i]);
    }
    if (static_cast<double>(inner.around.count()) < boreThresholds.least_around * static_cast<double>(around.count()))
        return false;
    double shared = 0, expected = 0;
    for (std::size_t row = 0; row < rows; ++row) {
        shared += static_cast<double>((inner.by_z[row] & outer.by_z[row]).count());
        expected += static_cast<double>(inner.by_z[row].count()) * static_cast<double>(outer.by_z[row].count()) /
                    boreThresholds.sectors;
    }
    return shared >= boreThresholds.least_shared * expected;
}

}  // namespace

void keepProvenBores(const MeridianCloud& cloud, const SurfaceTable& outside, double sigma_mm, Walls& coarse,
                     Walls& fine, const Progress& progress)
{
    for (Walls* const walls : {&coarse, &fine})
        std::erase_if(walls->chains, [&](const Chain& chain) {
            progress.check();
            return chain.bore && !isBore(cloud, outside, sigma_mm, chain);
        });
}

}  // namespace lathelier::features
