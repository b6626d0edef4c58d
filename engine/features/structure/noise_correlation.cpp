#include "engine/features/structure/noise_correlation.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/core/statistics.h"
#include "engine/core/units.h"

namespace lathelier::features {
namespace {

constexpr double medianOfChiSquare = 0.4549;  ///< with one degree of freedom

struct Patch {
    double sum_mm = 0, points = 0;
};

/// Patches of one element, by stretches along z: what is the same all around is form of the meridian.
std::vector<std::vector<Patch>> patchesOf(const ResidualMap& map, const SurfaceTable& surface, const Run& run,
                                          std::size_t element)
{
    const double from = run.nodes_mm[element], to = run.nodes_mm[element + 1];
    const double radius = run.elements[element].radiusAt_mm((from + to) / 2);
    const auto along = std::max<std::size_t>(1, static_cast<std::size_t>((to - from) / correlationThresholds.patch_mm));
    const auto around = static_cast<std::size_t>(turn_rad * radius / correlationThresholds.patch_mm);
    if (around < correlationThresholds.least_ring) return {};
    std::vector<std::vector<Patch>> patches(along, std::vector<Patch>(around));
    for (std::size_t row = 0; row < map.rows; ++row) {
        const double z = map.middle_mm(row);
        if (z < from || z > to || surface.at(z).run < 0) continue;
        const auto a =
            std::min(along - 1, static_cast<std::size_t>((z - from) / (to - from) * static_cast<double>(along)));
        for (std::size_t s = 0; s < mapSectors; ++s) {
            const MapCell& cell = map.at(row, s);
            if (cell.far > cell.on) continue;
            Patch& patch = patches[a][s * around / mapSectors];
            patch.sum_mm += static_cast<double>(cell.sum_mm);
            patch.points += static_cast<double>(cell.on);
        }
    }
    for (std::vector<Patch>& ring : patches)
        std::erase_if(ring, [](const Patch& patch) { return patch.points < correlationThresholds.least_points; });
    return patches;
}

/// Squares of the means of patches about that of their ring, over their variance if points were independent.
void addSquares(const std::vector<Patch>& ring, double sigma_mm, std::vector<double>& squares)
{
    if (ring.size() < correlationThresholds.least_ring) return;
    double sum = 0, points = 0;
    for (const Patch& patch : ring) {
        sum += patch.sum_mm;
        points += patch.points;
    }
    const double freedom = static_cast<double>(ring.size() - 1) / static_cast<double>(ring.size());
    for (const Patch& patch : ring) {
        const double off = patch.sum_mm / patch.points - sum / points;
        squares.push_back(patch.points * off * off / (sigma_mm * sigma_mm * freedom));
    }
}

}  // namespace

double varianceRatio(const ResidualMap& map, const SurfaceTable& surface, const Model& outside)
{
    const double sigma = std::max(map.sigma_mm, 1e-6);
    std::vector<double> squares;
    for (const Run& run : outside.runs)
        for (std::size_t k = 0; k < run.elements.size(); ++k) {
            if (run.elements[k].rough) continue;
            for (const std::vector<Patch>& ring : patchesOf(map, surface, run, k)) addSquares(ring, sigma, squares);
        }
    if (squares.size() < correlationThresholds.least_patches) return 1;
    const double count = static_cast<double>(squares.size());
    const double ratio = median(std::move(squares)) / medianOfChiSquare;
    // Standard deviation of the median of χ² with one degree of freedom: ½ over its density there and √n.
    constexpr double densityAtMedian = 0.4714;
    const double sure =
        1 + correlationThresholds.sure_sigmas * 0.5 / (densityAtMedian * medianOfChiSquare * std::sqrt(count));
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
    if (ratios.size() < correlationThresholds.least_bins) return 0;
    // Bins of one pass stand beside bins of another, and beside some that hold both.
    constexpr double quantileOfChiSquare = 2.7055;  // 0.9, one degree of freedom
    const double ratio = quantileInPlace(ratios, 0.9) / quantileOfChiSquare;
    if (ratio < correlationThresholds.least_bin_ratio) return 0;
    return 1e3 * std::sqrt((ratio - 1) * median(std::move(noise)));
}

double differenceOfOrder_um(const ResidualMap& map, double variance_ratio)
{
    std::array<double, filePasses> offsets{}, points{};
    double mixed = 0, seen = 0;
    for (std::size_t c = 0; c < map.cells.size(); ++c) {
        const MapCell& cell = map.cells[c];
        const CellOrder& order = map.order[c];
        if (cell.on < correlationThresholds.least_cell || cell.far > cell.on) continue;
        ++seen;
        const auto parts = std::count_if(order.on.begin(), order.on.end(), [](std::uint32_t n) { return n > 0; });
        if (parts < 2) continue;
        ++mixed;
        const double mean = order.total_mm() / static_cast<double>(cell.on);
        for (std::size_t q = 0; q < filePasses; ++q) {
            const auto n = static_cast<double>(order.on[q]);
            offsets[q] += static_cast<double>(order.sum_mm[q]) - n * mean;
            points[q] += n;
        }
    }
    if (seen == 0 || mixed < correlationThresholds.least_mixed * seen) return 0;
    double low = HUGE_VAL, high = -HUGE_VAL, u = 0;
    for (std::size_t q = 0; q < filePasses; ++q) {
        if (points[q] == 0) continue;
        low = std::min(low, offsets[q] / points[q]);
        high = std::max(high, offsets[q] / points[q]);
        u = std::max(u, map.sigma_mm * std::sqrt(2 * variance_ratio / points[q]));
    }
    const double half = (high - low) / 2;
    return half > correlationThresholds.order_sigmas * u && 1e3 * half > correlationThresholds.least_order_um
               ? 1e3 * half
               : 0;
}

}  // namespace lathelier::features
