#include "engine/features/structure/noise_correlation.h"

#include <algorithm>
#include <cmath>

#include "engine/core/statistics.h"
#include "engine/core/units.h"

namespace lathelier::features {
namespace {

constexpr CorrelationThresholds limits = correlationThresholds;
constexpr std::size_t sectors = ResidualMap::sectors;
constexpr double medianOfChiSquare = 0.4549;  ///< with one degree of freedom

struct Patch {
    double sum_mm = 0, points = 0;
};

/// Patches of one element.
std::vector<Patch> patchesOf(const ResidualMap& map, const SurfaceTable& surface, const Run& run, std::size_t element)
{
    const double from = run.nodes_mm[element], to = run.nodes_mm[element + 1];
    const double radius = run.elements[element].radiusAt_mm((from + to) / 2);
    const auto along = std::max<std::size_t>(1, static_cast<std::size_t>((to - from) / limits.patch_mm));
    const auto around = static_cast<std::size_t>(turn_rad * radius / limits.patch_mm);
    if (around < 3) return {};
    std::vector<Patch> patches(along * around);
    for (std::size_t row = 0; row < map.rows; ++row) {
        const double z = map.middle_mm(row);
        if (z < from || z > to || surface.at(z).run < 0) continue;
        const auto a =
            std::min(along - 1, static_cast<std::size_t>((z - from) / (to - from) * static_cast<double>(along)));
        for (std::size_t s = 0; s < sectors; ++s) {
            const MapCell& cell = map.at(row, s);
            if (cell.far > cell.on) continue;
            Patch& patch = patches[a * around + s * around / sectors];
            patch.sum_mm += static_cast<double>(cell.sum_mm);
            patch.points += static_cast<double>(cell.on);
        }
    }
    std::erase_if(patches, [](const Patch& patch) { return patch.points < limits.least_points; });
    return patches;
}

}  // namespace

double varianceRatio(const ResidualMap& map, const SurfaceTable& surface, const Model& outside)
{
    const double sigma = std::max(map.sigma_mm, 1e-6);
    std::vector<double> squares;
    for (const Run& run : outside.runs)
        for (std::size_t k = 0; k < run.elements.size(); ++k) {
            if (run.elements[k].rough) continue;
            const std::vector<Patch> patches = patchesOf(map, surface, run, k);
            if (patches.size() < 4) continue;
            double sum = 0, points = 0;
            for (const Patch& patch : patches) {
                sum += patch.sum_mm;
                points += patch.points;
            }
            const double freedom = static_cast<double>(patches.size() - 1) / static_cast<double>(patches.size());
            for (const Patch& patch : patches) {
                const double off = patch.sum_mm / patch.points - sum / points;
                squares.push_back(patch.points * off * off / (sigma * sigma * freedom));
            }
        }
    if (squares.size() < limits.least_patches) return 1;
    const double count = static_cast<double>(squares.size());
    const double ratio = median(std::move(squares)) / medianOfChiSquare;
    // Standard deviation of the median of χ² with one degree of freedom: ½ over its density there and √n.
    constexpr double densityAtMedian = 0.4714;
    const double sure = 1 + limits.sure_sigmas * 0.5 / (densityAtMedian * medianOfChiSquare * std::sqrt(count));
    return ratio > sure ? ratio : 1;
}

double differenceOfPasses_um(const Outline& outside)
{
    const Model& model = outside.model;
    std::vector<double> ratios, noise;
    for (const Run& run : model.runs) {
        double before = 0, variance_before = 0;
        bool has_before = false;
        for (const Wall& wall : run.walls) {
            if (run.elements.front().rough || !counts(model, run, wall)) {
                has_before = false;
                continue;
            }
            const double off = wall.r_mm - predicted_mm(model, run, wall);
            const double variance = sigmaOf(model, wall) * sigmaOf(model, wall);
            if (has_before) {
                ratios.push_back((off - before) * (off - before) / (variance + variance_before));
                noise.push_back((variance + variance_before) / 2);
            }
            before = off;
            variance_before = variance;
            has_before = true;
        }
    }
    if (ratios.size() < limits.least_bins) return 0;
    const double ratio = median(std::move(ratios)) / medianOfChiSquare;
    if (ratio < limits.least_bin_ratio) return 0;
    return 1e3 * std::sqrt((ratio - 1) * median(std::move(noise)));
}

}  // namespace lathelier::features
