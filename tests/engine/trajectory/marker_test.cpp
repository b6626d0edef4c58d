#include "engine/trajectory/marker.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "engine/core/error.h"
#include "engine/core/random.h"
#include "engine/trajectory/trajectory_codes.h"

namespace lathelier::trajectory {
namespace {

using std::numbers::pi;

io::ProbeRecord markerRecord(std::vector<double> values, double rate_hz = 1000)
{
    io::ProbeRecord record;
    record.rate_hz = rate_hz;
    record.channels = {{"marker", io::ProbeChannel::Unit::Volt, 1, std::move(values)}};
    return record;
}

/// Pulses of `width` frames with straight edges of `edge` frames, every `period` frames, half up at `first`.
std::vector<double> pulses(int frames, double period, double first, double width, double edge, double low, double high)
{
    std::vector<double> values;
    for (int i = 0; i < frames; ++i) {
        const double at = std::fmod(i - first + 100 * period + period / 2, period) - period / 2;
        const double up = std::clamp(0.5 + at / edge, 0.0, 1.0) - std::clamp(0.5 + (at - width) / edge, 0.0, 1.0);
        values.push_back(low + (high - low) * up);
    }
    return values;
}

std::vector<double> marksOf(const std::vector<double>& values)
{
    const io::ProbeRecord record = markerRecord(values);
    const MarkerLevels levels = findMarkerLevels(values);
    EXPECT_TRUE(levels.isMarker()) << levels.complaint.english;
    return findMarks(values, FrameClock(record), levels);
}

TEST(Marker, TheMarkIsTheHalfWayPointOfTheLeadingEdge)
{
    const std::vector<double> marks = marksOf(pulses(1000, 97.3, 31.6, 6, 3, 0.05, 3.5));
    ASSERT_EQ(marks.size(), 10u);
    for (std::size_t i = 0; i < marks.size(); ++i)
        EXPECT_NEAR(marks[i], (31.6 + 97.3 * static_cast<double>(i)) / 1000, 1e-9);
}

TEST(Marker, PulsesThatGoDownAreMarkedAtTheirLeadingEdgeToo)
{
    const std::vector<double> marks = marksOf(pulses(1000, 97.3, 31.6, 6, 3, 5, -5));
    ASSERT_EQ(marks.size(), 10u);
    EXPECT_NEAR(marks[4], (31.6 + 97.3 * 4) / 1000, 1e-9);
}

TEST(Marker, ASingleFrameIsEnoughOfAPulse)
{
    std::vector<double> values(5000, 0.0);
    for (std::size_t i = 50; i < values.size(); i += 100) values[i] = 5;
    EXPECT_EQ(marksOf(values).size(), 50u);
}

TEST(Marker, NoiseOnTheEdgeGivesNoSecondMark)
{
    std::vector<double> values = pulses(20000, 200, 60, 30, 20, 0, 5);
    for (std::size_t i = 0; i < values.size(); ++i) values[i] += 0.3 * randomNormal(1, 2, i);
    EXPECT_EQ(marksOf(values).size(), 100u);
}

TEST(Marker, WhatIsNoMarkerIsTold)
{
    std::vector<double> sine, noise;
    for (std::size_t i = 0; i < 4000; ++i) {
        sine.push_back(0.24 * std::sin(2 * pi * static_cast<double>(i) / 400));
        noise.push_back(randomNormal(1, 1, i));
    }
    EXPECT_FALSE(findMarkerLevels(sine).isMarker());
    EXPECT_FALSE(findMarkerLevels(noise).isMarker());
    EXPECT_FALSE(findMarkerLevels(std::vector<double>(4000, 0.05)).isMarker());
    EXPECT_FALSE(findMarkerLevels(std::vector<double>{0, 5, 0}).isMarker());
    EXPECT_FALSE(findMarkerLevels(std::vector<double>(100, NAN)).isMarker());
}

TEST(FrameClock, TheCubicIsExactForACubicAndTimesMayBeUneven)
{
    io::ProbeRecord record = markerRecord({});
    const auto cubic = [](double t) { return 2 - t + 3 * t * t - 5 * t * t * t; };
    for (int i = 0; i < 50; ++i) {
        record.time_s.push_back(0.1 * i + 0.3 * std::sin(i * 0.1));
        record.channels[0].values.push_back(cubic(record.time_s.back()));
    }
    const FrameClock uneven(record);
    for (double t = 0; t < record.time_s.back(); t += 0.0371)
        EXPECT_NEAR(uneven.valueAt(record.channels[0].values, t), cubic(t), 1e-10 * (1 + std::abs(cubic(t))));
    EXPECT_TRUE(std::isnan(uneven.valueAt(record.channels[0].values, -0.01)));
    EXPECT_TRUE(std::isnan(uneven.valueAt(record.channels[0].values, record.time_s.back() + 0.01)));

    record.time_s.clear();
    record.rate_hz = 8;
    for (int i = 0; i < 50; ++i) record.channels[0].values[static_cast<std::size_t>(i)] = cubic(i / 8.0);
    const FrameClock even(record);
    for (double t = 0; t < 49 / 8.0; t += 0.0371)
        EXPECT_NEAR(even.valueAt(record.channels[0].values, t), cubic(t), 1e-10 * (1 + std::abs(cubic(t))));
}

TEST(FrameClock, TimesThatArePrintedRoundedStayEven)
{
    io::ProbeRecord record = markerRecord(std::vector<double>(1000, 0.0));
    for (int i = 0; i < 1000; ++i) record.time_s.push_back(std::round(i / 6500.0 * 1e4) / 1e4);  // some come twice
    const FrameClock clock(record);
    EXPECT_NEAR(clock.time_s(500), 500 / 6500.0, 1e-4);
    EXPECT_NEAR(clock.step_s(), 1 / 6500.0, 1e-7);
}

TEST(FrameClock, TimeThatGoesBackIsRefused)
{
    io::ProbeRecord record = markerRecord(std::vector<double>(100, 0.0));
    for (int i = 0; i < 100; ++i) record.time_s.push_back(i < 40 ? 0.01 * i : 0.01 * i - 0.2);
    try {
        FrameClock clock(record);
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), errors::timeNotIncreasing);
        EXPECT_EQ(std::get<std::int64_t>(*find(error.values(), "row")), 41);
    }
}

}  // namespace
}  // namespace lathelier::trajectory
