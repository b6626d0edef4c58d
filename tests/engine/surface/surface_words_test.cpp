// Stripes on the crests of a wave, and the sentences about a picture.
#include "engine/surface/surface_words.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "engine/core/texts.h"
#include "engine/report/html.h"
#include "engine/surface/stripes.h"
#include "engine/surface/surface_pictures.h"
#include "engine/surface/surface_plots.h"
#include "engine/surface/surface_report.h"
#include "engine/surface/synthetic.h"

namespace lathelier::surface {
namespace {

std::string englishText(const report::Paragraph& paragraph)
{
    return fill(paragraph.pattern.english, paragraph.values);
}

ImageMarks marksWithNu(double nu, ChatterKind kind)
{
    ImageMarks image;
    image.speed_rpm = 2016;
    image.feed_direction_deg = 0;
    image.feed_marks.emplace();
    image.chatter_marks.emplace();
    ChatterMarks& chatter = *image.chatter_marks;
    chatter.nu = nu;
    chatter.m = 11;
    chatter.kind = kind;
    chatter.frequency_hz = 2016.0 / 60 * (11 + nu);
    chatter.frequency_uncertainty_hz = 1.8;
    chatter.phase_deg = phase_deg(nu);
    chatter.candidates_hz = {*chatter.frequency_hz};
    image.verdict = MarksVerdict::ChatterMarks;
    return image;
}

SurfaceParameters knownDirections()
{
    SurfaceParameters p;
    p.feed_direction_deg = 0;
    p.cut_direction = CutDirection::Down;
    return p;
}

TEST(Stripes, StandOnTheCrestsOfTheWave)
{
    const Vector frequency{0.031, -0.012};
    const double phase = 0.37;
    Grid grid(300, 200);
    for (int y = 0; y < grid.rows; ++y)
        for (int x = 0; x < grid.columns; ++x)
            grid.row(y)[x] =
                static_cast<float>(std::cos(2 * std::numbers::pi * (frequency.x * x + frequency.y * y + phase)));
    EXPECT_NEAR(phaseOf(grid, frequency), phase, 0.002);
    const auto stripes = stripesOf(frequency, phase, grid.columns, grid.rows);
    // From corner to corner the wave has |k|·(width, height) turns.
    EXPECT_NEAR(static_cast<double>(stripes.size()), 0.031 * 300 + 0.012 * 200, 1.01);
    for (const auto& [a, b] : stripes)
        for (const Vector& end : {a, b}) {
            EXPECT_GE(end.x, -1e-9);
            EXPECT_LE(end.x, grid.columns + 1e-9);
            EXPECT_GE(end.y, -1e-9);
            EXPECT_LE(end.y, grid.rows + 1e-9);
            const double turns = dot(frequency, end - Vector{0.5, 0.5}) + phase;
            EXPECT_NEAR(turns, std::round(turns), 1e-9);
        }
}

TEST(Stripes, OfNothingOrOfTooManyAreNone)
{
    EXPECT_TRUE(stripesOf({0, 0}, 0, 100, 100).empty());
    EXPECT_TRUE(stripesOf({0.5, 0}, 0, 1e5, 10).empty());
}

TEST(SurfaceWords, TheSpeedRelationCheckFollowsTheFractionOfAWave)
{
    EXPECT_EQ(speedRelationCheckOf(*marksWithNu(-0.256, ChatterKind::Regenerative).chatter_marks),
              SpeedRelationCheck::Exact);
    EXPECT_EQ(speedRelationCheckOf(*marksWithNu(-0.02, ChatterKind::Forced).chatter_marks),
              SpeedRelationCheck::Published);
    EXPECT_EQ(speedRelationCheckOf(*marksWithNu(0.25, ChatterKind::Forced).chatter_marks), SpeedRelationCheck::Neither);
    EXPECT_EQ(speedRelationCheckOf(*marksWithNu(-0.48, ChatterKind::Regenerative).chatter_marks),
              SpeedRelationCheck::Neither);
    const auto sentence = speedRelationSentence(marksWithNu(-0.256, ChatterKind::Regenerative), knownDirections());
    ASSERT_TRUE(sentence);
    EXPECT_NE(englishText(*sentence).find("ν = -0.256, axial period 3.9 f"), std::string::npos)
        << englishText(*sentence);
    // Without the directions the sign of ν is unknown.
    EXPECT_FALSE(speedRelationSentence(marksWithNu(-0.256, ChatterKind::Regenerative), {}));
}

TEST(SurfaceWords, WhatIsOpenIsNotDenied)
{
    SurfaceResult result;
    ImageMarks image = marksWithNu(-0.4, ChatterKind::Regenerative);
    image.chatter_marks.reset();
    image.detection_limit_relative_to_feed = 0.02;
    image.verdict = MarksVerdict::FeedMarks;
    result.images = {image, image};
    EXPECT_NE(englishText(beforeAndAfter(result, {}).front()).find("no chatter marks"), std::string::npos);
    result.images.front().verdict = MarksVerdict::Undecided;
    result.images.back().second_feed_marks.emplace();
    for (const report::Paragraph& sentence : beforeAndAfter(result, {}))
        EXPECT_EQ(englishText(sentence).find("no chatter marks"), std::string::npos);
    for (const ImageMarks& open : result.images) {
        const report::Answer said = answer(open);
        EXPECT_NE(std::string(said.sentence.english).find("is open"), std::string::npos);
        EXPECT_NE(std::string(said.verdict_words.english).find("undecided"), std::string::npos);
    }
}

TEST(SurfaceWords, ForcedOrRegenerative)
{
    EXPECT_NE(englishText(*originSentence(marksWithNu(0.02, ChatterKind::Forced))).find("Forced or regenerative?"),
              std::string::npos);
    EXPECT_NE(englishText(*originSentence(marksWithNu(-0.256, ChatterKind::Regenerative))).find("ε = 268°"),
              std::string::npos);
}

TEST(SurfaceWords, SpeedsWithWholeWavesStandAboutTheCut)
{
    const auto speeds = wholeWaveSpeeds(marksWithNu(-0.256, ChatterKind::Regenerative));
    ASSERT_EQ(speeds.size(), 4U);
    EXPECT_EQ(speeds[1].k, 11);
    EXPECT_NEAR(speeds[1].speed_rpm, 1969.1, 0.5);
    EXPECT_EQ(speeds[2].k, 10);
    EXPECT_NEAR(speeds[2].speed_rpm, 2166, 0.5);
    EXPECT_LT(speeds[1].speed_rpm, 2016);
    EXPECT_GT(speeds[2].speed_rpm, 2016);
}

TEST(SurfaceWords, ReportOfBeforeAndAfter)
{
    SyntheticParameters p;
    p.width = 420;
    p.height = 320;
    p.amplitude_um = 9;
    NamedImage before{"before.png", syntheticPicture(p)};
    p.amplitude_um = 0;
    p.speed_rpm = 2154;
    p.seed = 2;
    NamedImage after{"after.png", syntheticPicture(p)};
    SurfaceParameters q = knownDirections();
    q.feed_mm_rev = 0.1;
    q.diameter_mm = 30;
    q.mm_per_px = 0.006;
    q.speed_rpm = {{2016}, {2154}};
    const SurfaceResult result = findSurfaceMarks({before, after}, q);
    ASSERT_TRUE(result.images[0].chatter_marks);
    const auto& view = result.images[0].view;
    ASSERT_TRUE(view.feed && view.bands);
    // The bands lie within half a feed line of zero along the feed, and are ν/f away from it.
    EXPECT_NEAR(std::abs(dot(*view.bands, *view.feed) / dot(*view.feed, *view.feed)),
                std::abs(result.images[0].chatter_marks->nu), 0.01);
    const auto words = beforeAndAfter(result);
    ASSERT_EQ(words.size(), 2U);
    EXPECT_NE(englishText(words[0]).find("Before, 2016 rpm: marks of"), std::string::npos);
    EXPECT_NE(englishText(words[1]).find("After, 2154 rpm: no chatter marks above"), std::string::npos);
    EXPECT_NE(englishText(*alignmentSentence(result)).find("not registered"), std::string::npos);
    EXPECT_NE(englishText(*certaintySentence(result.images[0])).find("is not"), std::string::npos);
    const std::string html = toHtml(surfaceReport(result));
    EXPECT_NE(html.find("cannot tell heights"), std::string::npos);
    EXPECT_EQ(html.find("Ra "), std::string::npos);
    EXPECT_TRUE(comparisonSvg(result, {"a", "b"}).starts_with("<svg"));
}

TEST(SurfacePlots, LinesAreNamedAndFoundAgain)
{
    EXPECT_EQ(nameOf({{}, true, 1, 0, {}}), "f");
    EXPECT_EQ(nameOf({{}, true, 3, 0, {}}), "3 f");
    EXPECT_EQ(nameOf({{}, false, 1, 0, {}}), "c");
    EXPECT_EQ(nameOf({{}, false, 2, 1, {}}), "2 c + f");
    ImageMarks image;
    image.threshold = 18;
    image.view.spectrum_edge = 0.4;
    image.view.lines = {{{0.1, 0}, true, 1, 0, 500.0}, {{0.075, 0.02}, false, 1, 0, 90.0}};
    EXPECT_EQ(lineAt(image, 0.1, 0), 0);
    EXPECT_EQ(lineAt(image, -0.1, 0), 0);       // the opposite
    EXPECT_EQ(lineAt(image, 0.075, -0.02), 1);  // upward is positive there
    EXPECT_EQ(lineAt(image, 0.3, 0.3), -1);
    const report::Plot plot = linesOverNoise(image);
    ASSERT_EQ(plot.curves.size(), 2U);
    EXPECT_EQ(plot.curves[0].y[0], 500);
    EXPECT_EQ(plot.limits.back().place, 18);
}

}  // namespace
}  // namespace lathelier::surface
