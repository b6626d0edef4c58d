// Curved fields, their scale from the feed, coarse pictures, and ambiguous readings.
#include <gtest/gtest.h>

#include <cmath>

#include "engine/core/error.h"
#include "engine/surface/chatter_reading.h"
#include "engine/surface/surface_codes.h"
#include "engine/surface/surface_words.h"
#include "tests/engine/surface/pictures.h"

namespace lathelier::surface {
namespace {

using namespace test;

SyntheticParameters chatteringOverview(int seed)
{
    SyntheticParameters truth = overview(seed);
    truth.amplitude_um = 2.5 * theoreticalDepth_um(truth);
    return truth;
}

/// Several waves are visible, but their number per revolution remains unknown.
TEST(CurvedField, ThatIsNotUnrolledIsNeverCertain)
{
    const SyntheticParameters truth = chatteringOverview(3);
    const io::Image picture = syntheticPicture(truth);
    SurfaceParameters p = known(truth);
    p.unroll = "no";
    const SurfaceResult result = findSurfaceMarks({{"a", picture}}, p);
    const ImageMarks& marks = result.images.front();
    ASSERT_TRUE(marks.chatter_marks);
    EXPECT_TRUE(marks.curved);
    EXPECT_FALSE(marks.unrolled);
    EXPECT_GT(*marks.chatter_marks->waves_in_view, 2);
    EXPECT_FALSE(marks.chatter_marks->m_certain);
    EXPECT_GT(marks.chatter_marks->candidates_hz.size(), 1U);
    EXPECT_TRUE(contains(result.notes, notes::curvatureIgnored));
    EXPECT_FALSE(contains(result.notes, notes::wavesUncertain));  // there are enough of them
    const auto sentence = certaintySentence(marks);
    ASSERT_TRUE(sentence);
    EXPECT_NE(std::string(sentence->pattern.english).find("curves away"), std::string::npos);

    const ImageMarks unrolled = marksOf(picture, known(truth));
    EXPECT_TRUE(unrolled.unrolled && !unrolled.curved && unrolled.chatter_marks->m_certain);
}

TEST(CurvedField, IsUnrolledWithTheScaleFromTheFeed)
{
    const SyntheticParameters truth = chatteringOverview(4);
    SurfaceParameters p = known(truth);
    p.mm_per_px.reset();
    p.scale_from_feed = true;
    const ImageMarks marks = marksOf(syntheticPicture(truth), p);
    ASSERT_TRUE(marks.chatter_marks);
    EXPECT_TRUE(marks.unrolled);
    EXPECT_EQ(marks.mm_per_px_source, ScaleSource::Feed);
    EXPECT_NEAR(*marks.mm_per_px, truth.mm_per_px, 0.005 * truth.mm_per_px);
    EXPECT_TRUE(marks.chatter_marks->m_certain);
    EXPECT_NEAR(*marks.chatter_marks->frequency_hz, 361, 0.3);

    // Without a direction the feed line is ambiguous: no certainty.
    p.feed_direction_deg.reset();
    const ImageMarks open = marksOf(syntheticPicture(truth), p);
    EXPECT_TRUE(!open.chatter_marks || !open.chatter_marks->m_certain);
}

TEST(CurvedField, WithoutMarksAndDirectionIsSaidToStay)
{
    SyntheticParameters truth = overview(5);
    truth.feed_mm_rev = 0.05;  // finer than the pixels, under noise: nothing periodic is left
    truth.irregular = 1;
    truth.noise = 0.5;
    truth.grooves = 0;
    SurfaceParameters p = known(truth);
    p.feed_mm_rev = 0.2;
    p.feed_direction_deg.reset();
    const SurfaceResult result = findSurfaceMarks({{"a", syntheticPicture(truth)}}, p);
    ASSERT_EQ(result.images.front().verdict, MarksVerdict::NoPeriodicMarks);
    EXPECT_TRUE(result.images.front().curved);
    EXPECT_TRUE(contains(result.notes, notes::axisUnknown));
}

Error refusal(const SyntheticParameters& truth)
{
    try {
        marksOf(syntheticPicture(truth), known(truth));
    } catch (const Error& error) {
        return error;
    }
    ADD_FAILURE() << "was evaluated";
    return {errors::pictureTooSmall, {}};
}

SyntheticParameters coarse(double px_per_feed)
{
    SyntheticParameters truth = smallField(6);
    truth.mm_per_px = truth.feed_mm_rev / px_per_feed;
    truth.width = truth.height = 400;
    truth.diameter_mm = 300;  // flat
    truth.feed_direction_deg = 0;
    truth.blur_px = 0;
    truth.noise = 0.01;
    truth.grooves = 0.02;
    return truth;
}

/// Below two pixels per feed the visible marks are aliases; from two on they are the true marks.
TEST(CoarsePicture, AnAliasIsToldFromTheMarks)
{
    const Error aliased = refusal(coarse(1.45));  // 0.69 cycles per pixel are seen as 0.31
    EXPECT_EQ(aliased.code(), errors::feedAliased);
    const Value* const alias = find(aliased.values(), "alias_px");
    ASSERT_TRUE(alias);
    EXPECT_NEAR(std::get<double>(*alias), 1 / (1 - 1 / 1.45), 0.1);
    EXPECT_EQ(refusal(coarse(3.3)).code(), errors::feedNotResolved);
    EXPECT_EQ(refusal(coarse(2.4)).code(), errors::feedNotResolved);
}

/// |ν| above ¼ with the sign open: n (m + ν) and n (m + 1 - |ν|)…: the nearest of all readings, including unlisted
/// ones.
TEST(Readings, TheNearestOtherIsThatOfAllReadings)
{
    ChatterLattice lattice;
    FeedComb feed;
    feed.frequency = {1 / 20.0, 0};
    feed.amplitude = 1;
    CutFacts facts;
    facts.feed_mm_rev = 0.1;
    facts.diameter_mm = 30;
    facts.diameter_px = 30 / 0.005;
    facts.speed_rpm = 1800;  // n = 30
    facts.columns = facts.rows = 600;
    const double nu = -0.4, m = 11;
    const Vector z = axisDirection(feed.frequency, 0.1, 30, CutDirection::Down), y = turned(z, 90);
    const double along = dot(feed.frequency, z);
    lattice.fundamental = (nu * along) * z + (m / (3.14159265358979 * *facts.diameter_px)) * y;
    lattice.significance = 500;
    lattice.amplitude = 0.5;
    lattice.lines.push_back({1, 0, lattice.fundamental, 500, 0.5});
    Notes notes;
    const ChatterMarks open = readChatter(lattice, feed, facts, "a", notes);
    EXPECT_FALSE(open.m_certain);
    EXPECT_NEAR(*open.nearest_other_hz, 30 * (1 - 2 * 0.4), 0.1);
    facts.feed_direction_deg = 0;
    facts.cut = CutDirection::Down;
    const ChatterMarks determined = readChatter(lattice, feed, facts, "a", notes);
    EXPECT_NEAR(determined.nu, nu, 1e-3);
    EXPECT_NEAR(*determined.nearest_other_hz, 30, 0.1);
}

/// Speeds: one may be unknown, and each picture may have its own scale and direction.
TEST(OwnValues, OfEachPicture)
{
    SyntheticParameters before = smallField(7), after = smallField(8);
    before.width = after.width = 420;
    before.height = after.height = 320;
    before.amplitude_um = 2 * theoreticalDepth_um(before);
    after.mm_per_px = 0.008;
    after.feed_direction_deg = -6;
    SurfaceParameters p = known(before);
    p.speed_rpm = {{0}, {2154}};
    NamedImage second{"after", syntheticPicture(after)};
    second.mm_per_px = 0.008;
    second.feed_direction_deg = -6;
    const SurfaceResult result = findSurfaceMarks({{"before", syntheticPicture(before)}, second}, p);
    ASSERT_TRUE(result.images[0].chatter_marks);
    EXPECT_FALSE(result.images[0].speed_rpm);
    EXPECT_FALSE(result.images[0].chatter_marks->frequency_hz);
    EXPECT_EQ(*result.images[1].speed_rpm, 2154);
    EXPECT_EQ(*result.images[1].mm_per_px, 0.008);
    EXPECT_EQ(*result.images[1].feed_direction_deg, -6);
    EXPECT_LT(std::abs(*result.images[1].feed_marks->pitch_error_percent), 0.5);
    EXPECT_EQ(*result.images[0].mm_per_px, 0.006);
}

}  // namespace
}  // namespace lathelier::surface
