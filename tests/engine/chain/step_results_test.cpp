// What later steps of a chain take from the results of earlier ones, and a step as the state of its panel.
#include "engine/chain/step_results.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "engine/chain/step_state.h"

namespace lathelier::chain {
namespace {

TEST(StepResults, SectionsWithAFixedSpeed)
{
    const Json result = {
        {"setups", {1, 2}},
        {"sections",
         {{{"z_start_mm", 0.0}, {"z_end_mm", 98.0}, {"diameter_mm", 30.0}, {"speed_rpm", 2154.0}},
          {{"z_start_mm", 98.0}, {"z_end_mm", 108.0}, {"diameter_mm", 37.0}, {"speed_rpm", nullptr}}}}};
    const PlannedProgram planned = plannedProgram(result);
    EXPECT_EQ(planned.clampings, 2u);
    ASSERT_EQ(planned.sections.size(), 1u);
    EXPECT_EQ(planned.sections[0].speed_rpm, 2154);
    EXPECT_EQ(plannedProgram(Json::object()).clampings, 0u);
    EXPECT_EQ(plannedProgram(Json()).sections.size(), 0u);
}

TEST(StepResults, FrequencyOfTheNearestSpeed)
{
    const Json result = {
        {"limit", {{"speed_rpm", {1000.0, 2000.0, 3000.0}}, {"frequency_hz", {300.0, nullptr, 320.0}}}}};
    EXPECT_EQ(chatterFrequencyAt(result, 1400), 300);
    EXPECT_FALSE(chatterFrequencyAt(result, 1600));
    EXPECT_EQ(chatterFrequencyAt(result, 2900), 320);
    EXPECT_FALSE(chatterFrequencyAt(result, 900));
    EXPECT_FALSE(chatterFrequencyAt(Json::object(), 900));
}

TEST(StepResults, MarksAndCorrection)
{
    EXPECT_TRUE(hasCorrection({{"residual_max_um", 0.4}}));
    EXPECT_FALSE(hasCorrection(Json::object()));
    const Json found = {
        {"images", {{{"chatter_marks", {{"frequency_hz", 310.0}, {"frequency_uncertainty_hz", 2.0}}}}}}};
    ASSERT_TRUE(chatterMarks(found));
    EXPECT_EQ(chatterMarks(found)->uncertainty_hz, 2);
    EXPECT_FALSE(chatterMarks({{"images", {{{"chatter_marks", nullptr}}}}}));
    EXPECT_FALSE(chatterMarks(Json::object()));
}

/// Files of the chain by their path, parameters as far as they are not the task's defaults.
TEST(StepState, IsThatOfThePanel)
{
    ChainStep step;
    step.id = "speeds";
    EXPECT_FALSE(stateOf(step, "/chain"));  // not run
    step.roles = {{"shaft", "held.json"}, {"spindle", "/shop/spindle.json"}};
    step.parameters = {{"shaft", std::string("held.json")},
                       {"speed_rpm", std::vector<Interval>{{1000, 3000}}},
                       {"points", std::int64_t{2000}},
                       {"unit", std::string("mm")}};
    const auto state = stateOf(step, "/chain");
    ASSERT_TRUE(state);
    EXPECT_EQ(state->inputs.at("shaft").path, "/chain/held.json");
    EXPECT_EQ(state->inputs.at("spindle").path, "/shop/spindle.json");
    EXPECT_TRUE(find(state->parameters, "speed_rpm"));
    EXPECT_FALSE(find(state->parameters, "points"));
    EXPECT_FALSE(find(state->parameters, "shaft"));
    EXPECT_TRUE(find(state->inputs.at("shaft").import, "unit"));
    step.id = "proof";
    EXPECT_FALSE(stateOf(step, "/chain"));
}

}  // namespace
}  // namespace lathelier::chain
