// Stability of an operating point, with its probability.
#pragma once

#include <optional>

#include "engine/core/fields.h"
#include "engine/core/json.h"
#include "engine/report/document.h"
#include "engine/stability/stability_plots.h"

namespace lathelier::stability {

struct PointParameters {
    std::optional<double> operating_speed_rpm;
    std::optional<double> operating_depth;  ///< mm; without K_r a multiple of the least limit
};

const std::vector<Field<PointParameters>>& fieldsOf(const PointParameters*);

/// None if neither is given. Error valueNotUnderstood for one without the other.
std::optional<OperatingPoint> operatingPointOf(const PointParameters& parameters);

/// {speed_rpm, depth_mm, limit_mm, frequency_hz, k, stable, probability_stable}: relative_depth and relative_limit
/// without K_r; null if no lobe limits, and for the probability if no uncertainties are given.
Json pointJson(const LobeResult& result, const OperatingPoint& point);

/// The same as a table.
report::QuantityTable pointTable(const LobeResult& result, const OperatingPoint& point);

}  // namespace lathelier::stability
