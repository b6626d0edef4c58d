// The spindle found line by line, smoothed along frequency.
#pragma once

#include <span>
#include <vector>

#include "engine/core/progress.h"
#include "engine/receptance/eirc/spindle_line.h"

namespace lathelier::receptance {

/// At each line a quadratic in frequency through the lines beside it with tricube weights, each line weighted by its
/// information matrix, so that what one line does not know its neighbours tell. How many neighbours (0 to 16 to either
/// side) follows from how well they predict the lines hereabouts without these: few beside a sharp mode of the machine,
/// many where it is quiet. Source: W. S. Cleveland, J. Am. Stat. Assoc. 74 (1979) 829, local regression.
std::vector<ScaledSpindle> smoothed(std::span<const double> frequency_hz, std::span<const LineFit> fits,
                                    const Progress& progress = {});

}  // namespace lathelier::receptance
