// The number of modes found in many random machines whose modes and noise are known.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/core/random.h"
#include "engine/receptance/modal/modal_codes.h"
#include "engine/receptance/modal/modal_fit.h"

namespace lathelier::receptance {
namespace {

using testing::SizeIs;

/// Random numbers of one machine.
struct Draw {
    std::uint64_t seed, next = 0;
    double uniform(double from, double to) { return from + (to - from) * randomUniform(seed, 7, next++); }
    double logarithmic(double from, double to) { return from * std::pow(to / from, randomUniform(seed, 7, next++)); }
};

struct MachineKind {
    bool rises = false;       ///< the accelerometer's noise rises towards low frequencies
    double stated_wrong = 1;  ///< the noise is stated wrong by up to this factor, from place to place
    bool is_cross = false;    ///< residues of either sign
};

struct Machine {
    ModalModel truth;
    Frf frf;
};

double circular(double frequency_hz)
{
    return 2 * std::numbers::pi * frequency_hz;
}

/// 1 to 4 modes, 40-2000 Hz.
ModalModel modelOf(Draw& draw, const MachineKind& kind)
{
    ModalModel model;
    const int count = 1 + static_cast<int>(draw.uniform(0, 4));
    for (int k = 0; k < count; ++k) {
        const double sign = draw.uniform(0, 1) < .4 && kind.is_cross ? -1 : 1;
        model.modes.push_back(
            {draw.logarithmic(60, 1800), draw.logarithmic(.005, .05), sign * draw.logarithmic(5e3, 1e5)});
    }
    std::sort(model.modes.begin(), model.modes.end(),
              [](const ModalMode& a, const ModalMode& b) { return a.frequency_hz < b.frequency_hz; });
    if (draw.uniform(0, 1) < .5) model.residuals.upper_mm_N = draw.logarithmic(1e-7, 1e-5);
    if (draw.uniform(0, 1) < .3)
        model.beyond.push_back({draw.logarithmic(2100, 4000), .02, draw.logarithmic(5e3, 1e5)});
    return model;
}

double bandOf(const ModalMode& mode)
{
    return 2 * mode.damping_ratio * mode.frequency_hz;
}

/// Modes two half-power widths apart, each with a band of at least 1.5 lines.
bool areTold(const ModalModel& model)
{
    for (std::size_t k = 0; k < model.modes.size(); ++k) {
        const ModalMode& mode = model.modes[k];
        if (bandOf(mode) < 1.5) return false;
        if (k > 0 && mode.frequency_hz - model.modes[k - 1].frequency_hz <
                         2 * std::max(bandOf(mode), bandOf(model.modes[k - 1])))
            return false;
    }
    return true;
}

/// The machine of a seed; none where its modes are too close, or do not stand five times out of the noise.
std::optional<Machine> machineOf(std::uint64_t seed, const MachineKind& kind)
{
    Draw draw{seed};
    Machine machine{modelOf(draw, kind), {}};
    if (!areTold(machine.truth)) return std::nullopt;
    std::vector<double> lines;
    for (int f = 40; f <= 2000; ++f) lines.push_back(f);
    machine.frf = synthesised(machine.truth, lines);
    double peak = 0;
    for (std::size_t i = 0; i < lines.size(); ++i)
        peak = std::max(peak, std::abs(machine.frf.value[i]) * std::pow(circular(lines[i]), 2));
    const double flat = peak / draw.logarithmic(100, 1000), turn = draw.uniform(0, 6);
    const auto noiseAt = [&](double f) { return kind.rises ? flat * (1 + 150 / f) : flat; };  // of the acceleration
    for (const ModalMode& mode : machine.truth.modes)
        if (std::pow(circular(mode.frequency_hz), 2) / (2 * mode.damping_ratio * std::abs(mode.stiffness_N_mm)) <
            5 * noiseAt(mode.frequency_hz))
            return std::nullopt;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const double sigma = noiseAt(lines[i]) / std::sqrt(2) / std::pow(circular(lines[i]), 2);
        machine.frf.value[i] += std::complex(sigma * randomNormal(seed, 0, i), sigma * randomNormal(seed, 1, i));
        machine.frf.noise.push_back(1.3 * sigma * std::pow(kind.stated_wrong, std::sin(turn + lines[i] / 90)));
    }
    return machine;
}

bool isRight(const ModalFit& fit, const ModalModel& truth)
{
    if (fit.modes.size() != truth.modes.size()) return false;
    for (std::size_t k = 0; k < fit.modes.size(); ++k)
        if (std::abs(fit.modes[k].mode.frequency_hz / truth.modes[k].frequency_hz - 1) > .02) return false;
    return true;
}

constexpr int machines = 60;

/// How many of 60 machines are fitted with the right modes.
int rightOf(const MachineKind& kind, DrivingPoint driving_point, std::uint64_t first)
{
    ModalParameters parameters;
    parameters.driving_point = driving_point;
    int tried = 0, right = 0;
    for (std::uint64_t seed = first; tried < machines; ++seed) {
        const auto machine = machineOf(seed, kind);
        if (!machine) continue;
        ++tried;
        const ModalFit fit = fitModes(machine->frf, parameters);
        right += isRight(fit, machine->truth);
        if (driving_point != DrivingPoint::Yes) continue;
        for (const FittedMode& one : fit.modes) EXPECT_GT(one.mode.stiffness_N_mm, 0) << seed;
    }
    return right;
}

/// Two modes one half-power width apart, 1 % noise of the highest line.
Frf closePair(std::uint64_t seed, bool is_opposite, ModalModel& truth)
{
    Draw draw{seed + 5000};
    const double f = draw.uniform(150, 1200), k = 1e4;
    const double first = std::max(4.1 / f, draw.uniform(.01, .04)), second = first * draw.logarithmic(.85, 1.15);
    truth.modes = {{f, first, k}, {f * (1 + first + second), second, (is_opposite ? -k : k) * draw.logarithmic(.5, 2)}};
    std::vector<double> lines;
    for (int i = 40; i <= 2000; ++i) lines.push_back(i);
    Frf frf = synthesised(truth, lines);
    double peak = 0;
    for (const auto& value : frf.value) peak = std::max(peak, std::abs(value));
    const double sigma = .01 * peak / std::sqrt(2);
    for (std::size_t i = 0; i < lines.size(); ++i)
        frf.value[i] += std::complex(sigma * randomNormal(seed, 0, i), sigma * randomNormal(seed, 1, i));
    frf.noise.assign(lines.size(), sigma);
    return frf;
}

}  // namespace

