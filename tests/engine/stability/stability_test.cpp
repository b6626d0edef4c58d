// Lobes and speeds against closed forms, the characteristic equation and the papers' worked examples.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "engine/core/core_codes.h"
#include "engine/stability/boundary.h"
#include "engine/stability/envelope.h"
#include "engine/stability/lobes.h"
#include "engine/stability/modes.h"
#include "engine/stability/speed_choice.h"
#include "engine/stability/stability_codes.h"
#include "tests/engine/core/code_of_error.h"
#include "tests/engine/stability/machines.h"

namespace lathelier::stability {
namespace {

LobeParameters asking(SpeedRelation relation, Interval speeds, int points = 2)
{
    LobeParameters p;
    p.cutting_coefficient_N_mm2 = coefficient_N_mm2;
    p.relation = relation;
    p.speed_rpm = {speeds};
    p.points = points;
    return p;
}

double paperLimitAt(SpeedRelation relation, double speed_rpm)
{
    return findLobes(frfOf(paperA, 6000), asking(relation, {speed_rpm, speed_rpm + 1})).limit.depth_mm.front();
}

TEST(Lobes, LimitsOfTheWorkedExample)
{
    const double speeds[] = {2600, 2800, 2885, 3250, 3444, 4200};
    const double exact[] = {.5249, .3789, .3098, .6487, .6035, .7003};
    const double published[] = {.9325, .3410, .4702, 1.2155, .3090, 1.4660};
    for (std::size_t i = 0; i < 6; ++i) {
        EXPECT_NEAR(paperLimitAt(SpeedRelation::Exact, speeds[i]), exact[i], 6e-5) << speeds[i];
        EXPECT_NEAR(paperLimitAt(SpeedRelation::Published, speeds[i]), published[i], 1.1e-4) << speeds[i];
    }
}

TEST(Lobes, LeastDepthIsThatOfTheClosedForm)
{
    const LobeResult result = findLobes(frfOf(paperA, 6000), asking(SpeedRelation::Exact, {2000, 6000}, 2000));
    const double zeta = 0.03, k = 1e4;
    EXPECT_NEAR(*result.minimum_depth_mm, 2 * k * zeta * (1 + zeta) / coefficient_N_mm2, 1e-7);  // between lines
    EXPECT_NEAR(*result.frequency_of_minimum_hz, 223 * std::sqrt(1 + 2 * zeta), 1e-3);
    double least = HUGE_VAL;
    for (const double depth : result.limit.depth_mm) {
        EXPECT_GE(depth, *result.minimum_depth_mm * (1 - 1e-9));
        least = std::fmin(least, depth);
    }
    EXPECT_NEAR(least, *result.minimum_depth_mm, 1e-4);
}

/// 1 + K_r a G (1 - e^{-iωT}) = 0 at every point of every lobe; with the published relation it is 1.
TEST(Lobes, FulfilTheCharacteristicEquation)
{
    const std::vector<Mode> modes{{223, 0.03, 1e4}, {410, 0.02, 3e4}, {905, 0.01, 5e4}};
    for (const auto relation : {SpeedRelation::Exact, SpeedRelation::Published}) {
        const LobeResult result = findLobes(frfOf(modes, 9000), asking(relation, {1500, 9000}));
        ASSERT_GT(result.lobes.size(), 5u);
        double worst = 0;
        for (const Lobe& lobe : result.lobes)
            for (std::size_t i = 0; i < lobe.speed_rpm.size(); ++i) {
                if (std::isnan(lobe.speed_rpm[i])) continue;
                const double f = lobe.frequency_hz[i];
                const double turn = 2 * std::numbers::pi * f * 60 / lobe.speed_rpm[i];
                const std::complex<double> wave = 1.0 - std::exp(std::complex<double>(0, -turn));
                const std::complex<double> g =
                    -1 / (2 * coefficient_N_mm2 * lobe.depth_mm[i]) +
                    std::complex<double>(0, receptanceOf(modes, f).imag());  // depth and G agree in the real part
                worst = std::fmax(worst, std::abs(1.0 + coefficient_N_mm2 * lobe.depth_mm[i] * g * wave));
            }
        if (relation == SpeedRelation::Exact)
            EXPECT_LT(worst, 1e-3);  // the cubic between lines
        else
            EXPECT_NEAR(worst, 1, 1e-9);
    }
    // On the lines themselves there is no interpolation error.
    const Frf frf = frfOf(modes, 9000);
    for (const auto& stretch : boundaryOf(frf, 1, 1))
        for (const BoundaryPoint& point : stretch) {
            const double turn = 2 * std::numbers::pi * point.phase_turns;
            const std::complex<double> wave = 1.0 - std::exp(std::complex<double>(0, -turn));
            const std::complex<double> g = receptanceOf(modes, point.frequency_hz);
            EXPECT_LT(std::abs(1.0 + g * wave / point.compliance_mm_N), 1e-10);
        }
}

TEST(Lobes, AReceptanceOfLinesGivesWhatItsModesGive)
{
    Frf lines;
    for (double f = 20; f <= 1200; f += 1) {
        lines.frequency_hz.push_back(f);
        lines.value.push_back(receptanceOf(paperA, f));
    }
    const LobeParameters asked = asking(SpeedRelation::Exact, {2500, 4500}, 200);
    const LobeResult a = findLobes(lines, asked), b = findLobes(frfOf(paperA, 6000), asked);
    EXPECT_NEAR(*a.frequency_of_minimum_hz, *b.frequency_of_minimum_hz, 0.01);
    for (std::size_t i = 0; i < a.limit.depth_mm.size(); ++i)
        EXPECT_NEAR(a.limit.depth_mm[i] / b.limit.depth_mm[i], 1, 2e-3) << a.limit.speed_rpm[i];
}

TEST(Lobes, PointsThatSayNothingAreLeftOut)
{
    const std::vector<Mode> modes{{223, 0.03, 1e4}, {410, 0.02, 3e4}, {905, 0.01, 5e4}};
    const auto lines = [&](int per_hz) {
        Frf frf;
        for (int i = 20 * per_hz; i <= 3000 * per_hz; ++i) {
            frf.frequency_hz.push_back(static_cast<double>(i) / per_hz);
            frf.value.push_back(receptanceOf(modes, frf.frequency_hz.back()));
        }
        return frf;
    };
    const Boundary all = boundaryOf(lines(8), 1, 1);
    const Boundary dense = boundaryOf(lines(1), 1, 8);
    Boundary few = dense;
    for (auto& stretch : few) stretch = thinned(stretch);
    const auto countOf = [](const Boundary& boundary) {
        std::size_t count = 0;
        for (const auto& stretch : boundary) count += stretch.size();
        return count;
    };
    EXPECT_LT(5 * countOf(few), countOf(all));
    for (const SpeedRelation relation : {SpeedRelation::Exact, SpeedRelation::Published}) {
        const LobeLimit one = envelope(all, relation, {800, 6000}, 500);
        const LobeLimit whole = envelope(dense, relation, {800, 6000}, 500);
        const LobeLimit other = envelope(few, relation, {800, 6000}, 500);
        LowerEnvelope curves({800, 6000}, 500);
        for (int k = 0; k < 300; ++k)
            if (relation == SpeedRelation::Exact || k > 0) curves.add(lobeCurve(few, k, relation));
        const LobeLimit of_curves = curves.take();
        for (std::size_t i = 0; i < 500; ++i) {
            ASSERT_EQ(one.k[i] < 0, other.k[i] < 0) << one.speed_rpm[i];
            if (one.k[i] < 0) continue;
            EXPECT_NEAR(other.depth_mm[i] / whole.depth_mm[i], 1, 2e-4) << one.speed_rpm[i];
            EXPECT_NEAR(other.depth_mm[i] / one.depth_mm[i], 1, 2e-3) << one.speed_rpm[i];  // steep flanks
            EXPECT_EQ(of_curves.depth_mm[i], other.depth_mm[i]) << one.speed_rpm[i];
        }
    }
}

/// At slow speeds there are thousands: the limit is that of all, the list ends with the strongest.
TEST(Lobes, OfSlowSpeedsAreListedInPart)
{
    const Frf frf = frfOf(paperA, 2000);
    const LobeResult slow = findLobes(frf, asking(SpeedRelation::Exact, {20, 60}, 40));
    EXPECT_EQ(slow.lobes.size(), 200U);
    EXPECT_TRUE(contains(slow.notes, notes::lobesLeftOut));
    double strongest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < slow.lobes.size(); ++i) {
        if (i > 0) {
            EXPECT_GT(slow.lobes[i].k, slow.lobes[i - 1].k);
        }
        for (const double depth : slow.lobes[i].depth_mm)
            if (!std::isnan(depth)) strongest = std::min(strongest, depth);
    }
    EXPECT_NEAR(strongest, *slow.minimum_depth_mm, 1e-3 * strongest);
    const LobeResult usual = findLobes(frf, asking(SpeedRelation::Exact, {2500, 4500}, 50));
    EXPECT_FALSE(contains(usual.notes, notes::lobesLeftOut));
}

/// The limit of slow speeds is found by speeds, that of few lobes by lobes: both are one.
TEST(Lobes, OfSlowSpeedsLimitAsAllLobesDo)
{
    const Frf frf = frfOf({{223, 0.03, 1e4}, {410, 0.02, 3e4}}, 2000);
    for (const SpeedRelation relation : {SpeedRelation::Exact, SpeedRelation::Published}) {
        const Interval speeds{60, 110};
        const LobeLimit fast = limitOf(frf, asking(relation, speeds, 201));
        Boundary boundary = boundaryOf(frf, 1, 8);
        const LobeLimit all = envelope(boundary, relation, speeds, 201);
        for (std::size_t i = 0; i < 201; ++i)
            EXPECT_NEAR(fast.depth_mm[i] * coefficient_N_mm2 / all.depth_mm[i], 1, 1e-4) << fast.speed_rpm[i];
    }
}

TEST(Lobes, ScaleAsTheirDimensionsSay)
{
    const LobeResult base = findLobes(frfOf(paperA, 6000), asking(SpeedRelation::Exact, {2500, 4500}, 50));
    LobeParameters asked = asking(SpeedRelation::Exact, {5000, 9000}, 50);
    asked.cutting_coefficient_N_mm2 = 3 * coefficient_N_mm2;
    const LobeResult scaled = findLobes(frfOf({{446, 0.03, 5e4}}, 12000), asked);
    for (std::size_t i = 0; i < base.limit.depth_mm.size(); ++i)
        EXPECT_NEAR(scaled.limit.depth_mm[i], base.limit.depth_mm[i] * 5 / 3, 1e-4);
}

TEST(Lobes, WithoutACoefficientDepthsAreMultiplesOfTheLeast)
{
    LobeParameters asked = asking(SpeedRelation::Exact, {2500, 4500}, 50);
    const LobeResult known = findLobes(frfOf(paperA, 6000), asked);
    asked.cutting_coefficient_N_mm2.reset();
    const LobeResult relative = findLobes(frfOf(paperA, 6000), asked);
    EXPECT_TRUE(relative.isRelative());
    EXPECT_DOUBLE_EQ(*relative.minimum_depth_mm, 1);
    EXPECT_NEAR(relative.limit.depth_mm[7], known.limit.depth_mm[7] / *known.minimum_depth_mm, 1e-9);
    EXPECT_TRUE(contains(relative.notes, notes::coefficientUnknown));
}

TEST(Lobes, WhereNothingIsNegativeNothingChatters)
{
    Frf spring;
    for (double f = 10; f < 100; f += 1) {
        spring.frequency_hz.push_back(f);
        spring.value.emplace_back(1e-4, -1e-6);
    }
    const LobeResult result = findLobes(spring, asking(SpeedRelation::Exact, {1000, 2000}, 10));
    EXPECT_FALSE(result.minimum_depth_mm);
    EXPECT_TRUE(contains(result.notes, notes::noLimit));
    for (const double depth : result.limit.depth_mm) EXPECT_TRUE(std::isnan(depth));
    EXPECT_TRUE(result.lobes.empty());
}

TEST(Lobes, AnyReceptanceOfTheWrongKindIsRefused)
{
    Frf mobility = frfOf(paperA, 1000);
    mobility.quantity = FrfQuantity::Mobility;
    EXPECT_EQ(codeOfError([&] { findLobes(mobility); }), errors::notAReceptance);
    EXPECT_EQ(codeOfError([&] { findLobes(Frf{}); }), errors::tooFewLines);
}

TEST(Lobes, TheBandHoldsTheLimitAndGrowsWithTheUncertainty)
{
    LobeParameters asked = asking(SpeedRelation::Exact, {2500, 4500}, 100);
    asked.uncertainty_frequency_percent = 1;
    asked.uncertainty_coefficient_percent = 5;
    const LobeResult result = findLobes(frfOf(paperA, 6000), asked);
    ASSERT_TRUE(result.band);
    for (std::size_t i = 0; i < 100; ++i) {
        EXPECT_LE(result.band->low_mm[i], result.limit.depth_mm[i] * 1.0001);
        EXPECT_GE(result.band->high_mm[i], result.limit.depth_mm[i] * 0.9);
    }
    const PointStability below = pointStabilityAt(result, 3200, 0.1), above = pointStabilityAt(result, 3200, 5);
    EXPECT_TRUE(below.stable);
    EXPECT_EQ(below.probability_stable, 1);
    EXPECT_FALSE(above.stable);
    EXPECT_EQ(above.probability_stable, 0);
    const PointStability at = pointStabilityAt(result, 3200, below.limit_mm);
    EXPECT_GT(at.probability_stable, 0.2);
    EXPECT_LT(at.probability_stable, 0.8);
}

SpeedParameters selecting(double diameter_mm, double cutting_speed_m_min)
{
    SpeedParameters p;
    p.diameter_mm = diameter_mm;
    p.cutting_speed_m_min = cutting_speed_m_min;
    return p;
}

/// A mode whose least real part lies at `frequency_hz`.
Frf withLeastAt(double frequency_hz)
{
    return frfOf({{frequency_hz / std::sqrt(1.06), 0.03, 1e4}}, 6000);
}

/// With a negative direction factor the feet of the lobes lie at ε/2π of about 1/4: the recommended speed lies in the
/// pocket that is stated, whose ends are the deepest cuts into the limit.
TEST(Speed, OfANegativeDirectionFactorLiesInItsPocket)
{
    const Frf frf = frfOf({{300, 0.03, 1e4}}, 60000);
    for (const double selected_rpm : {3000.0, 4400.0, 6627.0, 9000.0}) {
        SpeedParameters asked;
        asked.speed_rpm = selected_rpm;
        asked.relation = SpeedRelation::Exact;
        asked.direction_factor = -1;
        const SpeedResult found = chooseSpeed(frf, asked);
        EXPECT_NEAR(found.lobe_rpm.from, 60 * found.frequency_hz / (found.k + 0.25), 1e-9);
        EXPECT_NEAR(found.lobe_rpm.to, 60 * found.frequency_hz / (found.k - 0.75), 1e-9);
        EXPECT_LE(found.lobe_rpm.from, selected_rpm);
        EXPECT_GE(found.lobe_rpm.to, selected_rpm);
        EXPECT_GT(found.recommended_rpm, found.lobe_rpm.from);
        EXPECT_LT(found.recommended_rpm, found.lobe_rpm.to);
        // At its ends the limit is near the least, between them no foot of another lobe lies lower.
        LobeParameters lobes = asking(SpeedRelation::Exact, found.lobe_rpm, 401);
        lobes.direction_factor = -1;
        const LobeLimit limit = limitOf(frf, lobes);
        const double least = *std::min_element(limit.depth_mm.begin(), limit.depth_mm.end());
        EXPECT_LT(limit.depth_mm.front(), 1.1 * least);
        EXPECT_LT(limit.depth_mm.back(), 1.1 * least);
        EXPECT_GT(limit.depth_mm[200], 1.2 * least);
    }
}

TEST(Speed, PaperA)
{
    SpeedParameters asked = selecting(32, 290);
    const SpeedResult result = chooseSpeed(frfOf(paperA, 6000), asked);
    EXPECT_NEAR(result.selected_rpm, 2884.7, 0.05);
    EXPECT_NEAR(result.frequency_hz, 229.6, 0.02);
    ASSERT_GE(result.candidates.size(), 5u);
    EXPECT_EQ(result.candidates[2].k, 4);
    EXPECT_NEAR(result.candidates[2].speed_rpm, 4247, 1);
    EXPECT_NEAR(result.candidates[3].speed_rpm, 3237, 1);
    EXPECT_NEAR(result.candidates[4].speed_rpm, 2617, 1);
    EXPECT_NEAR(result.recommended_rpm, 3237, 1);
    EXPECT_EQ(result.k, 5);
    // 350 m/min allow 3481 1/min: 4247 is listed, not recommended.
    asked.range_m_min = {{200, 350}};
    const SpeedResult limited = chooseSpeed(frfOf(paperA, 6000), asked);
    EXPECT_FALSE(limited.candidates[2].in_range);
    EXPECT_TRUE(limited.candidates[3].in_range);
}

TEST(Speed, PaperB)
{
    const SpeedResult result = chooseSpeed(withLeastAt(369.07), selecting(30, 190));
    EXPECT_NEAR(result.selected_rpm, 2016, 0.5);
    EXPECT_NEAR(result.recommended_rpm, 2154, 0.5);
    SpeedParameters asked = selecting(30, 190);
    asked.rule = SpeedRule::Nearest;
    EXPECT_NEAR(chooseSpeed(withLeastAt(369.07), asked).recommended_rpm, 1963, 0.5);
}

TEST(Speed, OutOfRangeIsTakenFromAnotherLobe)
{
    SpeedParameters asked;
    asked.speed_rpm = 2884.7;
    asked.diameter_mm = 32;
    asked.range_m_min = {{240, 300}};  // 2387 to 2984 1/min: 3237 is out, 2617 is in
    const SpeedResult result = chooseSpeed(frfOf(paperA, 6000), asked);
    EXPECT_NEAR(result.recommended_rpm, 2617, 1);
    EXPECT_TRUE(contains(result.notes, notes::fromAnotherLobe));
    asked.range_m_min = {{300, 310}};
    EXPECT_EQ(codeOfError([&] { chooseSpeed(frfOf(paperA, 6000), asked); }), errors::noStableSpeed);
}

TEST(Speed, AboveTheLastLobeNothingIsRecommended)
{
    SpeedParameters asked;
    asked.speed_rpm = 15000;
    try {
        chooseSpeed(frfOf(paperA, 20000), asked);
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), errors::noStableSpeed);
        EXPECT_TRUE(find(error.values(), "candidates"));
    }
}

