// Lobes over a pass: the cut shaft, and the limit against single stations.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/beam/beam_codes.h"
#include "engine/core/core_codes.h"
#include "engine/stability/pass/cut_shaft.h"
#include "engine/stability/pass/lobes_over_pass.h"
#include "tests/engine/core/code_of_error.h"

namespace lathelier::stability {
namespace {

Shaft steps()
{
    Shaft shaft;
    for (const auto& [length, start, end] : {std::array{50.0, 30.0, 30.0}, {60.0, 40.0, 50.0}, {40.0, 60.0, 60.0}})
        shaft.segments.push_back({length, start, end, 0, {}, {}});
    shaft.material = Material{};
    return shaft;
}

TEST(CutShaft, IsThinnerBetweenTheEnds)
{
    const Shaft cut = cutShaft(steps(), 20, 80, 1.5);
    ASSERT_EQ(cut.segments.size(), 5u);
    EXPECT_NEAR(cut.length_mm(), 150, 1e-12);
    for (const double z : {1.0, 19.0, 81.0, 120.0}) EXPECT_NEAR(diameterAt_mm(cut, z), diameterAt_mm(steps(), z), 1e-9);
    for (const double z : {21.0, 49.0, 51.0, 79.0})
        EXPECT_NEAR(diameterAt_mm(cut, z), diameterAt_mm(steps(), z) - 3, 1e-9) << z;
    EXPECT_EQ(diameterAt_mm(cutShaft(steps(), 20, 20, 5), 20), 30);  // nothing is cut yet
    EXPECT_EQ(codeOfError([] { cutShaft(steps(), 20, 151, 1); }), errors::placeOutsideShaft);
    EXPECT_EQ(codeOfError([] { cutShaft(steps(), 20, 80, 15); }), errors::shaftSegmentUnusable);
}

TEST(LobesOverPass, IsTheLimitOfEachStation)
{
    const receptance::SpindleReceptance spindle{receptance::SpindleSprings{14850, 1.983e8, 0.06}};
    receptance::ReceptanceParameters lines;
    lines.to_hz = 1500;
    PassParameters pass;
    pass.pass_z_mm = {{0, 100}};
    pass.pass_depth_mm = 1;
    pass.pass_stations = 3;
    LobeParameters lobes;
    lobes.cutting_coefficient_N_mm2 = 2000;
    lobes.speed_rpm = {{1500, 4000}};
    lobes.points = 101;
    const PassResult result = lobesOverPass(steps(), pass, lines, {spindle, {}}, lobes);
    ASSERT_EQ(result.stations.size(), 3u);
    EXPECT_EQ(result.stations[1].z_mm, 50);
    EXPECT_NEAR(result.stations[0].diameter_mm, 28, 1e-9);
    for (std::size_t row = 0; row < 3; ++row) {
        const double z = result.stations[row].z_mm;
        receptance::ReceptanceParameters at = lines;
        at.respond_z_mm = at.excite_z_mm = z;
        const Frf frf = shaftReceptance(cutShaft(steps(), 0, z, 1), at, spindle, {}, receptance::LinesOf::Refined).frf;
        const LobeResult one = findLobes(frf, lobes);
        for (std::size_t i = 0; i < 101; ++i)
            EXPECT_NEAR(result.at(row, i), one.limit.depth_mm[i], 1e-12 * one.limit.depth_mm[i]) << z;
    }
    for (std::size_t i = 0; i < 101; ++i) {
        double least = HUGE_VAL;
        for (std::size_t row = 0; row < 3; ++row) least = std::fmin(least, result.at(row, i));
        EXPECT_EQ(result.worst.depth_mm[i], least);
    }
    const report::ColourMap map = passMap(result);
    ASSERT_EQ(map.values.size(), std::size_t{303});
    EXPECT_NEAR(static_cast<double>(map.values[150]), *result.parameters.pass_depth_mm - result.at(1, 49), 1e-6);
    const SafeSpeed safe = safeOverPass(result, {}, {result.speed_rpm.front(), result.speed_rpm.back()});
    EXPECT_EQ(safe.selected.speed_rpm, safe.best.speed_rpm);
    EXPECT_EQ(pointOfPass(result, safe.best.speed_rpm + 1e-6).speed_rpm, safe.best.speed_rpm);
    const double between = (result.speed_rpm[20] + result.speed_rpm[21]) / 2;
    EXPECT_NEAR(pointOfPass(result, between).limit_mm, (result.worst.depth_mm[20] + result.worst.depth_mm[21]) / 2,
                1e-12);
    // The answer is the depth that is stable; what was asked is its limit.
    const report::Answer told = passAnswer(result, safe);
    const PassPoint point = pointOfPass(result, safe.question.selected_rpm);
    ASSERT_TRUE(told.value);
    EXPECT_NEAR(*told.value, point.limit_mm, 2e-3 * point.limit_mm);
    EXPECT_EQ(told.lower_limit, 1);
    EXPECT_EQ(told.verdict, point.limit_mm > 1 ? Verdict::Pass : Verdict::Fail);
    lobes.cutting_coefficient_N_mm2.reset();
    EXPECT_EQ(codeOfError([&] {
                  lobesOverPass(steps(), pass, lines, {spindle, {}}, lobes);
              }),
              errors::valueNotUnderstood);
}

}  // namespace
}  // namespace lathelier::stability
