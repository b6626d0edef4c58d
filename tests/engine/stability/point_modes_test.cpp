// What is simulated of a response chatters where the lobes of that response do.
#include "engine/stability/task/point_modes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/core/random.h"
#include "engine/receptance/shaft/shaft_receptance.h"
#include "engine/stability/lobes.h"
#include "engine/stability/simulation/characteristic_root.h"
#include "engine/stability/simulation/response_modes.h"
#include "engine/stability/simulation/response_poles.h"
#include "engine/stability/simulation/simulation.h"
#include "engine/stability/stability_codes.h"
#include "tests/engine/stability/machines.h"

namespace lathelier::stability {
namespace {

double drawn(std::uint64_t machine, std::uint64_t number, double from, double to)
{
    return from + (to - from) * randomUniform(44, machine, number);
}

double drawnRatio(std::uint64_t machine, std::uint64_t number, double from, double to)
{
    return from * std::pow(to / from, randomUniform(44, machine, number));
}

/// A response as a file has it: even lines, no noise.
PointResponse measuredFrom(const std::vector<Mode>& machine, double from_hz, double to_hz, double step_hz)
{
    Frf frf;
    for (double f = from_hz; f <= to_hz; f += step_hz) {
        frf.frequency_hz.push_back(f);
        frf.value.push_back(receptanceOf(machine, f));
    }
    PointResponse response;
    response.frf = std::make_shared<const Frf>(std::move(frf));
    return response;
}

PointResponse shaftOn(double diameter_mm, double length_mm, double loss_factor,
                      const receptance::SpindleReceptance& spindle)
{
    PointResponse response;
    response.shaft.emplace();
    response.shaft->segments = {{length_mm, diameter_mm, diameter_mm, 0, {}, {}}};
    response.shaft->material.emplace();
    response.shaft->material->loss_factor = loss_factor;
    response.holding.spindle = spindle;
    const auto computed =
        shaftReceptance(*response.shaft, {}, response.holding.spindle, {}, receptance::LinesOf::Refined);
    response.frf = std::make_shared<const Frf>(computed.frf);
    response.natural_frequencies_hz = computed.natural_frequencies_hz.value_or(std::vector<double>());
    return response;
}

/// The springs as a table of lines, which knows no natural frequency.
receptance::SpindleReceptance tableOf(const receptance::SpindleSprings& springs)
{
    const receptance::SpindleReceptance exact{springs};
    receptance::SpindleTable table;
    for (double f = 50; f <= 5000; f += 10) {
        const receptance::ReceptanceMatrix matrix = exact.at(f);
        table.frequency_hz.push_back(f);
        table.H_mm_N.push_back(matrix(0, 0));
        table.L_mm_Nmm.push_back(matrix(0, 1));
        table.P_rad_Nmm.push_back(matrix(1, 1));
    }
    return {table};
}

/// The limit of the lobes at one speed; infinite: none.
double limitAt(const Frf& frf, double speed_rpm)
{
    LobeParameters p;
    p.cutting_coefficient_N_mm2 = coefficient_N_mm2;
    p.speed_rpm = {{speed_rpm, speed_rpm * (1 + 1e-9)}};
    p.points = 2;
    const double limit = limitOf(frf, p).depth_mm.front();
    return std::isnan(limit) ? HUGE_VAL : limit;
}

/// A speed with lobes, from well below the first pocket to above it.
double drawnSpeed(const Frf& frf, std::uint64_t machine)
{
    const double f = leastRealPart(frf).frequency_hz;
    for (std::uint64_t i = 0;; ++i) {
        const double speed = drawnRatio(machine, 100 + i, 60 * f / 6, 60 * f * 1.2);
        if (std::isfinite(limitAt(frf, speed))) return speed;
    }
}

double growthAt(const PointResponse& response, double speed_rpm, double depth_mm, Stores& stores)
{
    Notes found;
    const double stiffness = coefficient_N_mm2 * depth_mm;
    const std::vector<Mode> modes = modesOfPoint(response, stiffness, stores, found, {});
    return growthOfRoots(modes, {stiffness, 0, 1}, 60 / speed_rpm).per_revolution;
}

void expectTheLimitOfTheLobes(const PointResponse& response, std::uint64_t machine)
{
    const double speed = drawnSpeed(*response.frf, machine), limit = limitAt(*response.frf, speed);
    Stores stores;
    EXPECT_LT(growthAt(response, speed, 0.98 * limit, stores), 1)
        << "machine " << machine << ", " << speed << " " << limit;
    EXPECT_GT(growthAt(response, speed, 1.02 * limit, stores), 1)
        << "machine " << machine << ", " << speed << " " << limit;
}

/// Modes below and above the lines of the file, from far away to beside them.
TEST(PointModes, FilesWithModesOutsideTheirLinesChatterAtTheLobes)
{
    for (std::uint64_t machine = 0; machine < 20; ++machine) {
        std::vector<Mode> modes{
            {drawn(machine, 0, 180, 450), drawn(machine, 1, 0.02, 0.05), drawnRatio(machine, 2, 5e3, 3e4)}};
        if (machine % 2 == 0)
            modes.push_back(
                {drawn(machine, 3, 550, 850), drawn(machine, 4, 0.02, 0.05), drawnRatio(machine, 5, 1.5e4, 6e4)});
        modes.push_back(
            {drawnRatio(machine, 6, 1300, 6000), drawn(machine, 7, 0.02, 0.05), drawnRatio(machine, 8, 8e3, 8e4)});
        if (machine % 4 == 3) modes.push_back({20, 0.05, 2e5});
        expectTheLimitOfTheLobes(measuredFrom(modes, 60, 1000, 2), machine);
    }
}

TEST(PointModes, ShaftsSlenderAndStoutChatterAtTheLobes)
{
    for (std::uint64_t machine = 100; machine < 130; ++machine) {
        const double diameter = drawn(machine, 0, 12, 40), length = diameter * drawn(machine, 1, 4, 20);
        const receptance::SpindleSprings soft{drawnRatio(machine, 2, 1e4, 3e4), drawnRatio(machine, 3, 1e8, 3e8), 0.06};
        const receptance::SpindleSprings stiff{drawnRatio(machine, 2, 8e4, 3e5), drawnRatio(machine, 3, 2e9, 1e10),
                                               machine % 4 == 1 ? 0.002 : 0.03};
        expectTheLimitOfTheLobes(
            shaftOn(diameter, length, drawnRatio(machine, 4, 0.002, 0.01), {machine % 2 == 0 ? soft : stiff}), machine);
    }
}

TEST(PointModes, ShaftsOnATabulatedSpindleChatterAtTheLobes)
{
    for (std::uint64_t machine = 200; machine < 206; ++machine) {
        const double diameter = drawn(machine, 0, 12, 40), length = diameter * drawn(machine, 1, 4, 14);
        const receptance::SpindleSprings soft{15000, 197.4e6, 0.06}, stiff{1e5, 2e9, 0.06};
        expectTheLimitOfTheLobes(shaftOn(diameter, length, 0.004, tableOf(machine % 2 == 0 ? soft : stiff)), machine);
    }
}

/// A resonance of 2600 Hz, softer than that within the lines: only its compliance is seen there.
TEST(PointModes, AModeAboveTheLinesAddsItsComplianceAndNoChatter)
{
    const PointResponse response = measuredFrom({{300, 0.03, 1.2e4}, {2600, 0.03, 4e3}}, 50, 1000, 2);
    const double limit = limitAt(*response.frf, 2200);
    Stores stores;
    for (const double share : {0.7, 0.9, 1.1}) {
        Notes found;
        SimulationParameters cut;
        cut.speed_rpm = 2200;
        cut.depth_mm = share * limit;
        cut.cutting_coefficient_N_mm2 = coefficient_N_mm2;
        cut.revolutions = 10;
        const std::vector<Mode> modes = modesOfPoint(response, coefficient_N_mm2 * *cut.depth_mm, stores, found, {});
        SimulationResult result = simulate(modes, cut);
        judgeModel(result, modes, *response.frf);
        EXPECT_EQ(result.cut, share < 1 ? CutVerdict::Stable : CutVerdict::Chatter) << share;
        ASSERT_TRUE(result.model_error_percent) << share;
        EXPECT_LT(*result.model_error_percent, 2) << share;
    }
}

/// Slender on a stiff chuck, where a fit found nothing and called thirty times the limit stable.
TEST(PointModes, ASlenderBarOnAStiffChuckChattersBeyondItsLimitOnly)
{
    const PointResponse response = shaftOn(16, 200, 0.002, {receptance::SpindleSprings{1e5, 2e9, 0.06}});
    const double limit = limitAt(*response.frf, 3400);
    Stores stores;
    for (const double share : {0.5, 3.0, 30.0}) {
        Notes found;
        SimulationParameters cut;
        cut.speed_rpm = 3400;
        cut.depth_mm = share * limit;
        cut.cutting_coefficient_N_mm2 = coefficient_N_mm2;
        cut.revolutions = 20;
        const std::vector<Mode> modes = modesOfPoint(response, coefficient_N_mm2 * *cut.depth_mm, stores, found, {});
        SimulationResult result = simulate(modes, cut);
        judgeModel(result, modes, *response.frf);
        EXPECT_EQ(result.cut, share < 1 ? CutVerdict::Stable : CutVerdict::Chatter) << share << " of " << limit;
        EXPECT_LT(result.model_error_percent.value_or(100), 2) << share;
    }
}

/// The poles of a cantilever with one loss factor: ω² (1 + iη) of its natural frequencies.
TEST(ResponsePoles, AreThoseOfTheComplexStiffness)
{
    const double loss = 0.01;
    const PointResponse response = shaftOn(20, 200, loss, {receptance::SpindleSprings{1e5, 2e9, loss}});
    std::vector<Pole> start;
    for (const double f : response.natural_frequencies_hz) start.push_back({1.01 * f, 0.02});
    const std::vector<Pole> poles = polesOf(*response.frf, start);
    ASSERT_EQ(poles.size(), response.natural_frequencies_hz.size());
    for (std::size_t i = 0; i < poles.size(); ++i) {
        const std::complex<double> root = std::sqrt(std::complex<double>(1, loss));
        EXPECT_NEAR(poles[i].frequency_hz / (response.natural_frequencies_hz[i] * std::abs(root)), 1, 1e-4) << i;
        EXPECT_NEAR(poles[i].damping_ratio / (root.imag() / std::abs(root)), 1, 0.02) << i;
    }
}

/// Growth in time of complex modes and a compliance without mass, against the roots of the equation.
TEST(Simulation, ComplexModesAndMasslessComplianceGrowAsTheirRoots)
{
    const std::vector<Mode> modes{
        {223, 0.03, 1e4, 0.1}, {560, 0.02, -4e4, -0.2}, {300, 1, 5e5, 0.7}, complianceMode(1.0 / 3e4)};
    for (std::uint64_t i = 0; i < 12; ++i) {
        SimulationParameters cut;
        cut.speed_rpm = drawn(7, 2 * i, 900, 5000);
        cut.depth_mm = drawn(7, 2 * i + 1, 0.1, 0.8);
        cut.cutting_coefficient_N_mm2 = coefficient_N_mm2;
        cut.revolutions = 1;
        CutForces forces{coefficient_N_mm2 * *cut.depth_mm, 0, 1};
        if (i % 2 == 1) {
            cut.process_damping_N_mm = 300;
            cut.diameter_mm = 40;
            forces.damping_N_s_mm = dampingOfCut(300, *cut.depth_mm, 40, *cut.speed_rpm);
        }
        const SimulationResult found = simulate(modes, cut);
        const Growth root = growthOfRoots(modes, forces, 60 / *cut.speed_rpm);
        EXPECT_NEAR(found.growth_per_revolution / root.per_revolution, 1, 4e-3) << i;
        EXPECT_NEAR(found.frequency_hz, root.frequency_hz, 0.5) << i;
    }
}

/// Modes that are not those of the response, or a vibration where it has no lines, decide nothing.
TEST(JudgeModel, IsUndecidedWhereTheModelIsNotTheResponse)
{
    const PointResponse response = measuredFrom({{223, 0.03, 1e4}}, 50, 800, 1);
    const auto judged = [&](const std::vector<Mode>& modes) {
        SimulationParameters cut;
        cut.speed_rpm = 2885;
        cut.depth_mm = 0.6;
        cut.cutting_coefficient_N_mm2 = coefficient_N_mm2;
        cut.revolutions = 1;
        SimulationResult result = simulate(modes, cut);
        EXPECT_EQ(result.cut, CutVerdict::Chatter);
        judgeModel(result, modes, *response.frf);
        return result;
    };
    const SimulationResult same = judged({{223, 0.03, 1e4}});
    EXPECT_EQ(same.cut, CutVerdict::Chatter);
    EXPECT_LT(*same.model_error_percent, 1e-6);
    const SimulationResult stiffer = judged({{223, 0.03, 1.2e4}});  // 1 - 1/1.2 of the response is missing
    EXPECT_EQ(stiffer.cut, CutVerdict::Undecided);
    EXPECT_NEAR(*stiffer.model_error_percent, 100 * (1 - 1 / 1.2), 0.01);
    EXPECT_TRUE(contains(stiffer.notes, notes::modelLeavesMuch));
    const SimulationResult outside = judged({{1200, 0.01, 1e3}});
    EXPECT_EQ(outside.cut, CutVerdict::Undecided);
    EXPECT_FALSE(outside.model_error_percent);
    EXPECT_TRUE(contains(outside.notes, notes::vibrationOutsideLines));
}

}  // namespace
}  // namespace lathelier::stability
