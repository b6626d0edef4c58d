// Residuals of an identified spindle by line and by response, and the responses it predicts for the rods.
#pragma once

#include "engine/receptance/eirc/identify_spindle.h"

namespace lathelier::receptance {

/// A measured response with the one predicted by the spindle.
struct CheckedResponse {
    std::size_t rod = 0;                 ///< index of the rod, from 0
    std::int64_t respond = 0;            ///< node that responds
    std::int64_t excite = 0;             ///< node that is excited
    bool used = true;                    ///< false: belongs to the held-out rod
    Frf measured;                        ///< measured receptance, on the lines of the identification
    Frf predicted;                       ///< predicted receptance, on the same lines
    double rms_percent = 0;              ///< 100·rms(|predicted - measured|/|measured|)
    std::optional<double> chi2_per_dof;  ///< of the fit line by line; none: not used, or noise not known
};

struct SpindleCheck {
    std::vector<double> frequency_hz;        ///< of each line
    std::vector<double> residual_percent;    ///< by line: rms over the responses used
    std::vector<CheckedResponse> responses;  ///< in the order of the measurements
};

/// Errors of identifySpindle(). Precondition: `found` is the result for these measurements. Throws Cancelled.
SpindleCheck checkSpindle(const SpindleMeasurements& measurements, const SpindleIdentification& found,
                          const Progress& progress = {});

}  // namespace lathelier::receptance
