// Audio signal of a cut: growth and frequency against the characteristic equation, continuity at changes.
#include "engine/stability/simulation/cut_stream.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "engine/stability/simulation/characteristic_root.h"
#include "tests/engine/stability/machines.h"

namespace lathelier::stability {
namespace {

constexpr double rate_hz = 44100;
const std::vector<Mode> stiff{{480, 0.03, 5e4}, {760, 0.02, 8e4}};

StreamParameters streamAt(double speed_rpm, double depth_mm, double noise_percent = 1)
{
    StreamParameters p;
    p.speed_rpm = speed_rpm;
    p.depth_mm = depth_mm;
    p.noise_percent = noise_percent;
    return p;
}

std::vector<float> samplesOf(CutStream& stream, double seconds)
{
    std::vector<float> samples(static_cast<std::size_t>(seconds * rate_hz));
    stream.fill(samples);
    return samples;
}

double largest(const std::vector<float>& samples, std::size_t begin, std::size_t end)
{
    double found = 0;
    for (std::size_t i = begin; i < end; ++i) found = std::max(found, static_cast<double>(std::abs(samples[i])));
    return found;
}

/// By the upward zero crossings, straight between two samples.
double frequencyOf(const std::vector<float>& samples, std::size_t begin, std::size_t end)
{
    double first = -1, last = -1;
    int periods = -1;
    for (std::size_t i = begin + 1; i < end; ++i) {
        const double a = samples[i - 1], b = samples[i];
        if (!(a < 0 && b >= 0)) continue;
        last = static_cast<double>(i - 1) + a / (a - b);
        if (first < 0) first = last;
        ++periods;
    }
    return periods * rate_hz / (last - first);
}

TEST(CutStream, GrowsAndSwingsAsTheCharacteristicEquationSays)
{
    const double speed_rpm = 2885, depth_mm = 0.34;
    const Growth exact = growthOfRoots(paperA, {2000 * depth_mm, 0, 1}, 60 / speed_rpm);
    CutStream stream(paperA, streamAt(speed_rpm, depth_mm, 0), rate_hz);
    const std::vector<float> samples = samplesOf(stream, 1.2);
    const auto revolution = static_cast<std::size_t>(std::lround(60 / speed_rpm * rate_hz));
    const std::size_t begin = 20 * revolution, end = 50 * revolution;
    EXPECT_NEAR(frequencyOf(samples, begin, end), exact.frequency_hz, 1e-3 * exact.frequency_hz);
    const double grown = largest(samples, end, end + revolution) / largest(samples, begin, begin + revolution);
    EXPECT_NEAR(std::pow(grown, 1.0 / 30), exact.per_revolution, 2e-3);
}

TEST(CutStream, ChatterIsBoundedByTheToolLeavingTheCutAndAStableCutIsQuiet)
{
    CutStream chatter(paperA, streamAt(2885, 0.6), rate_hz);
    const std::vector<float> loud = samplesOf(chatter, 2);
    const std::size_t half = loud.size() / 2;
    const double earlier = largest(loud, half, half + half / 2), later = largest(loud, half + half / 2, loud.size());
    EXPECT_GT(later, 0.5);
    EXPECT_LT(later, 20);
    EXPECT_NEAR(later, earlier, 0.15 * earlier) << "a limit cycle";
    CutStream stable(paperA, streamAt(2885, 0.2), rate_hz);
    const std::vector<float> quiet = samplesOf(stable, 2);
    EXPECT_LT(largest(quiet, half, quiet.size()), 0.05 * later);
    EXPECT_GT(largest(quiet, half, quiet.size()), 0) << "the chip tears";
}

TEST(CutStream, SameCallsGiveTheSameSamplesHoweverTheyAreCut)
{
    CutStream one(paperA, streamAt(2885, 0.5), rate_hz), other(paperA, streamAt(2885, 0.5), rate_hz);
    const std::vector<float> whole = samplesOf(one, 0.1);
    std::vector<float> parts(whole.size());
    other.fill({parts.data(), 1000});
    other.fill({parts.data() + 1000, parts.size() - 1000});
    EXPECT_EQ(whole, parts);
}

TEST(CutSound, NeverJumpsWhenTheCutIsChanged)
{
    CutSound sound(rate_hz);
    sound.take(paperA, streamAt(2885, 0.6));
    std::vector<float> samples(static_cast<std::size_t>(rate_hz));
    sound.fill(samples, 0.5);
    const auto steepest = [](const std::vector<float>& s, std::size_t begin) {
        double step = 0;
        for (std::size_t i = std::max<std::size_t>(1, begin); i < s.size(); ++i)
            step = std::max(step, static_cast<double>(std::abs(s[i] - s[i - 1])));
        return step;
    };
    const double usual = steepest(samples, samples.size() / 2);
    ASSERT_GT(usual, 1e-3);
    const auto changed = [&](const auto& change) {
        const float before = samples.back();
        change();
        sound.fill(samples, 0.5);
        samples.insert(samples.begin(), before);
        const double step = steepest(samples, 0);
        samples.erase(samples.begin());
        return step;
    };
    EXPECT_LT(changed([&] { sound.moveTo(3600, 0.6); }), 2 * usual);
    EXPECT_LT(changed([&] { sound.moveTo(2885, 0.2); }), 2 * usual);
    EXPECT_LT(changed([&] { sound.moveTo(2885, 0.6); }), 2 * usual);
    // A stiffer machine sounds higher: its own steps are steeper than those of the weak one.
    EXPECT_LT(changed([&] { sound.take(stiff, streamAt(2000, 3)); }), 6 * usual);
}

TEST(CutSound, IsSilentWithoutACutAndWithinFullScale)
{
    CutSound sound(rate_hz);
    std::vector<float> samples(4410, 1.0F);
    sound.fill(samples, 1);
    EXPECT_EQ(largest(samples, 0, samples.size()), 0);
    sound.take(paperA, streamAt(2885, 1.1));
    samples.resize(88200);
    sound.fill(samples, 5);
    EXPECT_LE(largest(samples, 0, samples.size()), 1);
    EXPECT_GT(largest(samples, samples.size() / 2, samples.size()), 0.1);
    sound.fill(samples, 0);
    sound.fill(samples, 0);
    EXPECT_EQ(largest(samples, 0, samples.size()), 0);
}

}  // namespace
}  // namespace lathelier::stability
