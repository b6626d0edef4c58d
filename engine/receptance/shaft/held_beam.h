// A beam joined to a spindle at its chuck face.
#pragma once

#include <span>

#include "engine/beam/beam_receptance.h"

namespace lathelier::receptance {

/// BeamReceptance::at() of the shaft on a spindle of the receptance `spindle`, at the place `chuck` of its model.
/// `result` as there: response place by excitation place.
void receptancesOnSpindle(beam::BeamReceptance& shaft, const beam::ReceptanceMatrix& spindle, std::size_t chuck,
                          double frequency_hz, std::span<beam::ReceptanceMatrix> result);

}  // namespace lathelier::receptance
