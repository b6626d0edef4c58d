// Order of the operations of a clamping and its constraints.
//
// A step is all operations of one kind with one tool. Faces, centre holes, roughing, semi-finishing and finishing
// follow in this order; back turning and grooving may precede or follow finishing; threading follows all of these;
// parting off is last.
#pragma once

#include <optional>
#include <vector>

#include "engine/cam/setup_plan.h"
#include "engine/core/text.h"

namespace lathelier::cam {

/// Two steps in an impossible order.
struct OrderFault {
    OperationStep step;   ///< runs too early
    OperationStep needs;  ///< has to run before it
    Text reason;          ///< why, as a sentence without a full stop
};

/// Why `later` cannot run before `earlier`; none: their order is free.
std::optional<Text> reasonToFollow(OperationKind later, OperationKind earlier);

/// The first step that violates a constraint; none: the order is possible.
std::optional<OrderFault> faultOf(const std::vector<OperationStep>& order);

/// `usual` in the order of `wanted`: steps that `wanted` names are permuted among their positions, the others keep
/// theirs. Steps of `wanted` that `usual` lacks are ignored.
std::vector<OperationStep> inOrder(std::vector<OperationStep> usual, const std::vector<OperationStep>& wanted);

}  // namespace lathelier::cam
