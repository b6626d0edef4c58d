// Predicted against measured errors of the diameter: E_n by hand.
#include "engine/chain/normalized_error.h"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

namespace lathelier::chain {
namespace {

/// A straight line of errors from 0 to 20 µm over 100 mm with a band of ± 3 µm.
PredictedErrors line()
{
    PredictedErrors predicted;
    for (int i = 0; i <= 100; ++i) {
        predicted.z_mm.push_back(i);
        predicted.error_um.push_back(0.2 * i);
        predicted.low_um.push_back(0.2 * i - 3);
        predicted.high_um.push_back(0.2 * i + 3);
    }
    return predicted;
}

TEST(NormalizedError, OfARowByHand)
{
    const std::vector<ComparedError> places = compareErrors(line(), {{2, 20, 60, 13, 4}});
    ASSERT_EQ(places.size(), 1u);
    EXPECT_NEAR(places[0].predicted_um, 8, 1e-12);
    EXPECT_NEAR(places[0].predicted_uncertainty_um, 3, 1e-12);
    EXPECT_NEAR(places[0].normalized_error, (13.0 - 8.0) / 5.0, 1e-12);
}

TEST(NormalizedError, EndsBetweenPlacesCountByTheirShare)
{
    const std::vector<ComparedError> places = compareErrors(line(), {{1, 10.25, 11.75, 0, 1}});
    ASSERT_EQ(places.size(), 1u);
    EXPECT_NEAR(places[0].predicted_um, 0.2 * 11, 1e-12);
}

TEST(NormalizedError, ARowThatIsPredictedOverLessThanHalfIsLeftOut)
{
    EXPECT_TRUE(compareErrors(line(), {{1, 90, 115, 0, 1}}).empty());
    EXPECT_EQ(compareErrors(line(), {{1, 90, 109, 0, 1}}).size(), 1u);
    EXPECT_TRUE(compareErrors({}, {{1, 0, 10, 0, 1}}).empty());
}

TEST(NormalizedError, AShoulderIsNoPlace)
{
    PredictedErrors step{{0, 10, 10, 20}, {1, 1, 5, 5}, {}, {}};
    const std::vector<ComparedError> places = compareErrors(step, {{1, 0, 20, 3, 2}});
    ASSERT_EQ(places.size(), 1u);
    EXPECT_NEAR(places[0].predicted_um, 3, 1e-12);
    EXPECT_EQ(places[0].predicted_uncertainty_um, 0);
    EXPECT_NEAR(places[0].normalized_error, 0, 1e-12);
}

TEST(NormalizedError, WithoutAnyUncertaintyThereIsNone)
{
    PredictedErrors bare = line();
    bare.low_um.clear();
    bare.high_um.clear();
    EXPECT_TRUE(compareErrors(bare, {{1, 0, 10, 1, 0}}).empty());
}

TEST(NormalizedError, TheLargestKeepsItsSign)
{
    const Json json = toJson(compareErrors(line(), {{1, 0, 10, 3, 4}, {2, 40, 60, -10, 4}}));
    EXPECT_EQ(json["places"].size(), 2u);
    EXPECT_NEAR(json["largest_normalized_error"].get<double>(), (-10.0 - 10.0) / 5.0, 1e-12);
    EXPECT_TRUE(toJson(std::vector<ComparedError>{})["largest_normalized_error"].is_null());
}

}  // namespace
}  // namespace lathelier::chain
