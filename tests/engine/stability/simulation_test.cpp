// Simulated cuts against the exact boundary, the roots of the characteristic equation, and a plain integration.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

#include "engine/core/core_codes.h"
#include "engine/core/parallel.h"
#include "engine/core/random.h"
#include "engine/stability/lobes.h"
#include "engine/stability/simulation/characteristic_root.h"
#include "engine/stability/simulation/simulation.h"
#include "engine/stability/simulation/simulation_files.h"
#include "engine/stability/simulation/stability_raster.h"
#include "engine/stability/stability_codes.h"
#include "tests/engine/core/code_of_error.h"
#include "tests/engine/stability/machines.h"

namespace lathelier::stability {
namespace {

const std::vector<Mode> out_of_phase{{223, 0.03, 1e4}, {560, 0.03, -2e4}};  // of points moving in opposite directions
const std::vector<Mode> three{{223, 0.03, 1e4}, {410, 0.02, 3e4}, {905, 0.01, 5e4}};

SimulationParameters cutting(double speed_rpm, double depth_mm, int revolutions = 1)
{
    SimulationParameters p;
    p.speed_rpm = speed_rpm;
    p.depth_mm = depth_mm;
    p.cutting_coefficient_N_mm2 = coefficient_N_mm2;
    p.revolutions = revolutions;
    return p;
}

LobeParameters lobesAt(double speed_rpm, SpeedRelation relation = SpeedRelation::Exact)
{
    LobeParameters p;
    p.cutting_coefficient_N_mm2 = coefficient_N_mm2;
    p.relation = relation;
    p.speed_rpm = {{speed_rpm, speed_rpm + 1}};
    p.points = 2;
    return p;
}

double limitAt(const std::vector<Mode>& modes, double speed_rpm, SpeedRelation relation = SpeedRelation::Exact)
{
    return findLobes(frfOf(modes, 9000), lobesAt(speed_rpm, relation)).limit.depth_mm.front();
}

double drawnSpeed(std::uint64_t number, double from_rpm, double to_rpm)
{
    return from_rpm + (to_rpm - from_rpm) * randomUniform(7, 1, number);
}

TEST(Simulation, AgreesWithTheExactBoundary)
{
    for (const std::vector<Mode>& modes : {paperA, three, out_of_phase})
        for (std::uint64_t i = 0; i < 30; ++i) {
            const double speed = drawnSpeed(i, 1200, 6000), limit = limitAt(modes, speed);
            const double share = i % 2 == 0 ? 0.9 : 1.1;
            EXPECT_EQ(simulate(modes, cutting(speed, share * limit)).cut,
                      share < 1 ? CutVerdict::Stable : CutVerdict::Chatter)
                << speed << " " << limit;
        }
}

/// The papers' N = 60 f/k is wrong at most of 30 points; the exact relation at none.
TEST(Simulation, ThePublishedRelationAgreesAtFewPoints)
{
    int published = 0;
    for (std::uint64_t i = 0; i < 30; ++i) {
        const double speed = drawnSpeed(i, 1200, 6000), exact = limitAt(paperA, speed);
        const double published_depth = limitAt(paperA, speed, SpeedRelation::Published);
        const double depth = std::sqrt(exact * published_depth);  // between the two, unless they agree
        const bool chatters = simulate(paperA, cutting(speed, depth)).cut == CutVerdict::Chatter;
        EXPECT_EQ(chatters, depth > exact) << speed;
        published += chatters == (depth > published_depth);
    }
    EXPECT_EQ(published, 0);
    // At depths independent of both relations it is sometimes right.
    int right = 0;
    for (std::uint64_t i = 0; i < 30; ++i) {
        const double speed = drawnSpeed(i, 2500, 4500), depth = 0.31 + 0.5 * randomUniform(7, 2, i);
        const bool chatters = simulate(paperA, cutting(speed, depth)).cut == CutVerdict::Chatter;
        EXPECT_EQ(chatters, depth > limitAt(paperA, speed)) << speed << " " << depth;
        right += chatters == (depth > limitAt(paperA, speed, SpeedRelation::Published));
    }
    RecordProperty("published_relation_right_of_30", right);
    EXPECT_GE(right, 5);
    EXPECT_LE(right, 25);
}

TEST(Simulation, GrowthIsThatOfTheRightmostRoot)
{
    for (const std::vector<Mode>& modes : {paperA, three, out_of_phase})
        for (std::uint64_t i = 0; i < 20; ++i) {
            const double speed = drawnSpeed(i, 600, 6000), depth = 0.1 + randomUniform(7, 3, i);
            SimulationParameters p = cutting(speed, depth);
            CutForces cut{coefficient_N_mm2 * depth, 0, 1};
            if (i % 2 == 1) {
                p.process_damping_N_mm = 300;
                p.diameter_mm = 40;
                cut.damping_N_s_mm = dampingOfCut(300, depth, 40, speed);
            }
            const SimulationResult found = simulate(modes, p);
            const Growth root = growthOfRoots(modes, cut, 60 / speed);
            EXPECT_NEAR(found.growth_per_revolution, root.per_revolution, 1.5e-3 * root.per_revolution) << speed;
            EXPECT_NEAR(found.frequency_hz, root.frequency_hz, 0.5) << speed << " " << depth;
            EXPECT_LT(found.growth_step_difference, 1e-3);
        }
}

/// A root of the equation itself, not of its derivative or its denominators.
TEST(CharacteristicRoot, FulfilsTheEquationAtTheLimit)
{
    for (std::uint64_t i = 0; i < 20; ++i) {
        const double speed = drawnSpeed(i, 1200, 6000);
        const Growth root = growthOfRoots(three, {coefficient_N_mm2 * limitAt(three, speed), 0, 1}, 60 / speed);
        EXPECT_NEAR(root.per_revolution, 1, 5e-4) << speed;
    }
}

/// Half the time step changes the growth by a quarter as much.
TEST(Simulation, ErrorIsOfSecondOrder)
{
    const CutForces cut{coefficient_N_mm2 * 0.5, 0, 1};
    const double truth = growthOfRoots(paperA, cut, 60.0 / 2885).per_revolution;
    std::array<double, 3> error{};
    for (std::size_t i = 0; i < 3; ++i) {
        GrowthEffort effort;
        effort.steps = 100 << i;
        error[i] = growthsOf(paperA, {&cut, 1}, 60.0 / 2885, effort).front().per_revolution - truth;
    }
    EXPECT_NEAR(error[0] / error[1], 4, 0.2);
    EXPECT_NEAR(error[1] / error[2], 4, 0.2);
}

/// The same law, integrated by small steps without modes' exponentials or held forces.
double plainAmplitude(double speed_rpm, double depth_mm, double feed_mm, int revolutions, int steps)
{
    const double omega = 2 * std::numbers::pi * 223, zeta = 0.03, stiffness = 1e4;
    const double dt = 60 / speed_rpm / steps;
    std::vector<double> left(static_cast<std::size_t>(steps), 0.0);
    double x = 0, v = 0, least = HUGE_VAL, largest = -HUGE_VAL;
    for (int turn = 0; turn < revolutions; ++turn)
        for (double& wave : left) {
            const double chip = std::fmax(0, feed_mm + wave - x);
            const double force = coefficient_N_mm2 * depth_mm * chip;
            v += dt * (omega * omega * (force / stiffness - x) - 2 * zeta * omega * v);
            x += dt * v;  // semi-implicit
            wave = std::fmin(x, wave + feed_mm);
            if (turn < revolutions * 9 / 10) continue;
            least = std::fmin(least, x);
            largest = std::fmax(largest, x);
        }
    return (largest - least) / 2;
}

TEST(Simulation, LossOfContactKeepsTheAmplitudeFinite)
{
    const SimulationResult found = simulate(paperA, cutting(2885, 0.5, 200));
    EXPECT_EQ(found.cut, CutVerdict::Chatter);
    EXPECT_GT(found.lost_contact_percent, 10);
    EXPECT_LT(found.lost_contact_percent, 90);
    EXPECT_NEAR(found.amplitude_mm / plainAmplitude(2885, 0.5, 0.1, 200, 20000), 1, 0.01);
    // A cut with K_r a = 1000 N/mm and twice the feed vibrates twice as much: nothing else has a length.
    SimulationParameters p = cutting(2885, 0.5, 200);
    p.feed_mm_rev = 0.2;
    EXPECT_NEAR(simulate(paperA, p).amplitude_mm / found.amplitude_mm, 2, 1e-9);
}

TEST(Simulation, AStableCutSettlesAtItsStaticDeflection)
{
    const SimulationResult found = simulate(paperA, cutting(2885, 0.2, 200));
    EXPECT_EQ(found.cut, CutVerdict::Stable);
    EXPECT_NEAR(found.deflection_mm.back(), coefficient_N_mm2 * 0.2 * 0.1 / 1e4, 1e-8);
    EXPECT_NEAR(found.chip_mm.back(), 0.1, 1e-8);
    EXPECT_EQ(found.lost_contact_percent, 0);
    EXPECT_EQ(found.waves.inner_mm.size(), static_cast<std::size_t>(found.steps_per_revolution));
    EXPECT_EQ(found.waves.outer_mm.size(), found.waves.inner_mm.size());
}

TEST(Simulation, IncompleteQuestionsAreRefused)
{
    const auto code = [](const std::vector<Mode>& modes, const SimulationParameters& p) {
        return codeOfError([&] { simulate(modes, p); });
    };
    EXPECT_EQ(code({}, cutting(1000, 1)), errors::valueNotUnderstood);
    EXPECT_EQ(code(paperA, {}), errors::valueNotUnderstood);
    SimulationParameters damped = cutting(1000, 1);
    damped.process_damping_N_mm = 100;
    EXPECT_EQ(code(paperA, damped), errors::valueNotUnderstood);
    EXPECT_EQ(code(paperA, cutting(0.01, 1, 100000)), errors::simulationTooLong);
}

TEST(Simulation, SoundIsAWaveFileWithoutClicks)
{
    const SimulationResult found = simulate(paperA, cutting(2885, 0.5, 100));
    const Sound sound = soundOf(found);
    ASSERT_EQ(sound.bytes.substr(0, 4), "RIFF");
    ASSERT_EQ(sound.bytes.substr(8, 8), "WAVEfmt ");
    const auto sample = [&](std::size_t i) {
        const auto low = static_cast<unsigned char>(sound.bytes[44 + 2 * i]);
        return static_cast<int>(
            static_cast<std::int16_t>(low | static_cast<unsigned char>(sound.bytes[45 + 2 * i]) << 8));
    };
    const std::size_t count = (sound.bytes.size() - 44) / 2;
    EXPECT_NEAR(static_cast<double>(count), 44100 * found.seconds(), 1);
    EXPECT_EQ(sample(0), 0);
    EXPECT_EQ(sample(count - 1), 0);
    int largest = 0, jump = 0;
    for (std::size_t i = 1; i < count; ++i) {
        largest = std::max(largest, std::abs(sample(i)));
        jump = std::max(jump, std::abs(sample(i) - sample(i - 1)));
    }
    EXPECT_NEAR(largest, 0.9 * 32767, 40);
    EXPECT_LT(jump, 2 * std::numbers::pi * 400 / 44100 * 32767);
    EXPECT_NEAR(sound.full_scale_mm * 0.9, std::abs(sound.full_scale_mm) * largest / 32767, 1e-3);
}

TEST(StabilityRaster, IsTheSameForAnyNumberOfThreadsAndAgreesWithTheRoots)
{
    RasterParameters p;
    p.columns = 24;
    p.rows = 21;
    const RasterResult all = stabilityRaster(three, p);
    {
        const ThreadLimit limit(1);
        EXPECT_EQ(stabilityRaster(three, p).growth, all.growth);
    }
    for (std::size_t row = 0; row < 21; row += 4)
        for (std::size_t column = 0; column < 24; column += 3) {
            const Growth root = growthOfRoots(three, {2000 * all.depth_mm[row], 0, 1}, 60 / all.speed_rpm[column]);
            EXPECT_NEAR(all.at(row, column) / root.per_revolution, 1, 0.02) << row << " " << column;
        }
    EXPECT_EQ(rasterMap(all).values.size(), std::size_t{24 * 21});
    EXPECT_EQ(codeOfError([] { stabilityRaster({}, {}); }), errors::valueNotUnderstood);
    std::stop_source stop;
    stop.request_stop();
    EXPECT_THROW(stabilityRaster(paperA, p, Progress(stop.get_token(), {})), Cancelled);
}

LobeParameters damped(Interval speeds, int points)
{
    LobeParameters p;
    p.cutting_coefficient_N_mm2 = coefficient_N_mm2;
    p.speed_rpm = {speeds};
    p.points = points;
    p.process_damping_N_mm = 400;
    p.diameter_mm = 40;
    return p;
}

TEST(ProcessDamping, TheSimulationAgreesWithItsLobes)
{
    const LobeResult lobes = findLobes(frfOf(paperA, 9000), damped({300, 4300}, 4001));
    for (std::uint64_t i = 0; i < 10; ++i) {
        const double speed = std::round(drawnSpeed(i, 320, 4200));
        const double limit = pointStabilityAt(lobes, speed, 0).limit_mm;
        ASSERT_TRUE(std::isfinite(limit)) << speed;
        for (const double share : {0.95, 1.05}) {
            SimulationParameters p = cutting(speed, share * limit);
            p.process_damping_N_mm = 400;
            p.diameter_mm = 40;
            EXPECT_EQ(simulate(paperA, p).cut, share < 1 ? CutVerdict::Stable : CutVerdict::Chatter)
                << speed << " " << limit;
        }
    }
}

TEST(ProcessDamping, RaisesTheLimitMostAtLowSpeed)
{
    LobeParameters plain = damped({300, 4300}, 4001);
    plain.process_damping_N_mm.reset();
    const Frf frf = frfOf(paperA, 9000);
    const LobeLimit with = findLobes(frf, damped({300, 4300}, 4001)).limit, without = findLobes(frf, plain).limit;
    const auto least = [](const LobeLimit& limit, std::size_t from, std::size_t to) {
        double result = HUGE_VAL;
        for (std::size_t i = from; i < to; ++i) result = std::fmin(result, limit.depth_mm[i]);
        return result;
    };
    EXPECT_GT(least(with, 0, 100), 1.5 * least(without, 0, 100));
    EXPECT_LT(least(with, 3000, 4001), 1.1 * least(without, 3000, 4001));
    for (std::size_t i = 0; i < 4001; ++i) EXPECT_GE(with.depth_mm[i], 0.999 * without.depth_mm[i]) << i;
    // Without any it is the plain limit.
    LobeParameters none = damped({300, 4300}, 50);
    none.process_damping_N_mm = 1e-9;
    plain.points = 50;
    const LobeLimit a = findLobes(frf, none).limit, b = findLobes(frf, plain).limit;
    for (std::size_t i = 0; i < 50; ++i) EXPECT_NEAR(a.depth_mm[i], b.depth_mm[i], 1e-6);
}

TEST(ProcessDamping, NeedsCoefficientDiameterAndTheExactRelation)
{
    const Frf frf = frfOf(paperA, 5000);
    const auto code = [&](auto change) {
        LobeParameters p = damped({1000, 2000}, 5);
        change(p);
        return codeOfError([&] { findLobes(frf, p); });
    };
    EXPECT_EQ(code([](LobeParameters& p) { p.diameter_mm.reset(); }), errors::valueNotUnderstood);
    EXPECT_EQ(code([](LobeParameters& p) { p.cutting_coefficient_N_mm2.reset(); }), errors::valueNotUnderstood);
    EXPECT_EQ(code([](LobeParameters& p) { p.relation = SpeedRelation::Published; }), errors::valueNotUnderstood);
}

}  // namespace
}  // namespace lathelier::stability
