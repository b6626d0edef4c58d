// Natural frequencies and mode shapes of an undamped shaft.
//
// The number of natural frequencies below ω is that of the negative eigenvalues of the dynamic stiffness at ω, when no
// piece by itself has one below ω (Wittrick and Williams 1971; see cutForCounting()), and for finite elements by
// Sturm's sequence. Bisection on this count finds all, including multiple ones.
#pragma once

#include <vector>

#include "engine/beam/beam_model.h"
#include "engine/core/progress.h"

namespace lathelier::beam {

/// Undamped (real moduli, real springs), ascending, up to `most_hz`, without rigid-body motions; a double frequency is
/// listed twice. Relative accuracy 1e-12 with respect to the model. Throws Cancelled.
std::vector<double> naturalFrequencies(const BeamModel& model, double most_hz, const Progress& progress = {});

/// Motion of a mode at the places of a model.
struct ModeShape {
    double frequency_hz = 0;
    std::vector<double> deflection;   ///< w at each place; the largest |w| along the shaft is 1, its sign +
    std::vector<double> rotation_mm;  ///< θ = dw/dx at each place, per mm; x from the chuck face to the free end
};

/// The shapes of the modes up to `most_hz`. Modes of one frequency are orthogonal by mass. Throws Cancelled.
std::vector<ModeShape> modeShapes(const BeamModel& model, double most_hz, const Progress& progress = {});

}  // namespace lathelier::beam
