// A measured frequency response with its places, and what can be done with it before any model.
#pragma once

#include "engine/core/frf.h"

namespace lathelier::io {

/// Response at one place per force at another. Directions: 1 x, 2 y, 3 z, 0 not stated; a minus sign of either in the
/// file has been applied to the values.
struct MeasuredFrf {
    Frf frf;                      ///< the response
    int response_node = 0;        ///< as the file numbers it; 0: not stated
    int response_direction = 0;   ///< without sign
    int reference_node = 0;       ///< where the force acts
    int reference_direction = 0;  ///< without sign
};

/// The same response as displacement per force: mobility / (iω), accelerance / (-ω²). These have no receptance at 0 Hz,
/// so that a line at or below 0 Hz is left out, with its coherence; a receptance is returned as it is.
Frf toReceptance(const Frf& frf);

/// True when response and force share a stated node and direction.
bool isDrivingPoint(const MeasuredFrf& measured);

/// The share of lines, in percent, whose receptance has Im > 0, of those where it is not 0: a passive structure under
/// e^(+iωt) has none at its driving points (its Re of mobility is the power it takes up). 0 without lines.
double activeLines_percent(const Frf& frf);

}  // namespace lathelier::io
