// The last pass of a plan and the workpiece before it.
#pragma once

#include "engine/deflection/turning_work.h"

namespace lathelier::deflection {

inline constexpr double largestFeedShare = 1.9;  ///< of the corner radius: larger feeds leave uncut rings

struct LastPass {
    std::size_t cut;   ///< index into WorkPlan::cuts
    TurningWork work;  ///< before that pass; reads plan and set-up
};

/// The last run toward the chuck that cuts stock. Error noCut.
LastPass lastPassOf(const WorkPlan& plan, const TurningSetup& setup);

}  // namespace lathelier::deflection
