// What physics says of a measured response, whatever its file says.
//
// Below its first resonance a receptance is constant where the structure is held, and falls as 1/f² where it is free;
// mobility and accelerance rise faster by f and f² (Ewins, "Modal Testing", 2nd ed., section 2.4). A response whose
// slope there is none of the two that its label allows is something else than its label says. At a driving point a
// passive structure takes up power, so that Im of its receptance is not positive.
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
    double power = 0;   ///< 0 constant, 2 as an accelerance that is held
    Interval range_hz;  ///< of the lines it is taken from
};

/// Nothing where the lines below the first resonance are too few, span less than an octave, or are too noisy to tell
/// neighbouring powers apart.
std::optional<LowSlope> lowSlope(const Frf& frf);

/// Notes frfSlopeContradictsLabel; frfPowerGivenAway for responses whose places the file does not state (a reader
/// checks stated driving points itself). `path` is named in them.
Notes checkResponse(const io::MeasuredFrf& measured, const std::string& path);

}  // namespace lathelier::receptance
