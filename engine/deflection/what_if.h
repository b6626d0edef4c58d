// Variation of depth, feed and machine: error map over depth and feed, sensitivities, uncertainty band. All repeat the
// cutting on one plan (work_plan.h), on all cores, with the same bits for any number of them.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/core/fields.h"
#include "engine/core/progress.h"
#include "engine/deflection/deflection.h"
#include "engine/deflection/influences.h"

namespace lathelier::deflection {

struct MapParameters {
    double least_depth_mm = 0.1, largest_depth_mm = 4;  ///< of the last pass, radial
    double least_feed_mm_rev = 0.05, largest_feed_mm_rev = 0.4;
    int depths = 24, feeds = 16;                ///< grid, ends among them
    std::optional<double> tolerance_um;         ///< limit of |e|; draws its contour line
    std::optional<double> cutting_speed_m_min;  ///< for the cycle time
    friend bool operator==(const MapParameters&, const MapParameters&) = default;
};

const std::vector<Field<MapParameters>>& fieldsOf(const MapParameters*);

/// Row by row over the feeds; within a row over the depths.
struct DeflectionMap {
    MapParameters parameters;
    std::vector<double> depth_mm, feed_mm_rev;  ///< of columns and rows
    std::vector<double> max_um;                 ///< largest |e| that the last pass leaves; NaN: no equilibrium
    std::vector<double> time_s;                 ///< cutting time of the last pass; empty without a cutting speed

    double programmed_depth_mm = 0, programmed_feed_mm_rev = 0;  ///< of the last pass, mean depth where it cuts

    double at(std::size_t feed, std::size_t depth) const { return max_um[feed * depth_mm.size() + depth]; }
};

/// Only the last pass is simulated, on a workpiece thicker than its contour by the depth; elsewhere it is as left by
/// the previous passes. Errors noCut, those of predictDeflection(). Throws Cancelled.
DeflectionMap deflectionMap(const WorkPlan& plan, const TurningSetup& setup, const MapParameters& parameters = {},
                            const Progress& progress = {});

/// Effect of ±10 % of one influence.
struct Sensitivity {
    std::string key;  ///< "tailstock", "feed"
    Text name;
    double max_um_minus = 0, max_um_plus = 0;            ///< largest |e| at -10 %, +10 %
    double mean_abs_um_minus = 0, mean_abs_um_plus = 0;  ///< mean |e| at -10 %, +10 %
    double swing_um() const { return max_um_plus - max_um_minus; }
};

/// Sorted by the change of max |e|, largest first. Errors of predictDeflection().
std::vector<Sensitivity> sensitivities(const WorkPlan& plan, const TurningSetup& setup);

/// Relative standard uncertainties of the inputs.
struct BandParameters {
    double springs_percent = 10;  ///< each spring independently
    double forces_percent = 10;   ///< all coefficients, fully correlated
    double modulus_percent = 1;   ///< E
    int samples = 200;
    int seed = 1;
    friend bool operator==(const BandParameters&, const BandParameters&) = default;
};

const std::vector<Field<BandParameters>>& fieldsOf(const BandParameters*);

/// Pointwise 95 % interval of the samples.
struct ErrorBand {
    BandParameters parameters;
    std::vector<double> z_mm, low_um, high_um;
    double max_low_um = 0, max_high_um = 0;  ///< 95 % of max |e|
    int samples_used = 0;                    ///< samples with a result
};

/// Factors are log-normal. Errors of predictDeflection(). Throws Cancelled.
ErrorBand errorBand(const WorkPlan& plan, const TurningSetup& setup, const BandParameters& parameters = {},
                    const Progress& progress = {});

}  // namespace lathelier::deflection
