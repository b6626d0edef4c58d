// Plausibility of a measured response by physics, independent of its label.
//
// Below the first resonance a receptance is constant for a constrained structure and decreases as 1/f² for a free one;
// mobility and accelerance have additional factors f and f² (Ewins, "Modal Testing", 2nd ed., section 2.4). A response
// whose slope matches neither is mislabelled. At a driving point a passive structure absorbs power, so that Im of its
// receptance is not positive.
#pragma once

#include <optional>
#include <string>

#include "engine/core/error.h"
#include "engine/core/value.h"
#include "engine/io/frf/measured_frf.h"

namespace lathelier::receptance {

/// Power of the frequency with which the magnitude grows below the first resonance, by least squares over its
/// logarithms.
struct LowSlope {
    double power = 0;   ///< exponent of f: 0 constant, 2 as for the accelerance of a constrained structure
    Interval range_hz;  ///< frequency range of the lines used
};

/// None where the lines below the first resonance are too few, span less than an octave, or are too noisy to separate
/// neighbouring powers.
std::optional<LowSlope> lowSlope(const Frf& frf);

/// Notes frfSlopeContradictsLabel; frfPowerGivenAway for responses whose points the file does not state (the reader
/// checks stated driving points). The notes contain `path`.
Notes checkResponse(const io::MeasuredFrf& measured, const std::string& path);

}  // namespace lathelier::receptance
