// How much the noise of neighbouring points is correlated, and what the bins of the meridian scatter beyond it.
//
// The mean of a row errs by σ²/N only where the points err independently. Speckle along the line of a laser, waves of a
// photogrammetric surface and several passes do not. Means over patches larger than the correlation scatter as those of
// independent points would, times the ratio of the variances: batch means (Law and Kelton, "Simulation Modeling and
// Analysis"). Passes that differ do not show there, for every patch holds them all; neighbouring bins along z do.
#pragma once

#include "engine/features/outline/outline.h"
#include "engine/features/structure/residual_map.h"

namespace lathelier::features {

/// Thresholds of both.
struct CorrelationThresholds {
    double patch_mm = 8;             ///< side of a patch: beyond the waves of 5-9 mm of photogrammetry
    double least_points = 50;        ///< of a patch
    std::size_t least_ring = 3;      ///< patches around the axis
    std::size_t least_patches = 24;  ///< fewer give no variance
    double sure_sigmas = 4;          ///< by which the ratio exceeds 1 before it counts; white noise stays as it is
    double least_bin_ratio = 2;      ///< of the variance of neighbouring bins over that of noise, before passes differ
    double least_cell = 4;           ///< points of a cell whose parts of the file are compared
    double least_mixed = 0.3;   ///< share of the cells that hold points of several parts: passes cover all of the part
    double order_sigmas = 5;    ///< of the difference of parts of the file
    double least_order_um = 2;  ///< half of their difference
    std::size_t least_bins = 40;  ///< fewer give no variance
};
inline constexpr CorrelationThresholds correlationThresholds{};

/// Ratio of the variance of a row's mean to that of independent points; exactly 1 where no correlation is sure.
double varianceRatio(const ResidualMap& map, const SurfaceTable& surface, const Model& outside);

/// Standard deviation of the bins beyond the noise, from differences of neighbours, in µm on the radius; 0 where it is
/// not sure.
double differenceOfPasses_um(const Outline& outside);

/// Half of the largest difference between quarters of the file, in the order of its points, where the same places hold
/// points of several: passes one after the other. In µm on the radius; 0 where it is not sure.
double differenceOfOrder_um(const ResidualMap& map, double variance_ratio);

}  // namespace lathelier::features