TEST(ModalOrder, RightWithoutCoherence)
{
    // Noise estimated from the lines: wrong by a factor of 1.5 here and there.
    EXPECT_GE(rightOf({false, 1.5}, DrivingPoint::Automatic, 1), .9 * machines);
    EXPECT_GE(rightOf({true, 1.5}, DrivingPoint::Yes, 10000), .9 * machines);
    EXPECT_GE(rightOf({false, 1.5, true}, DrivingPoint::No, 20000), .9 * machines);
}

TEST(ModalOrder, RightWithCoherence)
{
    EXPECT_GE(rightOf({false, 1}, DrivingPoint::Yes, 30000), .95 * machines);
    EXPECT_GE(rightOf({true, 1}, DrivingPoint::Yes, 40000), .95 * machines);
}

TEST(ModalOrder, TellsTwoModesOneHalfPowerWidthApart)
{
    for (const bool is_opposite : {false, true}) {
        constexpr int pairs = 40;
        int right = 0;
        for (std::uint64_t seed = 1; seed <= pairs; ++seed) {
            ModalModel truth;
            const Frf frf = closePair(seed, is_opposite, truth);
            right += isRight(fitModes(frf), truth);
        }
        EXPECT_GE(right, .8 * pairs) << is_opposite;
    }
}

