// Statistics of one characteristic of a series of parts in the order of time: control limits of single values, runs,
// drift and capability.
//
// Sources: ISO 7870-2 (Shewhart control charts; single values: limits at mean ± 2.66 mean moving range; tests: a value
// outside the limits, seven in succession on one side of the mean, seven in succession rising or falling),
// ISO 22514-2 (capability of a process that is normally distributed).
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "engine/archive/archive.h"
#include "engine/core/error.h"
#include "engine/core/quantities.h"

namespace lathelier::series {

/// All lengths in the unit of the characteristic.
struct ControlChart {
    std::int64_t count = 0;
    std::int64_t judged = 0;            ///< values that have a verdict
    std::int64_t out_of_tolerance = 0;  ///< of those
    std::int64_t undecided = 0;         ///< likewise
    double mean = 0;
    std::optional<double> standard_deviation;  ///< over n - 1; none for a single value
    double smallest = 0;
    double largest = 0;
    std::optional<double> lower_control_limit;  ///< none for fewer than 2 values
    std::optional<double> upper_control_limit;
    std::int64_t out_of_control = 0;  ///< values outside the control limits
    std::int64_t longest_run = 0;     ///< values in succession on one side of the mean
    std::int64_t longest_trend = 0;   ///< values in succession that rise, or that fall
    std::optional<double> drift_per_100_parts;
    std::optional<double> drift_expanded_uncertainty_per_100_parts;  ///< 95 %, of the scatter about the line
    std::optional<double> lower_limit;  ///< of all values alike; none: none, or they differ
    std::optional<double> upper_limit;
    std::optional<double> capability_pp;  ///< (upper - lower) / 6 s; with both limits
    std::optional<double>
        capability_ppk;  ///< the smaller of (upper - mean) / 3 s and (mean - lower) / 3 s; with one limit at least

    bool isInControl() const;
};

/// Notes: limitsDiffer, capabilityFewValues, capabilityOutOfControl. Precondition: at least one point.
ControlChart controlChart(const std::vector<archive::SeriesPoint>& points, Notes& notes);

const std::vector<QuantityOf<ControlChart>>& quantitiesOf(const ControlChart*);

}  // namespace lathelier::series
