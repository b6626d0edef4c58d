// Where material that stays is to be seen: in which clamping, at which block, and as an area of the meridian.
#pragma once

#include <cstdint>

#include "engine/cam/drawn/drawn_plan.h"
#include "engine/report/chart.h"

namespace lathelier::cam {

/// The block that comes nearest to a stretch of rest.
struct RestPlace {
    std::size_t clamping = 0;  ///< from 0
    std::int64_t line = 0;     ///< of the block; 0: no block comes near
};

/// Of the clamping that finishes this stretch; `rest`: index into TurningPlan::rest.
RestPlace placeOf(const TurningOutcome& outcome, std::size_t rest);

/// The area between the drawing and what is left of the stock at the end, in the stock of a clamping; without corners
/// where neither is known.
report::Region areaOf(const TurningOutcome& outcome, std::size_t rest, std::size_t clamping);

}  // namespace lathelier::cam
