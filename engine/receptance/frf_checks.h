// Plausibility of a measured response by physics, independent of its label.
//
// Below the first resonance a receptance is constant for a constrained structure and decreases as 1/f² for a free one;
// mobility and accelerance have additional factors f and f² (Ewins, "Modal Testing", 2nd ed., section 2.4). A response
// whose slope matches neither is mislabelled. At a driving point a passive structure absorbs power, so that Im of its
// receptance is not positive; which way the circle of a resonance is run through tells a turned sign from the other
// sense of time (engine/io/frf/frf_sense.h).
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

/// Notes frfSlopeContradictsLabel; besides what the reader says of stated driving points: frfConjugated of any other
/// response, frfTurned and frfPowerGivenAway of those whose points the file does not state. The notes contain `path`.
Notes checkResponse(const io::MeasuredFrf& measured, const std::string& path);

}  // namespace lathelier::receptance
