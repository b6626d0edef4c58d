// Orders of operations: possible and impossible ones with reasons, and their effect on a plan.
#include "engine/cam/operation_order.h"

#include <gtest/gtest.h>

#include "engine/cam/plan_codes.h"
#include "tests/engine/cam/plan_data.h"

namespace lathelier::cam {
namespace {

using Kind = OperationKind;

std::vector<OperationStep> steps(std::initializer_list<std::pair<Kind, int>> all, int setup = 1)
{
    std::vector<OperationStep> result;
    for (const auto& [kind, tool] : all) result.push_back({setup, kind, tool});
    return result;
}

std::vector<OperationStep> ordered(const SetupPlan& setup)
{
    std::vector<OperationStep> result;
    for (const PlannedOperation& operation : setup.operations) {
        const OperationStep step{1, operation.kind, operation.tool};
        if (result.empty() || !(result.back() == step)) result.push_back(step);
    }
    return result;
}

Job grooveJob()
{
    return paperJob({roughC80(), finishC80(), backV35(), blade(8, ToolUse::Groove, 3, 0.2, 20)});
}

TurningPlan plannedIn(const std::vector<OperationStep>& order)
{
    const Job job = grooveJob();
    TurningInputs inputs;
    inputs.post = postNamed("linuxcnc");
    TurningParameters parameters;
    parameters.setups = SetupChoice::One;
    parameters.order = order;
    return planTurning(*job.shaft, job, inputs, parameters);
}

TEST(OperationOrder, WhatBuildsOnAnotherRunsAfterIt)
{
    EXPECT_FALSE(faultOf(steps({{Kind::Face, 1}, {Kind::Rough, 1}, {Kind::SemiFinish, 1}, {Kind::Finish, 2}})));
    const auto fault = faultOf(steps({{Kind::Face, 1}, {Kind::Finish, 2}, {Kind::Rough, 1}}));
    ASSERT_TRUE(fault);
    EXPECT_EQ(fault->step.kind, Kind::Finish);
    EXPECT_EQ(fault->needs.kind, Kind::Rough);
    EXPECT_FALSE(fault->reason.empty());
    EXPECT_TRUE(faultOf(steps({{Kind::PartOff, 8}, {Kind::Groove, 8}})));
    EXPECT_TRUE(faultOf(steps({{Kind::Rough, 1}, {Kind::Face, 1}})));
    EXPECT_TRUE(faultOf(steps({{Kind::CentreDrill, 9}, {Kind::Face, 1}})));
    EXPECT_TRUE(faultOf(steps({{Kind::Finish, 2}, {Kind::SemiFinish, 1}})));
    EXPECT_TRUE(faultOf(steps({{Kind::Groove, 8}, {Kind::Rough, 1}})));
    EXPECT_FALSE(faultOf(steps({{Kind::Groove, 8}, {Kind::FinishBack, 6}, {Kind::Finish, 2}})));
    // A thread runs out into its relief.
    EXPECT_TRUE(faultOf(steps({{Kind::Thread, 11}, {Kind::Groove, 8}})));
    EXPECT_TRUE(faultOf(steps({{Kind::Thread, 11}, {Kind::FinishBack, 6}})));
    EXPECT_FALSE(faultOf(steps({{Kind::Groove, 8}, {Kind::Thread, 11}})));
}

TEST(OperationOrder, StepsOfAnotherClampingAreApart)
{
    auto both = steps({{Kind::Finish, 2}}, 1);
    both.push_back({2, Kind::Rough, 1});
    EXPECT_FALSE(faultOf(both));
}

TEST(OperationOrder, NamedStepsTakeEachOthersPlaces)
{
    const auto usual =
        steps({{Kind::Face, 1}, {Kind::Rough, 1}, {Kind::Finish, 2}, {Kind::FinishBack, 6}, {Kind::Groove, 8}});
    const auto wanted = steps({{Kind::Groove, 8}, {Kind::Groove, 99}, {Kind::Finish, 2}});
    EXPECT_EQ(inOrder(usual, wanted),
              steps({{Kind::Face, 1}, {Kind::Rough, 1}, {Kind::Groove, 8}, {Kind::FinishBack, 6}, {Kind::Finish, 2}}));
    EXPECT_EQ(inOrder(usual, {}), usual);
}

TEST(OperationOrder, AGrooveMayComeBeforeTheFinish)
{
    const TurningPlan usual = plannedIn({});
    const auto before = ordered(usual.setups[0]);
    const OperationStep finish{1, Kind::Finish, 2}, groove{1, Kind::Groove, 8};
    const auto place = [](const std::vector<OperationStep>& all, const OperationStep& step) {
        return std::find(all.begin(), all.end(), step) - all.begin();
    };
    ASSERT_LT(place(before, finish), place(before, groove));
    ASSERT_LT(place(before, groove), static_cast<std::ptrdiff_t>(before.size()));
    const TurningPlan swapped = plannedIn({groove, finish});
    const auto after = ordered(swapped.setups[0]);
    EXPECT_LT(place(after, groove), place(after, finish));
    EXPECT_FALSE(swapped.is_refused);
    EXPECT_LE(swapped.setups[0].check.gouge_um, 1.5);
}

TEST(OperationOrder, AnOrderThatCannotBeIsRefused)
{
    try {
        plannedIn({{1, Kind::Finish, 2}, {1, Kind::Rough, 1}});
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), errors::orderImpossible);
    }
}

}  // namespace
}  // namespace lathelier::cam
