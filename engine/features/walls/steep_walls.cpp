#include "engine/features/walls/steep_walls.h"

#include <cmath>
#include <limits>

#include "engine/features/walls/wall_limits.h"

namespace lathelier::features {
namespace {

/// A wall in the middle of three that follow each other evenly.
struct Middle {
    const Wall* next = nullptr;  ///< the third of them; null: none
    double slope = 0;
};

/// Standard error of the slope between the means of two walls.
double slopeError(const Wall& a, const Wall& b)
{
    const auto variance = [](const Wall& wall) { return wall.sigma_mm * wall.sigma_mm / std::max(1.0, wall.points); };
    return std::sqrt(variance(a) + variance(b)) / (b.z_mm - a.z_mm);
}

bool spreadFits(const Wall& wall, double slope, double sigma_mm, double bin_mm)
{
    const SteepLimits& limits = steepLimits;
    const double steep = std::abs(slope), along = limits.quantile_share * steep * bin_mm;
    const double noise = wallLimits.compact_sigmas * sigma_mm * std::sqrt(1 + steep * steep);
    return wall.spread_mm > limits.least_fill * along && wall.spread_mm < along + noise + wallLimits.compact_mm * steep;
}

/// The evenly following walls about `wall` that its own spread confirms; the most even ones.
Middle middleOf(const Wall& wall, const std::vector<Wall*>& before, const std::vector<Wall*>& behind, double sigma_mm,
                double bin_mm)
{
    const SteepLimits& limits = steepLimits;
    Middle best;
    double least = std::numeric_limits<double>::infinity();
    for (const Wall* a : before)
        for (const Wall* b : behind) {
            if (!(wall.z_mm > a->z_mm && b->z_mm > wall.z_mm)) continue;
            const double one = (wall.r_mm - a->r_mm) / (wall.z_mm - a->z_mm);
            const double two = (b->r_mm - wall.r_mm) / (b->z_mm - wall.z_mm), slope = (one + two) / 2;
            const double error = std::hypot(slopeError(*a, wall), slopeError(wall, *b));
            const double uneven = std::abs(one - two);
            if (one * two < 0 || std::abs(slope) < limits.least_slope || std::abs(slope) > limits.largest_slope ||
                uneven > limits.uneven_share * std::abs(slope) + limits.uneven_errors * error || uneven >= least ||
                !spreadFits(wall, slope, sigma_mm, bin_mm))
                continue;
            least = uneven;
            best = {b, slope};
        }
    return best;
}

}  // namespace

void findSteepWalls(const std::vector<std::vector<Wall*>>& bins, double sigma_mm, double bin_mm)
{
    std::vector<std::vector<Middle>> middles(bins.size());
    for (std::size_t b = 0; b < bins.size(); ++b)
        for (const Wall* wall : bins[b])
            middles[b].push_back(
                b > 0 && b + 1 < bins.size() ? middleOf(*wall, bins[b - 1], bins[b + 1], sigma_mm, bin_mm) : Middle{});
    // The run of middles that begins at wall i of bin b.
    const auto follow = [&](std::size_t b, std::size_t i, auto&& visit) {
        std::size_t length = 0;
        for (; b < bins.size(); ++b) {
            const Middle& here = middles[b][i];
            if (!here.next) break;
            ++length;
            visit(*bins[b][i], here.slope);
            if (b + 1 >= bins.size()) break;
            std::size_t next = 0;
            while (next < bins[b + 1].size() && bins[b + 1][next] != here.next) ++next;
            if (next == bins[b + 1].size()) break;
            i = next;
        }
        return length;
    };
    for (std::size_t b = 0; b < bins.size(); ++b)
        for (std::size_t i = 0; i < bins[b].size(); ++i) {
            if (!middles[b][i].next || bins[b][i]->slope != 0) continue;
            if (follow(b, i, [](Wall&, double) {}) < steepLimits.least_walls) continue;
            follow(b, i, [](Wall& wall, double slope) {
                wall.slope = slope;
                wall.compact = true;
            });
        }
}

}  // namespace lathelier::features
