// Uncertainty of the limit from those of frequencies, compliance and coefficient, by 1000 Monte Carlo samples.
#pragma once

#include <functional>

#include "engine/stability/lobes.h"

namespace lathelier::stability {

/// True if an uncertainty that affects the limit is stated.
bool isUncertain(const LobeParameters& parameters);

/// The limit in mm over other speeds than those of a result.
using LimitOver = std::function<LobeLimit(const Interval& speed_rpm, int points)>;

/// The band at the speeds of `limit`. With process damping its coefficient is assumed proportional to K_r. Throws
/// Cancelled.
LobeBand bandOf(const LobeParameters& parameters, const LobeLimit& limit, const LimitOver& limitOver,
                const Progress& progress);

}  // namespace lathelier::stability
