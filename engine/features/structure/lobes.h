// Departures of a row from the circle about the common axis: offset, ovality and lobes.
#pragma once

#include <optional>
#include <vector>

#include "engine/features/recognition.h"
#include "engine/features/structure/residual_map.h"

namespace lathelier::features {

/// Thresholds of the harmonics.
struct LobeThresholds {
    int most_lobes = 12;         ///< undulations per revolution; more have the size of the cells of one sector
    double sigmas = 5;           ///< standard uncertainties of an amplitude that is reported
    double least_um = 2;         ///< amplitude: below it a scanner's own errors are not excluded
    double least_cover = 0.8;    ///< of the circle: else harmonics are not independent
    double least_length_mm = 2;  ///< of a row: shorter ones hold too few cells
    double lobe_share = 0.4;     ///< of the variance of a profile: lobes of form have one order, waves of a scan many
};
inline constexpr LobeThresholds lobeThresholds{};

struct LobeFit {
    RowLobes lobes;                ///< those that are sure
    std::vector<double> curve_mm;  ///< sum of the sure harmonics by sector; empty: none is sure
};

/// The row of one element; nothing where it is too short or not seen around. `scale`: standard uncertainties over those
/// of white noise. `least_share`: of the variance of the profile, for a harmonic to count.
LobeFit lobesOf(const ResidualMap& map, const SurfaceTable& surface, const Run& run, std::size_t element, double scale,
                double least_share = 0);

/// Takes the curve of one row out of the residuals.
void removeLobes(ResidualMap& map, const SurfaceTable& surface, std::size_t run, std::size_t element,
                 const std::vector<double>& curve_mm);

}  // namespace lathelier::features
