// The operations of one clamping: face, centre hole, rough, semi-finish, finish, what is left by other tools, part off.
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

/// An operation on a rest that was tried and refused.
struct RefusedOperation {
    int tool = 0;                         ///< number
    Unreached rest;                       ///< what it was for
    RestCause cause = RestCause::Holder;  ///< holder, chuck or tailstock
    Text reason;                          ///< in words
};

/// Operations that are left out: all of one kind with one tool in one clamping.
struct SkippedOperation {
    int setup = 1;                              ///< clamping, 1 or 2
    OperationKind kind = OperationKind::Rough;  ///< what for
    int tool = 0;                               ///< number
    friend bool operator==(const SkippedOperation&, const SkippedOperation&) = default;
};

/// The same as a place in the order of operations.
using OperationStep = SkippedOperation;

const std::vector<Field<SkippedOperation>>& fieldsOf(const SkippedOperation*);

struct SetupOperations {
    std::vector<Operation> operations;      ///< in order
    std::vector<double> removed_mm3;        ///< by each of them
    std::vector<double> depth_mm;           ///< largest depth of cut of each, for its power
    std::vector<Unreached> rest;            ///< predicted from the curves of the tools that are used
    std::vector<RefusedOperation> refused;  ///< tried
    WorkStock after;                        ///< the stock at the end
    Notes notes;
};

/// `stock`: before the first operation, in the z of this clamping; later operations meet what `skipped` ones leave.
/// `order`: as inOrder() takes it (operation_order.h); steps of the other clamping are passed over. Errors
/// noSetupPossible, orderImpossible. Throws Cancelled.
SetupOperations planSetup(const Clamping& clamping, WorkStock stock, const std::vector<SkippedOperation>& skipped = {},
                          const std::vector<OperationStep>& order = {}, const Progress& progress = {});

/// The stock of a clamping that begins with the bar.
WorkStock barOf(const Clamping& clamping);

/// Does the finishing tool alone leave anything but corners that are rounded by its nose?
bool leavesMoreThanCorners(const Clamping& clamping);

}  // namespace lathelier::cam
