// Case A of the DRITTO paper at every printed position, and the results of typical implementation errors.
#include <gtest/gtest.h>

#include <cmath>
#include <utility>

#include "case_a.h"

namespace lathelier::deflection {
namespace {

TEST(CaseA, ErrorAtEveryPrintedPlace)
{
    TurningSetup setup = caseASetup();
    for (const double step_mm : {0.25, 0.5, 1.0}) {
        setup.step_mm = step_mm;
        const DeflectionResult result = predictDeflection(caseAStock(), caseARuns(), setup);
        ASSERT_EQ(result.passes.size(), 1U);
        for (const auto& [z, e] : {std::pair{0.0, 61.304},
                                   {25.0, 50.826},
                                   {50.0, 44.038},
                                   {100.0, 36.550},
                                   {143.75, 31.168},
                                   {200.0, 21.352},
                                   {250.0, 12.647},
                                   {280.0, 10.457}})
            EXPECT_NEAR(errorAt(result.passes.front(), z), e, 0.002) << z << ' ' << step_mm;
        EXPECT_NEAR(result.summary.mean_abs_um, 31.14, 0.01);
        EXPECT_NEAR(result.summary.range_um, 50.85, 0.005);
        EXPECT_NEAR(result.summary.max_um, 61.304, 0.002);
        EXPECT_NEAR(result.summary.wear_offset_um, -(61.304 + 10.457) / 2, 0.003);
    }
}

}  // namespace
}  // namespace lathelier::deflection
