// What the stated uncertainties of frequencies, compliance and coefficient make of the limit: 1000 drawn machines.
#pragma once

#include <functional>

#include "engine/stability/lobes.h"

namespace lathelier::stability {

/// Is any uncertainty stated that changes the limit?
bool isUncertain(const LobeParameters& parameters);

/// The limit in mm over other speeds than those of a result.
using LimitOver = std::function<LobeLimit(const Interval& speed_rpm, int points)>;

/// The band at the speeds of `limit`. With process damping its coefficient is taken to scale with K_r. Throws
/// Cancelled.
LobeBand bandOf(const LobeParameters& parameters, const LobeLimit& limit, const LimitOver& limitOver,
                const Progress& progress);

}  // namespace lathelier::stability
