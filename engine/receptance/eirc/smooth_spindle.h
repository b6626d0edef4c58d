// Smoothing of the identified spindle along frequency.
#pragma once

#include <span>
#include <vector>

#include "engine/core/progress.h"
#include "engine/receptance/eirc/spindle_line.h"

namespace lathelier::receptance {

/// At each line a quadratic in frequency through the lines beside it with tricube weights, each line weighted by its
/// information matrix, so that poorly determined components are taken from the neighbours. The number of neighbours (0
/// to 16 on either side) minimises the local leave-one-out prediction error: small beside a sharp mode of the machine,
/// large elsewhere. Source: W. S. Cleveland, J. Am. Stat. Assoc. 74 (1979) 829, local regression.
std::vector<ScaledSpindle> smoothed(std::span<const double> frequency_hz, std::span<const LineFit> fits,
                                    const Progress& progress = {});

}  // namespace lathelier::receptance