TEST(Speed, TheExactOptimumIsBetterThanItsNeighbours)
{
    SpeedParameters asked;
    asked.speed_rpm = 2885;
    asked.relation = SpeedRelation::Exact;
    const SpeedResult result = chooseSpeed(frfOf(paperA, 6000), asked);
    const auto worst = [](double speed) {
        double least = HUGE_VAL;
        for (double share = 0.98; share <= 1.0201; share += 0.002)
            least = std::fmin(least, paperLimitAt(SpeedRelation::Exact, share * speed));
        return least;
    };
    EXPECT_GE(result.recommended_rpm, result.lobe_rpm.from);
    EXPECT_LE(result.recommended_rpm, result.lobe_rpm.to);
    for (const double share : {0.97, 0.985, 1.015, 1.03})
        EXPECT_GT(worst(result.recommended_rpm), worst(share * result.recommended_rpm)) << share;
}

TEST(Speed, WrongQuestionsAreRefused)
{
    const Frf frf = frfOf(paperA, 6000);
    const auto code = [&](const SpeedParameters& asked) { return codeOfError([&] { chooseSpeed(frf, asked); }); };
    EXPECT_EQ(code({}), errors::valueNotUnderstood);
    SpeedParameters asked = selecting(32, 290);
    asked.speed_rpm = 100;
    EXPECT_EQ(code(asked), errors::valueNotUnderstood);
    asked = selecting(32, 290);
    asked.range_m_min = {{350, 200}};
    EXPECT_EQ(code(asked), errors::valueNotUnderstood);
    asked = selecting(32, 290);
    asked.relation = SpeedRelation::Exact;
    asked.peak_shift = 0.5;
    EXPECT_EQ(code(asked), errors::valueNotUnderstood);
    asked = selecting(32, 290);
    asked.diameter_mm.reset();
    EXPECT_EQ(code(asked), errors::valueNotUnderstood);
}

}  // namespace
}  // namespace lathelier::stability
