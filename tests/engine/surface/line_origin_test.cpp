// What is no chatter: highlights of lamps, a second feed. And what is: the same chatter under the lamps, six waves in
// an overview. The scale that a file states.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "../core/code_of_error.h"
#include "engine/core/understanding.h"
#include "engine/surface/surface_codes.h"
#include "pictures.h"

namespace lathelier::surface::test {
namespace {

/// A field of 9 × 7 mm, turned.
SyntheticParameters turnedField(int seed, double turned_deg)
{
    SyntheticParameters p = smallField(seed);
    p.feed_mm_rev = 0.12;
    p.mm_per_px = 0.01;
    p.width = 900;
    p.height = 700;
    p.feed_direction_deg = turned_deg;
    return p;
}

/// Two bright bands along the axis, as of two lamps: multiplied and added, clipped to white.
io::Image underLamps(io::Image image, double glare, double direction_deg, double first, double second)
{
    const double turn = direction_deg * std::acos(-1.0) / 180;
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) {
            const double across =
                ((y - image.height / 2) * std::cos(turn) - (x - image.width / 2) * std::sin(turn)) / image.height;
            double light = 0;
            for (const double middle : {first, second}) light += std::exp(-std::pow((across - middle) / 0.06, 2));
            float& grey = image.grey[static_cast<std::size_t>(y * image.width + x)];
            grey = static_cast<float>(std::min(1.0, grey * (1 + glare * light) + 0.25 * glare * light));
        }
    return image;
}

TEST(LineOrigin, TwoLampsAreNoChatter)
{
    int seed = 0;
    for (const double turned_deg : {0.0, 7.0, 12.0, -12.0})
        for (const double glare : {0.6, 1.2}) {
            ++seed;
            const SyntheticParameters truth = turnedField(seed, turned_deg);
            const ImageMarks marks =
                marksOf(underLamps(syntheticPicture(truth), glare, turned_deg, -0.22, 0.02 * seed), known(truth));
            EXPECT_FALSE(marks.chatter_marks) << turned_deg << " " << glare;
            ASSERT_TRUE(marks.feed_marks);
            EXPECT_NEAR(*marks.feed_marks->pitch_mm, 0.12, 1e-3);
        }
}

TEST(LineOrigin, ChatterUnderTheSameLamps)
{
    for (const double turned_deg : {7.0, 12.0}) {
        SyntheticParameters truth = turnedField(20, turned_deg);
        truth.amplitude_um = 2 * theoreticalDepth_um(truth);
        const ImageMarks marks =
            marksOf(underLamps(syntheticPicture(truth), 0.9, turned_deg, -0.22, 0.2), known(truth));
        ASSERT_TRUE(marks.chatter_marks) << turned_deg;
        EXPECT_NEAR(marks.chatter_marks->nu, 361 / 33.6 - 11, 5e-3);
    }
}

TEST(LineOrigin, TwoFeedsAreTwoFeeds)
{
    const SyntheticParameters first = turnedField(3, 0);
    SyntheticParameters second = first;
    second.feed_mm_rev = 0.2;
    io::Image image = syntheticPicture(first);
    const io::Image other = syntheticPicture(second);
    for (int y = 0; y < image.height; ++y)
        for (int x = image.width / 2; x < image.width; ++x)
            image.grey[static_cast<std::size_t>(y * image.width + x)] = other.at(x, y);
    const SurfaceResult result = findSurfaceMarks({{"picture", image}}, known(first));
    const ImageMarks& marks = result.images.front();
    EXPECT_FALSE(marks.chatter_marks);
    EXPECT_EQ(marks.verdict, MarksVerdict::FeedMarks);
    EXPECT_NEAR(*marks.feed_marks->pitch_mm, 0.12, 1e-3);
    ASSERT_TRUE(marks.second_feed_marks);
    EXPECT_NEAR(*marks.second_feed_marks->pitch_mm, 0.2, 2e-3);
    EXPECT_TRUE(contains(result.notes, notes::twoFeeds));
}

TEST(LineOrigin, LessThanOneWaveIsNeverChatter)
{
    for (const double waves : {0.6, 0.9})
        for (SyntheticParameters truth : {smallField(7), turnedField(8, 7), overview(9)}) {
            truth.frequency_hz = waves * truth.speed_rpm / 60;
            truth.amplitude_um = 2 * theoreticalDepth_um(truth);
            const SurfaceResult result = findSurfaceMarks({{"picture", syntheticPicture(truth)}}, known(truth));
            const ImageMarks& marks = result.images.front();
            EXPECT_FALSE(marks.chatter_marks) << waves << " " << truth.mm_per_px;
            EXPECT_EQ(marks.verdict, MarksVerdict::Undecided) << waves << " " << truth.mm_per_px;
            EXPECT_TRUE(contains(result.notes, notes::lessThanOneWave));
            EXPECT_EQ(understandingOf(result.notes).count(), 1);
        }
}

/// Light from all sides doubles the pattern: 1.2 and 1.8 waves are seen.
TEST(LineOrigin, LessThanOneWaveDoubledIsNeverChatter)
{
    for (const double waves : {0.6, 0.9})
        for (SyntheticParameters truth : {turnedField(8, 7), overview(9)}) {
            truth.light = Light::Ring;
            truth.frequency_hz = waves * truth.speed_rpm / 60;
            truth.amplitude_um = 2 * theoreticalDepth_um(truth);
            const ImageMarks marks = marksOf(syntheticPicture(truth), known(truth));
            EXPECT_FALSE(marks.chatter_marks) << waves << " " << truth.mm_per_px;
            EXPECT_NE(marks.verdict, MarksVerdict::ChatterMarks);
        }
}

/// With a half or a third of a wave between the tracks, lines of a slow pattern merge and are read as of many waves.
TEST(LineOrigin, MergedLinesOfSlowPatternsAreNeverChatter)
{
    for (const double waves : {1 / 2.0, 2 / 3.0})
        for (SyntheticParameters truth : {smallField(2), turnedField(2, 12)}) {
            truth.feed_mm_rev = 0.15;
            truth.diameter_mm = 40;
            truth.frequency_hz = waves * truth.speed_rpm / 60;
            truth.amplitude_um = 3 * theoreticalDepth_um(truth);
            const ImageMarks marks = marksOf(syntheticPicture(truth), known(truth));
            EXPECT_FALSE(marks.chatter_marks) << waves << " " << truth.mm_per_px;
            EXPECT_TRUE(marks.feed_marks) << waves << " " << truth.mm_per_px;
        }
}

TEST(LineOrigin, ThreeWavesAreChatter)
{
    SyntheticParameters truth = overview(9);
    truth.frequency_hz = 3.3 * truth.speed_rpm / 60;
    truth.amplitude_um = 2 * theoreticalDepth_um(truth);
    const ImageMarks marks = marksOf(syntheticPicture(truth), known(truth));
    ASSERT_TRUE(marks.chatter_marks);
    EXPECT_EQ(marks.verdict, MarksVerdict::ChatterMarks);
    EXPECT_NEAR(*marks.chatter_marks->waves_measured, 3, 3 * *marks.chatter_marks->waves_uncertainty);
    EXPECT_NEAR(*marks.chatter_marks->frequency_hz, truth.frequency_hz, 0.3);
}

/// Chatter so strong that the feed marks are lost under a lamp lies in all parts of the picture.
TEST(LineOrigin, ChatterStrongerThanTheFeedIsNoSecondFeed)
{
    SyntheticParameters truth = turnedField(12, 0);
    truth.diameter_mm = 40;
    truth.feed_mm_rev = 0.1;
    truth.speed_rpm = 1600;
    truth.frequency_hz = 410;
    truth.amplitude_um = 3 * theoreticalDepth_um(truth);
    const ImageMarks marks = marksOf(underLamps(syntheticPicture(truth), 0.75, 0, -0.2, 0.2), known(truth));
    EXPECT_FALSE(marks.second_feed_marks);
    ASSERT_TRUE(marks.chatter_marks);
    EXPECT_NEAR(marks.chatter_marks->nu, 410 / (1600 / 60.0) - 15, 5e-3);
}

TEST(LineOrigin, SixWavesInAnOverviewAreCertain)
{
    SyntheticParameters truth = overview(5);
    truth.frequency_hz = 21.7 * truth.speed_rpm / 60;
    truth.amplitude_um = 2 * theoreticalDepth_um(truth);
    const ImageMarks marks = marksOf(syntheticPicture(truth), known(truth));
    ASSERT_TRUE(marks.chatter_marks);
    EXPECT_NEAR(*marks.chatter_marks->waves_in_view, 6, 0.5);
    EXPECT_TRUE(marks.chatter_marks->m_certain);
    EXPECT_EQ(marks.chatter_marks->m, 22);
    EXPECT_NEAR(*marks.chatter_marks->frequency_hz, truth.frequency_hz, 0.3);
}

TEST(LineOrigin, TheScaleOfAFileIsUsedWhenAskedFor)
{
    const SyntheticParameters truth = smallField(6);
    io::Image image = syntheticPicture(truth);
    SurfaceParameters asked = known(truth);
    asked.mm_per_px.reset();
    image.um_per_px = 1000 * truth.mm_per_px;
    EXPECT_FALSE(marksOf(image, asked).mm_per_px);
    asked.scale_from_file = true;
    const SurfaceResult result = findSurfaceMarks({{"picture", image}}, asked);
    EXPECT_DOUBLE_EQ(*result.images.front().mm_per_px, truth.mm_per_px);
    EXPECT_EQ(result.images.front().mm_per_px_source, ScaleSource::File);
    EXPECT_TRUE(contains(result.notes, notes::scaleFromFile));
    image.um_per_px = 0;
    EXPECT_EQ(codeOfError([&] { marksOf(image, asked); }), errors::scaleNotStated);
    asked.mm_per_px = truth.mm_per_px;
    EXPECT_EQ(codeOfError([&] { marksOf(image, asked); }), errors::valueNotUnderstood);
}

}  // namespace
}  // namespace lathelier::surface::test