TEST(ModalOrder, LinesFromHalfAHertzMakeNoModes)
{
    // A hammer's record: flat noise of the accelerometer from 0.5 Hz, where the receptance is nothing but noise.
    const ModalModel truth{{{317, .025, 2e4}, {900, .03, 3e4}}, {}, {}};
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
        std::vector<double> lines;
        for (int i = 1; i <= 1600; ++i) lines.push_back(.5 * i);
        Frf frf = synthesised(truth, lines);
        double peak = 0;
        for (std::size_t i = 0; i < lines.size(); ++i)
            peak = std::max(peak, std::abs(frf.value[i]) * lines[i] * lines[i]);
        for (std::size_t i = 0; i < lines.size(); ++i) {
            const double sigma = peak / 300 / std::sqrt(2) / (lines[i] * lines[i]);
            frf.value[i] += std::complex(sigma * randomNormal(seed, 0, i), sigma * randomNormal(seed, 1, i));
            frf.noise.push_back(sigma);
        }
        const ModalFit fit = fitModes(frf);
        ASSERT_THAT(fit.modes, SizeIs(1)) << seed;
        EXPECT_NEAR(fit.modes[0].mode.frequency_hz, 317, .3) << seed;
        EXPECT_LT(fit.error_rms_percent, 40) << seed;  // lines of noise are not counted
        EXPECT_FALSE(contains(fit.notes, notes::fitLeavesMore)) << seed;
    }
}

TEST(ModalOrder, SaysWhatItLeavesAboveTheScatter)
{
    // Two modes, one asked for.
    Frf frf = synthesised({{{300, .02, 1e4}, {340, .02, 2e4}}, {}, {}}, [] {
        std::vector<double> lines;
        for (int i = 50; i <= 1000; ++i) lines.push_back(i);
        return lines;
    }());
    for (std::size_t i = 0; i < frf.value.size(); ++i) {
        const double sigma = .01 / std::sqrt(2) * std::abs(frf.value[i]);
        frf.value[i] += std::complex(sigma * randomNormal(1, 0, i), sigma * randomNormal(1, 1, i));
        frf.noise.push_back(sigma);
    }
    ModalParameters one;
    one.modes = 1;
    const ModalFit fit = fitModes(frf, one);
    EXPECT_NEAR(fit.scatter_percent, 1, .2);
    EXPECT_GT(fit.error_rms_percent, 5);
    EXPECT_TRUE(contains(fit.notes, notes::fitLeavesMore));
    const ModalFit both = fitModes(frf);
    EXPECT_NEAR(both.error_rms_percent, both.scatter_percent, .2);
    EXPECT_FALSE(contains(both.notes, notes::fitLeavesMore));
}

TEST(ModalOrder, StablePolesAreThoseOfTheStructure)
{
    const ModalModel truth{{{223, .03, 1e4}, {600, .02, 2e4}, {1100, .01, 5e4}}, {}, {}};
    std::vector<double> lines;
    for (int i = 50; i <= 1500; ++i) lines.push_back(i);
    Frf frf = synthesised(truth, lines);
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const double sigma = .003 * std::abs(frf.value[i]);
        frf.value[i] += std::complex(sigma * randomNormal(1, 0, i), sigma * randomNormal(1, 1, i));
        frf.noise.push_back(sigma);
    }
    const ModalFit fit = fitModes(frf);
    for (const ModalMode& mode : truth.modes) {
        const auto near = [&](const OrderPole& pole) {
            return std::abs(pole.frequency_hz / mode.frequency_hz - 1) < .01 && pole.is_damping_stable &&
                   std::abs(pole.damping_ratio / mode.damping_ratio - 1) < .2;
        };
        EXPECT_GE(std::count_if(fit.orders.begin(), fit.orders.end(), near), 6) << mode.frequency_hz;
    }
}

}  // namespace lathelier::receptance
