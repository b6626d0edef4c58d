// Feed marks and chatter marks of pictures with known truth.
#include "engine/surface/surface.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "engine/core/core_codes.h"
#include "engine/surface/surface_codes.h"
#include "engine/surface/surface_quantities.h"
#include "engine/surface/surface_report.h"
#include "tests/engine/surface/pictures.h"

namespace lathelier::surface {
namespace {

using namespace test;

double directionError(const ImageMarks& marks, const SyntheticParameters& truth)
{
    const double expected = truth.feed_direction_deg - helixAngle_deg(truth.feed_mm_rev, truth.diameter_mm);
    return std::abs(angleModulo180(marks.feed_marks->direction_deg - expected));
}

bool isAmong(const std::vector<double>& candidates, double frequency_hz)
{
    return std::any_of(candidates.begin(), candidates.end(),
                       [&](double c) { return std::abs(c - frequency_hz) < 0.3; });
}

TEST(Surface, FeedMarksAlone)
{
    for (int seed = 1; seed <= 3; ++seed) {
        SyntheticParameters truth = smallField(seed);
        truth.irregular = 0.1 * seed;
        truth.feed_direction_deg = -11 + 7 * seed;
        const ImageMarks marks = marksOf(syntheticPicture(truth), known(truth));
        ASSERT_TRUE(marks.feed_marks);
        EXPECT_LT(std::abs(*marks.feed_marks->pitch_error_percent), 0.5);
        EXPECT_LT(directionError(marks, truth), 0.1);
        EXPECT_FALSE(marks.chatter_marks);
        EXPECT_EQ(marks.verdict, MarksVerdict::FeedMarks);
        EXPECT_LT(*marks.detection_limit_relative_to_feed, 0.2);
    }
}

TEST(Surface, ChatterInASmallFieldHasCandidates)
{
    for (int seed = 1; seed <= 2; ++seed) {
        SyntheticParameters truth = smallField(seed);
        truth.amplitude_um = 2.5 * theoreticalDepth_um(truth);
        const ImageMarks marks = marksOf(syntheticPicture(truth), known(truth));
        ASSERT_TRUE(marks.chatter_marks);
        EXPECT_LT(std::abs(*marks.feed_marks->pitch_error_percent), 0.5);
        EXPECT_LT(directionError(marks, truth), 0.1);
        const ChatterMarks& chatter = *marks.chatter_marks;
        EXPECT_NEAR(chatter.nu, wavesPerRevolution(361, 2016).nu, 5e-3);
        EXPECT_FALSE(chatter.m_certain);
        EXPECT_LE(chatter.candidates_hz.size(), 5U);
        EXPECT_TRUE(isAmong(chatter.candidates_hz, 361));
        EXPECT_EQ(chatter.kind, ChatterKind::Regenerative);

        SurfaceParameters expecting = known(truth);
        expecting.expect_hz = 357;
        const SurfaceResult chosen = findSurfaceMarks({{"a", syntheticPicture(truth)}}, expecting);
        EXPECT_NEAR(*chosen.images[0].chatter_marks->frequency_hz, 361, 0.3);
        EXPECT_TRUE(contains(chosen.notes, notes::chosenByExpectation));
    }
}

TEST(Surface, OverviewSettlesTheFrequency)
{
    SyntheticParameters truth = overview(1);
    truth.amplitude_um = 2.5 * theoreticalDepth_um(truth);
    const io::Image picture = syntheticPicture(truth);
    const ImageMarks marks = marksOf(picture, known(truth));
    ASSERT_TRUE(marks.chatter_marks);
    EXPECT_TRUE(marks.unrolled);
    EXPECT_TRUE(marks.chatter_marks->m_certain);
    EXPECT_EQ(marks.chatter_marks->m, 11);
    EXPECT_NEAR(*marks.chatter_marks->frequency_hz, 361, 0.3);
    EXPECT_NEAR(*marks.chatter_marks->frequency_uncertainty_hz, 1.8, 0.1);  // half a percent of the speed

    SurfaceParameters nothing_known = known(truth);  // both signs of ν are listed, the usual one first
    nothing_known.feed_direction_deg.reset();
    nothing_known.cut_direction = CutDirection::Unknown;
    const SurfaceResult both = findSurfaceMarks({{"a", picture}}, nothing_known);
    EXPECT_TRUE(contains(both.notes, notes::directionsUnknown));
    EXPECT_NEAR(both.images[0].chatter_marks->candidates_hz.at(0), 361, 0.3);
    EXPECT_NEAR(both.images[0].chatter_marks->candidates_hz.at(1), 378.2, 0.5);
}

io::Image mirrored(const io::Image& image)
{
    io::Image result = image;
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x)
            result.grey[static_cast<std::size_t>(y * image.width + x)] = image.at(x, image.height - 1 - y);
    return result;
}

io::Image turnedQuarter(const io::Image& image)  // x becomes y
{
    io::Image result = image;
    std::swap(result.width, result.height);
    for (int y = 0; y < result.height; ++y)
        for (int x = 0; x < result.width; ++x)
            result.grey[static_cast<std::size_t>(y * result.width + x)] = image.at(y, image.height - 1 - x);
    return result;
}

TEST(Surface, MirrorTurnAndBrightness)
{
    SyntheticParameters truth = overview(2);
    truth.amplitude_um = 2 * theoreticalDepth_um(truth);
    const io::Image picture = syntheticPicture(truth);
    const ImageMarks plain = marksOf(picture, known(truth));
    ASSERT_TRUE(plain.chatter_marks);

    const ImageMarks flipped = marksOf(mirrored(picture), known(truth));
    EXPECT_NEAR(flipped.chatter_marks->nu, -plain.chatter_marks->nu, 2e-3);
    EXPECT_EQ(flipped.chatter_marks->kind, ChatterKind::Forced);

    SurfaceParameters upright = known(truth);
    *upright.feed_direction_deg += 90;
    const ImageMarks quarter = marksOf(turnedQuarter(picture), upright);
    EXPECT_NEAR(*quarter.chatter_marks->frequency_hz, *plain.chatter_marks->frequency_hz, 0.1);
    EXPECT_NEAR(quarter.feed_marks->pitch_px, plain.feed_marks->pitch_px, 1e-3 * plain.feed_marks->pitch_px);

    io::Image pale = picture;
    for (float& value : pale.grey) value = 0.6F * value + 20.0F / 255;
    const ImageMarks same = marksOf(pale, known(truth));
    EXPECT_NEAR(*same.chatter_marks->frequency_hz, *plain.chatter_marks->frequency_hz, 0.1);
    EXPECT_EQ(same.verdict, plain.verdict);
}

TEST(Surface, SixteenBitsSayTheSame)
{
    SyntheticParameters truth = smallField(4);
    const ImageMarks eight = marksOf(syntheticPicture(truth), known(truth));
    truth.bits = 16;
    const ImageMarks sixteen = marksOf(syntheticPicture(truth), known(truth));
    EXPECT_NEAR(sixteen.feed_marks->pitch_px, eight.feed_marks->pitch_px, 1e-3 * eight.feed_marks->pitch_px);
}

TEST(Surface, ScaleComesFromWhereItIsSaid)
{
    const SyntheticParameters truth = smallField(5);
    const io::Image picture = syntheticPicture(truth);
    SurfaceParameters p = known(truth);
    p.mm_per_px.reset();
    p.scale_px_mm = "500:3";
    EXPECT_NEAR(*marksOf(picture, p).feed_marks->pitch_mm, 0.1, 5e-4);
    p.scale_px_mm.clear();
    p.scale_from_feed = true;
    const SurfaceResult from_feed = findSurfaceMarks({{"a", picture}}, p);
    EXPECT_NEAR(*from_feed.images[0].mm_per_px, 0.006, 3e-5);
    EXPECT_TRUE(contains(from_feed.notes, notes::scaleFromFeed));
    p.scale_from_feed = false;
    const SurfaceResult none = findSurfaceMarks({{"a", picture}}, p);
    EXPECT_FALSE(none.images[0].feed_marks->pitch_mm);
    EXPECT_TRUE(contains(none.notes, notes::scaleUnknown));
    p.mm_per_px = 0.00625;  // 4 % too large
    EXPECT_TRUE(contains(findSurfaceMarks({{"a", picture}}, p).notes, notes::pitchDiffersFromFeed));
}

template <class Run>
const char* refusalOf(Run run)
{
    try {
        run();
    } catch (const Error& error) {
        return error.code().key;
    }
    return "";
}

TEST(Surface, RefusesWhatItCannotSee)
{
    const SyntheticParameters truth = smallField(6);
    const io::Image picture = syntheticPicture(truth);
    SurfaceParameters p = known(truth);
    p.mm_per_px = 0.03;  // 3.3 px per feed by the stated scale
    EXPECT_STREQ(refusalOf([&] { marksOf(picture, p); }), errors::feedNotResolved.key);
    p = known(truth);
    p.roi = {{0, 0, 200, 100}};
    EXPECT_STREQ(refusalOf([&] { marksOf(picture, p); }), errors::pictureTooSmall.key);
    p.roi = {{600, 0, 200, 200}};
    EXPECT_STREQ(refusalOf([&] { marksOf(picture, p); }), errors::regionOutside.key);
    p = known(truth);
    p.scale_from_feed = true;
    EXPECT_STREQ(refusalOf([&] { marksOf(picture, p); }), errors::valueNotUnderstood.key);
    p = known(truth);
    p.speed_rpm = {{100}, {200}};
    EXPECT_STREQ(refusalOf([&] { marksOf(picture, p); }), errors::valueNotUnderstood.key);
    p = known(truth);
    p.unroll = "sideways";
    EXPECT_STREQ(refusalOf([&] { marksOf(picture, p); }), errors::valueNotUnderstood.key);
}

TEST(Surface, BeforeAndAfter)
{
    SyntheticParameters before = smallField(7), after = smallField(8);
    before.amplitude_um = 2 * theoreticalDepth_um(before);
    after.speed_rpm = 2154;
    SurfaceParameters p = known(before);
    p.speed_rpm = {{2016}, {2154}};
    const SurfaceResult result =
        findSurfaceMarks({{"before", syntheticPicture(before)}, {"after", syntheticPicture(after)}}, p);
    ASSERT_TRUE(result.comparison);
    EXPECT_TRUE(result.comparison->same_scale);
    EXPECT_FALSE(result.comparison->registered);
    EXPECT_LT(result.comparison->registration_response, 0.3);
    EXPECT_TRUE(result.comparison->relative_to_feed.at(0));
    EXPECT_FALSE(result.comparison->relative_to_feed.at(1));
    EXPECT_EQ(*result.images[1].speed_rpm, 2154);
    EXPECT_TRUE(contains(result.notes, notes::sameLightingAssumed));

    const SurfaceResult twice =
        findSurfaceMarks({{"a", syntheticPicture(after)}, {"b", syntheticPicture(after)}}, known(after));
    EXPECT_TRUE(twice.comparison->registered);
}

/// No figure of roughness in any key of the result.
TEST(Surface, NoRoughness)
{
    const SyntheticParameters truth = smallField(9);
    const SurfaceResult result = findSurfaceMarks({{"a", syntheticPicture(truth)}}, known(truth));
    for (const auto& [name, value] : describedValues(result.images[0])) {
        EXPECT_EQ(name.find("rough"), std::string::npos) << name;
        EXPECT_EQ(name.find("_um"), std::string::npos) << name;
    }
    EXPECT_FALSE(surfaceReport(result).sections.empty());
}

}  // namespace
}  // namespace lathelier::surface
