// In which order the operations of a clamping run, and which orders cannot be.
//
// A step is all operations of one kind with one tool. Faces, centre holes, roughing, semi-finishing and finishing build
// on each other; what the opposite hand and blades take off may come before or after the finish; threads come after
// all of these; the part is cut off last.
#pragma once

#include <optional>
#include <vector>

#include "engine/cam/setup_plan.h"
#include "engine/core/text.h"

namespace lathelier::cam {

/// Two steps the wrong way round.
struct OrderFault {
    OperationStep step;   ///< runs too early
    OperationStep needs;  ///< has to run before it
    Text reason;          ///< why, as a sentence without a full stop
};

/// Why `later` cannot run before `earlier`; none: their order is free.
std::optional<Text> reasonToFollow(OperationKind later, OperationKind earlier);

/// The first step that runs too early; none: the order can be.
std::optional<OrderFault> faultOf(const std::vector<OperationStep>& order);

/// `usual` in the order of `wanted`: steps that `wanted` names take each other's places, the others keep theirs. What
/// `wanted` names and `usual` has not is passed over.
std::vector<OperationStep> inOrder(std::vector<OperationStep> usual, const std::vector<OperationStep>& wanted);

}  // namespace lathelier::cam
