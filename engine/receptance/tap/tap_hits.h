// Hits in the force of an impact test: where they are, how long a block may be, and which are sound.
#pragma once

#include <span>
#include <vector>

#include "engine/receptance/tap/tap.h"

namespace lathelier::receptance {

/// Level, noise and sign of the force of a record.
struct ForceFacts {
    double rest_N = 0;     ///< median: the offset of the amplifier
    double noise_N = 0;    ///< standard deviation at rest, by the median absolute deviation
    double largest_N = 0;  ///< largest magnitude above rest
    double level_N = 0;    ///< that triggers
};
ForceFacts factsOfForce(std::span<const double> force_N, double trigger_percent);

/// The block that the hits are cut into.
struct TapBlock {
    std::size_t samples = 0;  ///< length: even, without a prime factor above 5
    std::size_t before = 0;   ///< samples in front of the trigger
};

/// Hits with their blocks and faults; none used that has a fault, unless they are kept. A hit whose block runs beyond
/// its record is never used. Errors tapNoHit, tapBlockTooShort. Throws Cancelled.
struct FoundHits {
    std::vector<TapHit> hits;
    std::vector<ForceFacts> facts;  ///< by record
    TapBlock block;
};
FoundHits findHits(const std::vector<TapSignals>& records, const TapParameters& parameters, const Progress& progress);

/// True where the largest or smallest values of `values` stand level with steep flanks, as a converter or amplifier at
/// its limit makes them; the rounded top of a coarsely digitised pulse does not.
bool hasFlatTop(std::span<const double> values);

}  // namespace lathelier::receptance
