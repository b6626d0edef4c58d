// Lines of a computed response that are dense where it curves.
#include "engine/receptance/refined_lines.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "engine/receptance/shaft/shaft_receptance.h"

namespace lathelier::receptance {
namespace {

Shaft bar(double length_mm, double diameter_mm)
{
    Shaft shaft;
    shaft.segments = {{length_mm, diameter_mm, diameter_mm, 0, {}, {}}};
    Material steel;
    steel.loss_factor = 0.002;
    shaft.material = steel;
    return shaft;
}

double leastRealPart(const Frf& frf)
{
    double least = 0;
    for (const auto& value : frf.value) least = std::min(least, value.real());
    return least;
}

/// The least real part on lines a hundred times finer about the natural frequencies is the reference.
TEST(RefinedLines, LeastRealPartOfSlenderBarsOnAStiffChuck)
{
    const SpindleReceptance chuck{SpindleSprings{2e5, 1e10, 0.002}};
    for (const auto& [length_mm, diameter_mm] :
         {std::pair{300.0, 20.0}, {200.0, 16.0}, {120.0, 12.0}, {250.0, 30.0}, {800.0, 40.0}}) {
        ReceptanceParameters lines;
        lines.from_hz = 20;
        lines.to_hz = 2000;
        const Shaft shaft = bar(length_mm, diameter_mm);
        const Frf refined = receptanceOf(shaft, *shaft.material, lines, {chuck, {}}, {}, LinesOf::Refined);
        lines.step_hz = 0.005;
        const double truth = leastRealPart(receptanceOf(shaft, *shaft.material, lines, {chuck, {}}));
        EXPECT_NEAR(leastRealPart(refined) / truth, 1, 0.005) << length_mm << " x " << diameter_mm;
        EXPECT_LT(refined.value.size(), 6000u);
        EXPECT_TRUE(std::is_sorted(refined.frequency_hz.begin(), refined.frequency_hz.end()));
    }
}

TEST(RefinedLines, NothingIsAddedWhereTheResponseIsStraight)
{
    Frf frf;
    for (double f = 0; f <= 10; ++f) {
        frf.frequency_hz.push_back(f);
        frf.value.emplace_back(f == 0 ? NAN : 1 + f, -f);
    }
    int calls = 0;
    refineLines(frf, [&](const std::vector<double>& more) {
        ++calls;
        return std::vector<std::complex<double>>(more.size());
    });
    EXPECT_EQ(calls, 0);
    EXPECT_EQ(frf.value.size(), 11u);
}

}  // namespace
}  // namespace lathelier::receptance
