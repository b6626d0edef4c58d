#include "engine/task/characteristic.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace lathelier::task {
namespace {

const Characteristic* find(const std::vector<Characteristic>& all, const std::string& key)
{
    for (const Characteristic& one : all)
        if (one.key == key) return &one;
    return nullptr;
}

const Json comparison = Json::parse(R"({
    "rmse_mm": 0.02, "verdict": "fail", "transform": [1, 2, 3],
    "worst": {"z_mm": 4.5, "deviation_mm": 0.06, "uncertainty_mm": 0.002},
    "zones": [{"name": "seat", "mean_mm": 0.011, "uncertainty_mm": 0.001, "lower_mm": -0.02, "upper_mm": 0.03,
               "verdict": "pass"}],
    "findings": [{"kind": "bump", "value_mm": 0.05, "uncertainty_mm": 0.01, "limit_mm": 0.04, "verdict": "fail"},
                 {"kind": "bump", "value_mm": 0.02, "uncertainty_mm": 0.01, "limit_mm": 0.04, "verdict": "pass"}],
    "map": {"z_step_mm": 2, "mean_mm": [0, 0, null, 0]},
    "harmonics": [{"upr": 1, "amplitude_um": 2}],
    "RONt_um": 3, "RONt_expanded_uncertainty_um": 0.2, "nothing_mm": null})");

TEST(Characteristic, values_have_their_uncertainty_limits_and_verdict)
{
    const auto all = characteristicsOf(comparison);
    const Characteristic* const seat = find(all, "zones.seat.mean_mm");
    ASSERT_TRUE(seat);
    EXPECT_EQ(*seat, (Characteristic{"zones.seat.mean_mm", "mm", 0.011, 0.001, -0.02, 0.03, Verdict::Pass}));
    const Characteristic* const form = find(all, "RONt_um");
    ASSERT_TRUE(form);
    EXPECT_EQ(*form, (Characteristic{"RONt_um", "µm", 3, 0.2, {}, {}, {}}));
    ASSERT_TRUE(find(all, "worst.deviation_mm"));
    EXPECT_EQ(find(all, "worst.deviation_mm")->expanded_uncertainty, 0.002);
}

TEST(Characteristic, what_belongs_to_a_value_and_curves_are_no_characteristics)
{
    const auto all = characteristicsOf(comparison);
    for (const char* key :
         {"zones.seat.uncertainty_mm", "zones.seat.lower_mm", "findings.bump.limit_mm", "RONt_expanded_uncertainty_um",
          "harmonics.1.amplitude_um", "nothing_mm", "transform", "map.z_step_mm", "findings.bump.value_mm"})
        EXPECT_FALSE(find(all, key)) << key;
    EXPECT_TRUE(find(all, "worst.z_mm"));
}

TEST(Characteristic, is_the_same_read_back)
{
    for (const Characteristic& one : characteristicsOf(comparison)) EXPECT_EQ(characteristicFrom(toJson(one)), one);
    EXPECT_FALSE(characteristicFrom(Json::parse("{\"key\": \"a\"}")));
    EXPECT_FALSE(characteristicFrom(Json::parse("[]")));
}

TEST(Characteristic, answer_comes_first_with_what_the_strip_shows)
{
    Outcome outcome;
    outcome.answer = [](const Language&) {
        report::Answer answer;
        answer.value = 12.5;
        answer.expanded_uncertainty = 0.5;
        answer.unit.english = "µm";
        answer.upper_limit = 12;
        answer.verdict = Verdict::Fail;
        return answer;
    };
    outcome.json = [] { return Json{{"speed_rpm", 1200}}; };
    const auto all = characteristicsOf(outcome);
    ASSERT_EQ(all.size(), 2U);
    EXPECT_EQ(all[0], (Characteristic{"answer", "µm", 12.5, 0.5, {}, 12, Verdict::Fail}));
    EXPECT_EQ(all[1].unit, "1/min");
}

}  // namespace
}  // namespace lathelier::task
