// Identification, triage, feed, map, sensitivities, band.
#include "engine/deflection/what_if.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "../core/code_of_error.h"
#include "case_a.h"
#include "engine/core/parallel.h"
#include "engine/deflection/deflection_codes.h"
#include "engine/deflection/feed_adjustment.h"
#include "engine/deflection/triage.h"

namespace lathelier::deflection {
namespace {

std::vector<MeasuredDiameter> measuredOn(const TurningSetup& truth, std::vector<double> places_mm)
{
    const PassResult pass = predictDeflection(caseAStock(), caseARuns(), truth).passes.front();
    std::vector<MeasuredDiameter> measured;
    for (const double z_mm : places_mm) measured.push_back({z_mm, 28 + errorAt(pass, z_mm) / 1000, 1});
    return measured;
}

TEST(Identification, FindsTheSpringsOfTheTruth)
{
    const TurningSetup truth = scaled(scaled(caseASetup(), Influence::Tailstock, 0.7), Influence::ChuckTilt, 1.4);
    const auto measured = measuredOn(truth, {5, 140, 270});
    const IdentificationResult found = identify(caseAStock(), caseARuns(), caseASetup(), measured);
    ASSERT_EQ(found.factors.size(), 2U);
    EXPECT_NEAR(found.factors[0].factor, 0.7, 1e-4);
    EXPECT_NEAR(found.factors[1].factor, 1.4, 1e-4);
    EXPECT_NEAR(found.setup.tailstock->radial_N_mm, 3850, 1);
    EXPECT_LT(found.rms_after_um, 1e-3);
    for (const ComparedDiameter& one : found.diameters) EXPECT_LT(one.E_n, 1e-2);
    EXPECT_GT(found.factors[0].uncertainty_percent, 0.5);
}

TEST(Identification, Refusals)
{
    const auto one = measuredOn(caseASetup(), {5});
    EXPECT_EQ(codeOfError([&] { identify(caseAStock(), caseARuns(), caseASetup(), one); }), errors::tooFewMeasured);
    const std::vector<MeasuredDiameter> outside{{5, 28, 1}, {285, 28, 1}};
    EXPECT_EQ(codeOfError([&] { identify(caseAStock(), caseARuns(), caseASetup(), outside); }),
              errors::measuredOutsideCut);
}

TEST(Triage, NamesTheCause)
{
    const auto bent = measuredOn(caseASetup(), {5, 50, 140, 270});
    EXPECT_EQ(triage(caseAStock(), caseARuns(), caseASetup(), bent).cause, ErrorCause::Deflection);
    std::vector<MeasuredDiameter> moved = bent, conical = bent;
    for (MeasuredDiameter& m : moved) m.diameter_mm = 28.03;
    for (MeasuredDiameter& m : conical) m.diameter_mm = 28 - 0.05 * (1 - m.z_mm / 287.5);
    EXPECT_EQ(triage(caseAStock(), caseARuns(), caseASetup(), moved).cause, ErrorCause::Program);
    const TriageResult aside = triage(caseAStock(), caseARuns(), caseASetup(), conical);
    EXPECT_EQ(aside.cause, ErrorCause::Alignment);
    EXPECT_NEAR(*aside.taper_um, -50, 1e-6);
}

TEST(Feed, HoldsTheTolerance)
{
    const TurningSetup setup = caseASetup();
    const WorkPlan plan = workPlan(caseAStock(), caseARuns(), setup);
    const FeedResult held = feedForTolerance(plan, setup, {45, 0.05, 0.4});
    EXPECT_LE(held.max_um, 45.5);
    EXPECT_LT(held.feed_mm_rev.front(), held.feed_mm_rev.back());
    EXPECT_TRUE(contains(feedForTolerance(plan, setup, {5, 0.05, 0.4}).notes, notes::feedCannotHold));
}

TEST(WhatIf, MapHoldsThePredictionAndIsTheSameOnOneCore)
{
    const TurningSetup setup = caseASetup();
    const WorkPlan plan = workPlan(caseAStock(), caseARuns(), setup);
    MapParameters asked;
    asked.least_depth_mm = 1;
    asked.largest_depth_mm = 3;
    asked.depths = 3;
    asked.least_feed_mm_rev = 0.1;
    asked.largest_feed_mm_rev = 0.3;
    asked.feeds = 3;
    asked.cutting_speed_m_min = 200;
    const DeflectionMap map = deflectionMap(plan, setup, asked);
    EXPECT_NEAR(map.at(1, 2), 61.304, 0.01);
    EXPECT_NEAR(map.at(1, 0), predictDeflection(rod(287.5, 30), caseARuns(), setup).summary.max_um,
                0.1);  // thicker beyond the cut
    EXPECT_NEAR(map.time_s[3], 280 * 3.14159265 * 28 / 0.2 / (200e3 / 60), 1e-3);
    const ThreadLimit one(1);
    EXPECT_EQ(deflectionMap(plan, setup, asked).max_um, map.max_um);
}

TEST(WhatIf, SensitivitiesAndBand)
{
    const TurningSetup setup = caseASetup();
    const WorkPlan plan = workPlan(caseAStock(), caseARuns(), setup);
    const std::vector<Sensitivity> found = sensitivities(plan, setup);
    ASSERT_GE(found.size(), 5U);
    EXPECT_GE(std::abs(found[0].swing_um()), std::abs(found[1].swing_um()));
    const ErrorBand band = errorBand(plan, setup);
    EXPECT_EQ(band.samples_used, 200);
    EXPECT_LT(band.low_um.front(), 61.3);
    EXPECT_GT(band.high_um.front(), 61.3);
    EXPECT_LT(band.max_high_um, 120);
    EXPECT_EQ(errorBand(plan, setup).high_um, band.high_um);
}

}  // namespace
}  // namespace lathelier::deflection
