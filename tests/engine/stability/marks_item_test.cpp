// Chatter marks as an item, against a model.
#include "engine/stability/marks_item.h"

#include <gtest/gtest.h>

#include "engine/stability/modes.h"

namespace lathelier::stability {
namespace {

LobeResult model()
{
    LobeParameters parameters;
    parameters.speed_rpm = {{1500, 3000}};
    return findLobes(frfOf({{350, 0.03, 1e4}}, 3000), parameters);
}

TEST(MarksItem, ComesBackFromItsValues)
{
    const SurfaceMarks marks{"before.png", 2016, 361.02, 1.8, 33.6};
    const auto back = marksOf(toValues(marks));
    ASSERT_TRUE(back);
    EXPECT_EQ(back->picture, "before.png");
    EXPECT_EQ(back->speed_rpm, 2016);
    EXPECT_EQ(back->frequency_hz, 361.02);
    EXPECT_EQ(back->uncertainty_hz, 1.8);
    EXPECT_EQ(back->nearest_other_hz, 33.6);
    EXPECT_FALSE(marksOf({{"speed_rpm", 2016.0}}));
    EXPECT_FALSE(marksOf({{"speed_rpm", 2016.0}, {"frequency_hz", -1.0}}));
    EXPECT_FALSE(marksOf({{"speed_rpm", std::string("fast")}, {"frequency_hz", 361.0}}));
}

TEST(MarksItem, IsComparedWithTheModelAtItsSpeed)
{
    const LobeResult lobes = model();
    const double at_2016 = pointStabilityAt(lobes, 2016, 0).frequency_hz;
    const auto check = checkModel({"", 2016, 1.02 * at_2016, 1, {}}, lobes);
    ASSERT_TRUE(check);
    EXPECT_NEAR(check->model_hz, at_2016, 1e-9);
    EXPECT_NEAR(check->difference_percent, 2, 1e-6);
    EXPECT_TRUE(check->agrees);
    const auto far = checkModel({"", 2016, 1.08 * at_2016, 1, {}}, lobes);
    ASSERT_TRUE(far);
    EXPECT_FALSE(far->agrees);
    EXPECT_FALSE(checkModel({"", 5000, 400, 1, {}}, lobes));  // not in the chart
}

TEST(MarksItem, SaysWhatToDoubtBeyondFivePercent)
{
    const SurfaceMarks marks{"", 2800, 223, 1.1, 46.7};
    EXPECT_EQ(report::findingText(modelFinding(marks, {221, 0.9, true})),
              "Your marks say 223.0 ± 2.2 Hz, your model says 221.0 Hz; the nearest other reading is 46.7 Hz away.");
    EXPECT_NE(report::findingText(modelFinding(marks, {240, -7.1, false})).find("7.1\u00a0% apart"), std::string::npos);
}

TEST(MarksItem, IsDrawnAsLineAndDot)
{
    report::Plot lobes, frequencies;
    const SurfaceMarks marks{"", 2016, 361, 1.8, {}};
    drawMarks(lobes, marks);
    drawMarksFrequency(frequencies, marks);
    ASSERT_EQ(lobes.limits.size(), 1U);
    EXPECT_EQ(lobes.limits[0].place, 2016);
    EXPECT_EQ(lobes.limits[0].direction, report::Limit::Direction::Vertical);
    ASSERT_EQ(frequencies.marks.size(), 1U);
    EXPECT_EQ(frequencies.marks[0].x, 2016);
    EXPECT_EQ(frequencies.marks[0].y, 361);
}

}  // namespace
}  // namespace lathelier::stability
