// How well an identified spindle explains what was measured: the residual of each line and of each response, and what
// it predicts for the rods.
#pragma once

#include "engine/receptance/eirc/identify_spindle.h"

namespace lathelier::receptance {

/// A measured response beside the one that the spindle gives.
struct CheckedResponse {
    std::size_t rod = 0;      ///< index of the rod, from 0
    std::size_t point_a = 0;  ///< index of a point on it, from 0
    std::size_t point_b = 0;  ///< likewise
    bool used = true;         ///< false: of the rod that was held out
    Frf measured;             ///< receptance, on the lines of the identification
    Frf predicted;            ///< likewise
    double rms_percent = 0;   ///< 100·rms(|predicted - measured|/|measured|)
};

struct SpindleCheck {
    std::vector<double> residual_percent;    ///< of each line of the identification: rms over the responses used
    std::vector<CheckedResponse> responses;  ///< in the order of the measurements
};

/// Errors of identifySpindle(). Precondition: `found` was identified from these measurements. Throws Cancelled.
SpindleCheck checkSpindle(const SpindleMeasurements& measurements, const SpindleIdentification& found,
                          const Progress& progress = {});

}  // namespace lathelier::receptance
