// Modes of the point that is cut, as a simulation takes them: those stated; of a computed response its poles, starting
// at the natural frequencies of the shaft; of a measured one those of a fit with all that it found, residual terms and
// modes beyond the lines too.
#pragma once

#include <vector>

#include "engine/core/error.h"
#include "engine/stability/modes.h"
#include "engine/stability/task/point_response.h"
#include "engine/task/stores.h"

namespace lathelier::stability {

/// `stiffness_N_mm`: K_r a D of the strongest cut that is simulated (response_modes.h). Poles and fits are computed
/// once for each response. `found` receives the notes of the fit, and modesFitted or modesComputed. Error modesNeeded
/// where there is no mode; those of fitModes(). Throws Cancelled.
std::vector<Mode> modesOfPoint(const PointResponse& response, double stiffness_N_mm, Stores& stores, Notes& found,
                               const Progress& progress);

}  // namespace lathelier::stability
