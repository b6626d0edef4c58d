// The stated uncertainty of RONt against the truth, over kinds of noise that measurements have.
#include <gtest/gtest.h>

#include "tests/engine/form/noise_kinds.h"

namespace lathelier::form {
namespace {

class UncertaintyCoverage : public testing::TestWithParam<std::tuple<int, std::size_t>> {};

TEST_P(UncertaintyCoverage, HoldsTheTruth)
{
    const NoiseCase kind = noiseCases()[static_cast<std::size_t>(std::get<0>(GetParam()))];
    const Coverage found = coverageOf(kind, std::get<1>(GetParam()), 40);
    EXPECT_GE(found.covered, .85 * found.runs) << kind.name;  // of 40, for 95 of 100
    EXPECT_LT(found.uncertainty_um, 7 * found.error_um) << kind.name << ": covers by being large";
}

INSTANTIATE_TEST_SUITE_P(Kinds, UncertaintyCoverage,
                         testing::Combine(testing::Range(0, 7), testing::Values(48u, 200u, 720u)));

}  // namespace
}  // namespace lathelier::form
