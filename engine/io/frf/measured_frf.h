// A measured frequency response with its nodes, and conversions without a model.
#pragma once

#include "engine/core/frf.h"

namespace lathelier::io {

/// Response at one place per force at another. Directions: 1 x, 2 y, 3 z, 0 not stated; a minus sign of either in the
/// file is applied to the values.
struct MeasuredFrf {
    Frf frf;
    int response_node = 0;        ///< as the file numbers it; 0: not stated
    int response_direction = 0;   ///< 1 x, 2 y, 3 z; 0: not stated
    int reference_node = 0;       ///< node of the force
    int reference_direction = 0;  ///< 1 x, 2 y, 3 z; 0: not stated
};

/// The same response as displacement per force: mobility / (iω), accelerance / (-ω²). Lines at or below 0 Hz, where
/// these have no receptance, are removed with their coherence and noise; a receptance is returned as it is.
Frf toReceptance(const Frf& frf);

/// True when response and force share a stated node and direction.
bool isDrivingPoint(const MeasuredFrf& measured);

/// The share of lines, in percent, whose receptance has Im > 0, of those where it is not 0: for a passive structure
/// under e^(+iωt) it is 0 at driving points (Re of the mobility is the absorbed power). 0 without lines.
double activeLines_percent(const Frf& frf);

}  // namespace lathelier::io
