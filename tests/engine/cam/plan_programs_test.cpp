// Programs in place of planned ones: checked again, read alone, corrected.
#include "engine/cam/plan_programs.h"

#include <gtest/gtest.h>

#include <regex>

#include "engine/cam/check/correction_file.h"
#include "tests/engine/cam/plan_data.h"

namespace lathelier::cam {
namespace {

TurningInputs linuxcnc()
{
    TurningInputs inputs;
    inputs.post = postNamed("linuxcnc");
    return inputs;
}

/// The text with the words of diameter 30 set to `now`: all of them, or the last one.
std::string changed(const std::string& text, const std::string& now, bool all)
{
    static const std::regex word(R"(X30\.0*(?![0-9]))");
    EXPECT_TRUE(std::regex_search(text, word)) << text;
    if (all) return std::regex_replace(text, word, now);
    std::smatch last;
    for (auto found = std::sregex_iterator(text.begin(), text.end(), word); found != std::sregex_iterator(); ++found)
        last = *found;
    return std::string(text.cbegin(), last[0].first) + now + std::string(last[0].second, text.cend());
}

TEST(PlanPrograms, TheSameTextGivesTheSameAnswer)
{
    const TurningPlan plan = planned(paperJob({roughC80(), finishC80()}), "linuxcnc", SetupChoice::Two);
    ASSERT_EQ(plan.setups.size(), 2U);
    const TurningPlan again =
        withPrograms(plan, {{0, plan.setups[0].text, {}, true}, {1, plan.setups[1].text, {}, true}}, linuxcnc());
    EXPECT_EQ(again.verdict, plan.verdict);
    ASSERT_EQ(again.rest.size(), plan.rest.size());
    for (std::size_t i = 0; i < plan.rest.size(); ++i) {
        EXPECT_NEAR(again.rest[i].left_mm, plan.rest[i].left_mm, 1e-9);
        EXPECT_NEAR(again.rest[i].z_start_mm, plan.rest[i].z_start_mm, 1e-9);
        EXPECT_EQ(again.rest[i].cause, plan.rest[i].cause);
    }
    for (std::size_t i = 0; i < plan.setups[0].operations.size(); ++i)
        EXPECT_EQ(again.setups[0].operations[i].first_line, plan.setups[0].operations[i].first_line);
}

TEST(PlanPrograms, AWordThatCutsDeeperIsFound)
{
    const TurningPlan plan = planned(paperJob({roughC80(), finishC80()}));
    ASSERT_FALSE(plan.is_refused);
    const std::string text = changed(plan.setups[0].text, "X29.6", false);
    const TurningPlan again = withPrograms(plan, {{0, text, {}, true}}, linuxcnc());
    EXPECT_TRUE(again.is_refused);
    EXPECT_EQ(again.verdict, Verdict::Fail);
    EXPECT_GT(again.setups[0].check.gouge_um, 50);
    EXPECT_EQ(again.setups[0].text, text);
}

TEST(PlanPrograms, WhatIsNotCheckedHasNoVerdict)
{
    const TurningPlan plan = planned(paperJob({roughC80(), finishC80()}), "linuxcnc", SetupChoice::Two);
    const std::string text = changed(plan.setups[0].text, "X29.6", false);
    const TurningPlan open = withPrograms(plan, {{0, text, {}, false}}, linuxcnc());
    EXPECT_FALSE(open.verdict);
    EXPECT_TRUE(open.rest.empty());
    for (const SetupPlan& setup : open.setups) {
        EXPECT_FALSE(setup.check.stock);
        EXPECT_TRUE(setup.check.findings.empty());
        EXPECT_FALSE(setup.check.path.moves.empty());
    }
}

TEST(PlanPrograms, AStatedCorrectionIsNoGouge)
{
    const TurningPlan plan = planned(paperJob({roughC80(), finishC80()}));
    const std::string text = changed(plan.setups[0].text, "X29.96", true);
    const StatedCorrection stated{{-5, 97, 97.9, 98.1}, {-0.02, -0.02, 0, 0}};
    EXPECT_GT(withPrograms(plan, {{0, text, {}, true}}, linuxcnc()).setups[0].check.gouge_um, 15);
    EXPECT_LT(withPrograms(plan, {{0, text, stated, true}}, linuxcnc()).setups[0].check.gouge_um,
              withPrograms(plan, {{0, text, {}, true}}, linuxcnc()).setups[0].check.gouge_um);
}

TEST(PlanPrograms, AProgramWithErrorsLeavesTheNextOneOpen)
{
    const TurningPlan plan = planned(paperJob({roughC80(), finishC80()}), "linuxcnc", SetupChoice::Two);
    const TurningPlan broken = withPrograms(plan, {{0, plan.setups[0].text + "G1 X[1/0]\n", {}, true}}, linuxcnc());
    EXPECT_FALSE(broken.verdict == Verdict::Pass);
}

TEST(CorrectionOf, RunsAreLaidOverEachOther)
{
    const std::vector<CorrectedCorner> corners{{0, 0.01}, {50, 0.03}, {100, 0.02}, {20, -0.01}, {60, -0.02}};
    const StatedCorrection all = correctionOf(corners);
    EXPECT_NEAR(all.at_mm(0), 0.01, 1e-12);
    EXPECT_NEAR(all.at_mm(20), -0.01, 1e-12);
    EXPECT_NEAR(all.at_mm(40), -0.015, 1e-12);
    EXPECT_NEAR(all.at_mm(60), -0.02, 1e-12);
    EXPECT_NEAR(all.at_mm(100), 0.02, 1e-12);
}

}  // namespace
}  // namespace lathelier::cam
