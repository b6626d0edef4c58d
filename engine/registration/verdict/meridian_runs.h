// The smooth runs of a meridian, between shoulders, kinks and gaps.
#pragma once

#include <vector>

#include "engine/core/value.h"
#include "engine/registration/revolution/meridian_line.h"

namespace lathelier::registration {

/// A run of the profile's bins without shoulder, kink or gap: from `first` to `last` - 1. Its limits are where the
/// edges are, as far as that is known; the profile's z.
struct SmoothRun {
    std::size_t first = 0;  ///< bin
    std::size_t last = 0;   ///< bin behind it
    double start_mm = 0;    ///< z of the profile
    double end_mm = 0;      ///< z of the profile
};

/// The outside's runs in order of z; runs of less than 3 bins are left out.
std::vector<SmoothRun> smoothRuns(const TurnedPart& part);

/// Zones where none are given, along the axis from the line's first point: between shoulders and kinks, a little away
/// from them, and no longer than an eighth of the part.
std::vector<Interval> automaticZones(const TurnedPart& part, const MeridianLine& line);

}  // namespace lathelier::registration
