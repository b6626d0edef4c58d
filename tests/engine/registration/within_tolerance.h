// A comparison that is judged by a tolerance.
#pragma once

#include "engine/registration/compare.h"

namespace lathelier::registration {

inline CompareParameters withinTolerance(double tolerance_mm, DecisionRule decision = DecisionRule::GuardedRejection)
{
    CompareParameters parameters;
    parameters.tolerance_mm = tolerance_mm;
    parameters.decision = decision;
    return parameters;
}

}  // namespace lathelier::registration
