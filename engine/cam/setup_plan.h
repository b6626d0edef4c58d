// The operations of one clamping: face, centre hole, rough, semi-finish, finish, rest operations, parting off.
#pragma once

#include <vector>

#include "engine/cam/clampings.h"
#include "engine/cam/operation.h"
#include "engine/cam/reach.h"
#include "engine/cam/work_stock.h"
#include "engine/core/fields.h"
#include "engine/core/progress.h"

namespace lathelier::cam {

inline constexpr double assumedLimit_rpm = 3000;  ///< of the spindle, where the job states none

/// A rest operation that was refused because of a collision.
struct RefusedOperation {
    int tool = 0;
    Unreached rest;                       ///< residual material it should remove
    RestCause cause = RestCause::Holder;  ///< holder, chuck or tailstock
    Text reason;
};

/// A rest operation that the check of the written program found a fault in: it is refused as one that collides.
struct DroppedOperation {
    int setup = 1;  ///< clamping, 1 or 2
    int tool = 0;
    double z_start_mm = 0;  ///< Operation::rest_z_start_mm
    RestCause cause = RestCause::Holder;
    Text reason;
};

/// Operations that are left out: all of one kind with one tool in one clamping.
struct SkippedOperation {
    int setup = 1;  ///< clamping, 1 or 2
    OperationKind kind = OperationKind::Rough;
    int tool = 0;
    friend bool operator==(const SkippedOperation&, const SkippedOperation&) = default;
};

/// Identifies a step in the order of operations.
using OperationStep = SkippedOperation;

const std::vector<Field<SkippedOperation>>& fieldsOf(const SkippedOperation*);

struct SetupOperations {
    std::vector<Operation> operations;
    std::vector<double> removed_mm3;  ///< volume removed by each operation
    std::vector<double> depth_mm;     ///< largest depth of cut of each, for its power
    std::vector<Unreached> rest;      ///< predicted from the curves of the tools that are used
    std::vector<RefusedOperation> refused;
    std::vector<DrawnThread> threads_cut;  ///< z of this clamping
    WorkStock after;                       ///< the stock at the end
    Notes notes;
};

/// `stock`: before the first operation, in the z of this clamping; operations after `skipped` ones start from the stock
/// left by them. `order`: as inOrder() takes it (operation_order.h); steps of the other clamping are ignored, as
/// `dropped` ones are. Errors noSetupPossible, orderImpossible. Throws Cancelled.
SetupOperations planSetup(const Clamping& clamping, WorkStock stock, const std::vector<SkippedOperation>& skipped = {},
                          const std::vector<OperationStep>& order = {},
                          const std::vector<DroppedOperation>& dropped = {}, const Progress& progress = {});

/// The stock of a clamping that begins with the bar.
WorkStock barOf(const Clamping& clamping);

/// True if the finishing tool alone leaves more than corners rounded by its nose.
bool leavesMoreThanCorners(const Clamping& clamping);

}  // namespace lathelier::cam
