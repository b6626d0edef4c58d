// Limits of measured responses with noise against those of the structure that was measured.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <numeric>

#include "engine/core/random.h"
#include "engine/io/frf/frf_noise.h"
#include "engine/io/frf/measured_frf.h"
#include "engine/receptance/usable_codes.h"
#include "engine/receptance/usable_lines.h"
#include "engine/stability/boundary.h"
#include "engine/stability/lobes.h"
#include "engine/stability/modes.h"
#include "engine/stability/stability_codes.h"
#include "tests/engine/core/code_of_error.h"
#include "tests/engine/stability/machines.h"

namespace lathelier::stability {
namespace {

const std::vector<Mode> structure{{317, 0.022, 12000}, {900, 0.028, 30000}};

struct TapTest {
    double first_hz = 0.5;
    double last_hz = 800;
    double step_hz = 0.5;
    double snr = 300;        ///< highest accelerance over the sensor's noise
    int rise = 0;            ///< 0: flat noise; below 30 Hz the noise rises as 1/f, 1/f²
    bool coherence = false;  ///< stored
};

/// The accelerance as an impact test gives it.
Frf measured(const TapTest& test, std::uint64_t seed)
{
    Frf frf;
    frf.quantity = FrfQuantity::Accelerance;
    double peak = 0;
    for (double f = test.first_hz; f <= test.last_hz; f += test.step_hz) {
        frf.frequency_hz.push_back(f);
        frf.value.push_back(receptanceOf(structure, f) * -std::pow(2 * std::numbers::pi * f, 2));
        peak = std::max(peak, std::abs(frf.value.back()));
    }
    for (std::size_t i = 0; i < frf.value.size(); ++i) {
        const double noise = peak / test.snr / std::numbers::sqrt2 *
                             std::sqrt(1 + (test.rise > 0 ? std::pow(30 / frf.frequency_hz[i], 2 * test.rise) : 0));
        const double power = std::norm(frf.value[i]);
        if (test.coherence) frf.coherence.push_back(power / (power + 2 * noise * noise));
        frf.value[i] += noise * std::complex<double>(randomNormal(seed, 1, i), randomNormal(seed, 2, i));
    }
    frf.noise = io::noiseOf(frf);
    return io::toReceptance(frf);
}

LobeParameters asking()
{
    LobeParameters p;
    p.cutting_coefficient_N_mm2 = coefficient_N_mm2;
    p.speed_rpm = {{2500, 4500}};
    p.points = 100;
    return p;
}

double trueDepth_mm()
{
    return *findLobes(frfOf(structure, 10000), asking()).minimum_depth_mm;
}

}  // namespace

TEST(MeasuredLimit, OfATapTestIsThatOfTheStructure)
{
    const double depth_mm = trueDepth_mm();
    for (const bool coherence : {false, true})
        for (const int rise : {0, 1, 2})
            for (const double first_hz : {0.5, 5.0, 20.0})
                for (const double snr : {100.0, 1000.0})
                    for (std::uint64_t seed = 0; seed < 3; ++seed) {
                        SCOPED_TRACE(::testing::Message() << "coherence " << coherence << " rise " << rise << " first "
                                                          << first_hz << " snr " << snr << " seed " << seed);
                        Frf frf = measured({first_hz, 800, 0.5, snr, rise, coherence}, seed);
                        Notes notes;
                        receptance::takeUsableLines(frf, {}, "tap.csv", notes);
                        const LobeResult lobes = findLobes(frf, asking());
                        EXPECT_NEAR(*lobes.minimum_depth_mm / depth_mm, 1, snr < 500 ? 0.06 : 0.01);
                        EXPECT_NEAR(*lobes.frequency_of_minimum_hz, 324, 2);
                        EXPECT_FALSE(contains(lobes.notes, notes::minimumInNoise));
                        EXPECT_TRUE(lobes.band);
                    }
}

TEST(MeasuredLimit, LowLinesOfNoiseAreLeftOutAndNamed)
{
    Frf frf = measured({}, 1);
    const std::size_t all = frf.value.size();
    Notes notes;
    const receptance::UsedLines used = receptance::takeUsableLines(frf, {}, "tap.csv", notes);
    EXPECT_GT(used.range_hz.from, 30);
    EXPECT_LT(used.range_hz.from, 250);
    EXPECT_EQ(used.range_hz.to, 800);
    EXPECT_EQ(frf.value.size() + static_cast<std::size_t>(used.left_out), all);
    EXPECT_EQ(frf.noise.size(), frf.value.size());
    EXPECT_TRUE(contains(notes, notes::linesOfNoiseLeftOut));
}

TEST(MeasuredLimit, ARangeThatIsStatedRules)
{
    Frf frf = measured({}, 1);
    Notes notes;
    const receptance::UsedLines used = receptance::takeUsableLines(frf, {{20, 700}}, "tap.csv", notes);
    EXPECT_EQ(used.range_hz, (Interval{20, 700}));
    EXPECT_TRUE(notes.empty());
    Frf again = measured({}, 1);
    EXPECT_EQ(codeOfError([&] {
                  receptance::takeUsableLines(again, {{900, 1000}}, "tap.csv", notes);
              }),
              errors::rangeWithoutLines);
}

/// With the lines of noise a limit is that of the noise, and says so.
TEST(MeasuredLimit, OfNoiseIsUndecided)
{
    Frf frf = measured({0.5, 800, 0.5, 100, 1, false}, 2);
    Notes notes;
    receptance::takeUsableLines(frf, {{0.5, 800}}, "tap.csv", notes);
    const LobeResult lobes = findLobes(frf, asking());
    EXPECT_LT(*lobes.minimum_depth_mm, 0.5 * trueDepth_mm());
    EXPECT_TRUE(contains(lobes.notes, notes::minimumInNoise));
    EXPECT_EQ(notes::minimumInNoise.role, NoteRole::NotModelled);
}

TEST(MeasuredLimit, OfNothingButNoiseIsSaid)
{
    Frf frf;
    for (std::size_t i = 0; i < 500; ++i) {
        frf.frequency_hz.push_back(1.0 + static_cast<double>(i));
        frf.value.emplace_back(randomNormal(3, 1, i), randomNormal(3, 2, i));
    }
    frf.noise = io::noiseOf(frf);
    Notes notes;
    EXPECT_TRUE(receptance::takeUsableLines(frf, {}, "noise.csv", notes).is_all_noise);
    EXPECT_TRUE(contains(notes, notes::nothingAboveNoise));
}

/// The same machine by 1.6 lines in the half-power band (of 14 Hz) of its mode.
TEST(MeasuredLimit, OfAResonanceOfTooFewLinesIsSaid)
{
    const LobeResult coarse = findLobes(measured({20, 790, 9, 1000, 0, false}, 1), asking());
    EXPECT_TRUE(contains(coarse.notes, notes::minimumNotResolved));
    const LobeResult fine = findLobes(measured({20, 790, 1, 1000, 0, false}, 1), asking());
    EXPECT_FALSE(contains(fine.notes, notes::minimumNotResolved));
}

/// 200 measurements of one structure: the stated noise is that of the depths found, and the band holds the true limit.
TEST(MeasuredLimit, NoiseIsThatOfTheDepth)
{
    const LobeResult truth = findLobes(frfOf(structure, 10000), asking());
    double sum = 0, squares = 0, stated = 0;
    constexpr int count = 200;
    std::vector<int> within(truth.limit.depth_mm.size());
    for (std::uint64_t seed = 0; seed < count; ++seed) {
        const LobeResult one = findLobes(measured({100, 800, 2, 100, 0, false}, seed), asking());
        const double ratio = *one.minimum_depth_mm / *truth.minimum_depth_mm;
        sum += ratio;
        squares += ratio * ratio;
        stated += *one.minimum_noise_percent / 100;
        for (std::size_t i = 0; i < within.size(); ++i)
            within[i] +=
                one.band->low_mm[i] <= truth.limit.depth_mm[i] && truth.limit.depth_mm[i] <= one.band->high_mm[i];
    }
    const double mean = sum / count, scatter = std::sqrt(squares / count - mean * mean);
    EXPECT_GT(stated / count, 0.7 * scatter);
    EXPECT_LT(stated / count, 3 * scatter);  // the least of several lines scatters less than one of them
    const double held = std::accumulate(within.begin(), within.end(), 0.0) / count / static_cast<double>(within.size());
    EXPECT_GT(held, 0.9);
}

/// Machines whose modes err independently, as stated: 95 of 100 lie within the band, at each speed.
TEST(LobeBand, HoldsMachinesWhoseModesErrIndependently)
{
    LobeParameters asked = asking();
    asked.points = 60;
    asked.uncertainty_frequency_percent = 2;
    asked.uncertainty_compliance_percent = 5;
    asked.uncertainty_damping_percent = 10;
    const std::vector<std::vector<Mode>> machines{structure,
                                                  {{240, 0.03, 9000}, {262, 0.025, 14000}},
                                                  {{180, 0.04, 8000}, {420, 0.02, 20000}, {700, 0.03, 9000}}};
    for (const std::vector<Mode>& machine : machines) {
        receptance::UncertainModel model;
        for (const Mode& mode : machine)
            model.model.modes.push_back({mode.frequency_hz, mode.damping_ratio, mode.stiffness_N_mm, 0});
        const LobeBand band = *findLobes(frfOf(machine, 10000), asked, {}, model).band;
        LobeParameters sure = asked;
        sure.uncertainty_frequency_percent = sure.uncertainty_compliance_percent = sure.uncertainty_damping_percent = 0;
        std::vector<int> within(60);
        constexpr int count = 2000;
        for (std::uint64_t seed = 0; seed < count; ++seed) {
            std::vector<Mode> other = machine;
            for (std::size_t m = 0; m < other.size(); ++m) {
                const auto factor = [&](std::uint64_t stream, double share) {
                    return 1 + share * randomNormal(77, 3 * m + stream, seed);
                };
                other[m].frequency_hz *= factor(0, 0.02);
                other[m].damping_ratio *= factor(1, 0.1);
                other[m].stiffness_N_mm /= factor(2, 0.05);
            }
            const LobeLimit limit = limitOf(frfOf(other, 6000), sure);
            for (std::size_t i = 0; i < within.size(); ++i)
                within[i] += limit.depth_mm[i] >= band.low_mm[i] && limit.depth_mm[i] <= band.high_mm[i];
        }
        double all = 0;
        for (const int held : within) {
            EXPECT_GT(held, 0.88 * count);
            all += held;
        }
        EXPECT_GT(all, 0.93 * count * 60);
        EXPECT_LT(all, 0.97 * count * 60);
    }
}

TEST(LobeBand, OfTheDampingNeedsModes)
{
    LobeParameters asked = asking();
    asked.uncertainty_damping_percent = 10;
    EXPECT_THROW(findLobes(frfOf(structure, 10000), asked), Error);
}

}  // namespace lathelier::stability
