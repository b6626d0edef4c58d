// Which way round a measured response is, by physics: its sign and its sense of time.
//
// With rising frequency the response of a passive structure under e^(+iωt) runs clockwise round the circle of each
// resonance; whatever its sign, as a factor of -1 only turns the circle (Ewins, "Modal Testing", 2nd ed.,
// section 2.4.2). A conjugated one runs the other way. At a driving point Im of the receptance is negative besides.
#pragma once

#include <optional>

#include "engine/core/frf.h"

namespace lathelier::io {

struct FrfSense {
    double frequency_hz = 0;            ///< of the strongest resonance
    std::optional<bool> is_conjugated;  ///< none: its lines do not form a circle
    std::optional<bool> is_turned;      ///< as a driving point, its sense of time put right; none: not decided
};

FrfSense senseOf(const Frf& frf);

}  // namespace lathelier::io
