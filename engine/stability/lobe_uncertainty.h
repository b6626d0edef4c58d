// Uncertainty of the limit by 1000 Monte Carlo machines.
//
// Of modes, stated or fitted, frequency, damping and stiffness of each err independently; of a response that is not
// known by its modes all frequencies err together, and its size; of a measured one the noise of the line that limits
// comes in addition. The cutting coefficient errs in any case.
#pragma once

#include <functional>

#include "engine/stability/lobes.h"

namespace lathelier::stability {

/// True if an uncertainty that affects the limit is stated or known of the response.
bool isUncertain(const LobeParameters& parameters, const receptance::UncertainModel& modes);

/// The limit in mm over other speeds than those of a result.
using LimitOver = std::function<LobeLimit(const Interval& speed_rpm, int points)>;

/// The band at the speeds of `limit`, where the response errs as a whole. `noise`: standard deviation of the depth as a
/// share of it, at each speed; empty: none. With process damping its coefficient is assumed proportional to K_r. Throws
/// Cancelled.
LobeBand bandOfWhole(const LobeParameters& parameters, const LobeLimit& limit, const std::vector<double>& noise,
                     const LimitOver& limitOver, const Progress& progress);

/// The band where its modes err. `per_N_mm`: the depth over N/mm. Without process damping. Throws Cancelled.
LobeBand bandOfModes(const LobeParameters& parameters, const LobeLimit& limit, const receptance::UncertainModel& modes,
                     double per_N_mm, const Progress& progress);

}  // namespace lathelier::stability
