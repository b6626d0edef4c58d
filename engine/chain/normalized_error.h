// Predicted and measured diameter errors of the copy: normalized error of ISO 13528,
//   E_n = (measured - predicted) / √(U_measured² + U_predicted²),
// with expanded uncertainties (k = 2). |E_n| ≤ 1: agreement within the stated uncertainties.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/core/json.h"
#include "engine/report/chart.h"

namespace lathelier::chain {

/// The predicted error of the diameter along z, ascending, from engine/deflection.
struct PredictedErrors {
    std::vector<double> z_mm;      ///< from the free end
    std::vector<double> error_um;  ///< of the diameter left against the programmed one
    std::vector<double> low_um;    ///< lower limit of the 95 % band; empty: no band
    std::vector<double> high_um;   ///< upper limit of the 95 % band
};

/// Measured error of a row of the drawing.
struct MeasuredError {
    std::int64_t row = 0;       ///< number from 1
    double z_start_mm = 0;      ///< from the free end
    double z_end_mm = 0;        ///< toward the chuck
    double error_um = 0;        ///< measured less nominal diameter
    double uncertainty_um = 0;  ///< U
};

struct ComparedError {
    std::int64_t row = 0;                 ///< number from 1
    double z_start_mm = 0, z_end_mm = 0;  ///< from the free end
    double predicted_um = 0;              ///< mean along the inner 80 % of the row
    double predicted_uncertainty_um = 0;  ///< half the band, mean along the row; 0: no band
    double measured_um = 0;               ///< of the diameter
    double measured_uncertainty_um = 0;   ///< U
    double normalized_error = 0;          ///< E_n
};

/// Rows without prediction or with both uncertainties zero are omitted.
std::vector<ComparedError> compareErrors(const PredictedErrors& predicted, const std::vector<MeasuredError>& measured);

/// `places`, `largest_normalized_error` (of the largest magnitude; null without a place).
Json toJson(const std::vector<ComparedError>& places);

/// The prediction with its band, the measured rows with U over it.
report::Plot errorsPlot(const PredictedErrors& predicted, const std::vector<ComparedError>& places);

}  // namespace lathelier::chain
