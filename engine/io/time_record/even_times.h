// Is a record evenly sampled? Spectra of uneven samples are wrong, and a gap shifts all that follows.
#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include "engine/core/progress.h"

namespace lathelier::io {

/// A sample whose distance from the one before is not the step.
struct UnevenStep {
    std::size_t sample = 0;  ///< index of the later one
    double found = 0;        ///< its step
    double expected = 0;     ///< median step
};

/// What the times of the samples say.
struct EvenTimes {
    double step = 0;                   ///< mean step; 0: fewer than two samples
    std::optional<UnevenStep> uneven;  ///< the first one; none: even
};

/// A step may differ from the median one by 1 % and what rounding explains: the decimals that the times are written in,
/// or single precision. Times written so coarsely that steps cannot be judged are even where each is the rounded time
/// of an even sample. Throws Cancelled.
EvenTimes judgeTimes(std::span<const double> times, const Progress& progress);

}  // namespace lathelier::io
