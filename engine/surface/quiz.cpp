#include "engine/surface/quiz.h"

#include <cmath>

#include "engine/core/random.h"

namespace lathelier::surface {
namespace {

constexpr double quizTolerance = 0.1;  // tolerance of an answer, as a share of n
constexpr int mostWavesOff = 4;

/// A value between two ends, on a step.
double drawn(int number, std::uint64_t which, double from, double to, double step)
{
    const double value = from + (to - from) * randomUniform(20161, static_cast<std::uint64_t>(number), which);
    return std::round(value / step) * step;
}

}  // namespace

SyntheticParameters quizPicture(int number, const SyntheticParameters& frame)
{
    enum Which : std::uint64_t { Feed, Diameter, Speed, WholeWaves, Rest, Sign, Strength };
    SyntheticParameters p = frame;
    p.feed_mm_rev = drawn(number, Feed, 0.1, 0.3, 0.05);
    p.diameter_mm = drawn(number, Diameter, 20, 50, 1);
    p.nose_radius_mm = 0.8;
    p.speed_rpm = drawn(number, Speed, 600, 2400, 10);
    const double nu = drawn(number, Rest, 0.1, 0.4, 0.01) * (drawn(number, Sign, 0, 1, 1e-3) < 0.75 ? -1 : 1);
    p.frequency_hz = p.speed_rpm / 60 * (drawn(number, WholeWaves, 4, 14, 1) + nu);
    const double depth_um = 1000 * p.feed_mm_rev * p.feed_mm_rev / (8 * p.nose_radius_mm);
    p.amplitude_um = drawn(number, Strength, 2, 4, 0.1) * depth_um;
    p.feed_direction_deg = 0;
    p.cut = CutDirection::Down;
    p.light = Light::AlongFeed;
    p.seed = number;
    return p;
}

QuizAnswer checkedAnswer(double frequency_hz, const SyntheticParameters& picture)
{
    const double n = picture.speed_rpm / 60, f = picture.frequency_hz;
    const auto is = [&](double wanted) { return std::abs(frequency_hz - wanted) <= quizTolerance * n; };
    if (is(f)) return {QuizVerdict::Right};
    const Waves waves = wavesPerRevolution(f, picture.speed_rpm);
    if (is(n * (waves.m - waves.nu))) return {QuizVerdict::OtherSign};
    for (int k = 1; k <= mostWavesOff; ++k)
        for (const int by : {k, -k})
            if (is(f + by * n)) return {QuizVerdict::OtherWaves, by};
    for (const double times : {2.0, 3.0, 0.5, 1.0 / 3})
        if (is(times * f)) return {QuizVerdict::Multiple};
    return {};
}

}  // namespace lathelier::surface
