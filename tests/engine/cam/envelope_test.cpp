// The nose-centre curve and its residual material, against closed forms and properties.
#include "engine/cam/envelope.h"

#include <gtest/gtest.h>

#include <cmath>

#include "engine/cam/reach.h"
#include "engine/cam/work_frame.h"
#include "engine/core/units.h"
#include "tests/engine/cam/plan_data.h"

namespace lathelier::cam {
namespace {

HeightContour contourOf(std::vector<ShaftSegment> rows)
{
    Shaft shaft;
    shaft.segments = std::move(rows);
    return heightContour(shaft);
}

std::vector<Unreached> leftBy(const HeightContour& contour, const ToolWedge& tool)
{
    return restOf(contour, {{1, noseCurve(contour, tool), tool.radius_mm, 0}});
}

/// Clearance of the drawing's points from the curve's disc: never negative for a correct curve.
double worstGouge(const HeightContour& contour, const Curve& curve, double radius)
{
    double worst = 0;
    for (const ContourPiece& piece : contour.pieces)
        for (int i = 0; i <= 200; ++i) {
            Eigen::Vector2d point = piece.from_mm + i / 200.0 * (piece.to_mm - piece.from_mm);
            if (piece.isArc()) {
                const auto [start, end] = piece.arcAngles();
                const double angle = start + i / 200.0 * (end - start);
                point = piece.centre_mm() +
                        std::abs(piece.arc_radius_mm) * Eigen::Vector2d(std::cos(angle), std::sin(angle));
            }
            worst = std::max(worst, radius - distanceTo(curve, point, 1e4));
        }
    return worst;
}

TEST(NoseCurve, CornerKeepsWhatItsRadiusSays)
{
    const auto square = leftBy(contourOf({row(20, 20, 20), row(20, 40, 40)}), {0.4, 90, 90});
    ASSERT_EQ(square.size(), 1U);
    EXPECT_NEAR(square[0].left_mm, 0.4 * (std::sqrt(2.0) - 1), 1e-6);
    EXPECT_NEAR(square[0].z_end_mm, 20, 1e-6);
    EXPECT_EQ(square[0].cause, RestCause::NoseRadius);
    // A cone of 18.43° into a cylinder.
    const auto kink = leftBy(contourOf({row(12, 28, 20), row(10, 20, 20)}), {0.4, 30, 93});
    ASSERT_EQ(kink.size(), 1U);
    EXPECT_NEAR(kink[0].left_mm, 0.4 * (1 / std::cos(std::atan2(4.0, 12.0) / 2) - 1), 1e-6);
}

TEST(NoseCurve, StepDownLeavesTheShadowOfTheBackEdge)
{
    struct Case {
        double entering, tip, length, height;
    };
    for (const Case& tool : {Case{95, 80, 30.53, 1.5978}, Case{93, 55, 2.77, 1.3856}, Case{93, 35, 1.34, 1.0285}}) {
        const double back = 180 - tool.entering - tool.tip - 2;
        const auto rest = leftBy(contourOf({row(20, 37, 37), row(60, 33.8, 33.8)}), {0.4, back, tool.entering});
        ASSERT_EQ(rest.size(), 1U);
        EXPECT_EQ(rest[0].cause, RestCause::BackAngle);
        EXPECT_NEAR(rest[0].left_mm, 1.6 * std::cos(back * rad_per_deg), 2e-3);
        EXPECT_NEAR(rest[0].left_mm, tool.height, 2e-3);
        EXPECT_NEAR(rest[0].z_start_mm, 20, 1e-6);
        // Up to where the nose touches the floor, less what is below the threshold.
        const double touch = 20 + 1.6 / std::tan(back * rad_per_deg) + 0.4 * std::tan(back * rad_per_deg / 2);
        EXPECT_LT(rest[0].z_end_mm, touch);
        EXPECT_GT(rest[0].z_end_mm, touch - 0.15);
    }
}

TEST(NoseCurve, LeadingAngleLeavesAConeAtAShoulder)
{
    const auto rest = leftBy(contourOf({row(20, 20, 20), row(20, 40, 40)}), {0.8, 15, 75});
    ASSERT_EQ(rest.size(), 1U);
    EXPECT_EQ(rest[0].cause, RestCause::LeadingAngle);
    // The foot of the wall from the edge that lies on its top.
    EXPECT_NEAR(rest[0].left_mm, 10 * std::cos(75 * rad_per_deg), 0.25);
}

TEST(NoseCurve, PaperShaftAsTheReferenceHasIt)
{
    const Job job = paperJob({roughC80(), finishC80()});
    const WorkFrame frame = frameOf(job, *job.shaft);
    const auto rest = restOf(frame.contour, {reachOf(frame, job.tools[1])});
    ASSERT_EQ(rest.size(), 3U);
    const double expected[3][3]{{97.65, 98.0, 0.1657}, {108.0, 138.47, 1.5979}, {178.0, 183.0, 4.7385}};
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_NEAR(rest[i].z_start_mm, expected[i][0], 0.05);
        EXPECT_NEAR(rest[i].z_end_mm, expected[i][1], 0.05);
        EXPECT_NEAR(rest[i].left_mm, expected[i][2], 0.002);
    }
}

TEST(NoseCurve, BladeLeavesItsCorners)
{
    const HeightContour groove = contourOf({row(20, 30, 30), row(5, 24, 24), row(20, 30, 30)});
    const Curve curve = bladeCurve(groove, 0.2, 2.6);
    const auto rest = restOf(groove, {{8, curve, 0.2, 2.6}});
    ASSERT_EQ(rest.size(), 2U);
    for (const Unreached& corner : rest) {
        EXPECT_NEAR(corner.left_mm, 0.2 * (std::sqrt(2.0) - 1), 1e-6);
        EXPECT_EQ(corner.cause, RestCause::Blade);
    }
    // A groove narrower than the blade stays closed.
    const HeightContour narrow = contourOf({row(20, 30, 30), row(2, 24, 24), row(20, 30, 30)});
    const auto closed = restOf(narrow, {{8, bladeCurve(narrow, 0.2, 2.6), 0.2, 2.6}});
    ASSERT_EQ(closed.size(), 1U);
    EXPECT_NEAR(closed[0].left_mm, 3, 1e-6);
}

TEST(NoseCurve, NeverGougesRandomShafts)
{
    std::mt19937 random(7);
    const ToolWedge tools[]{{0.8, 3, 95}, {0.4, 30, 93}, {0.4, 50, 93}, {0.8, 13, 75}, {1.2, 90, 90}};
    for (int i = 0; i < 400; ++i) {
        const HeightContour contour = heightContour(randomShaft(random));
        for (const ToolWedge& tool : tools) {
            const Curve curve = noseCurve(contour, tool);
            EXPECT_LT(worstGouge(contour, curve, tool.radius_mm), 1e-9);
            for (std::size_t k = 1; k < curve.size(); ++k) EXPECT_LT((curve[k].from - curve[k - 1].to).norm(), 2e-9);
        }
    }
}

TEST(NoseCurve, TouchesWhereNothingIsLeft)
{
    // The curve is minimal: every piece except rays, bridges and joins touches the drawing.
    std::mt19937 random(8);
    for (int i = 0; i < 100; ++i) {
        const HeightContour contour = heightContour(randomShaft(random));
        const Curve curve = noseCurve(contour, {0.4, 30, 93});
        for (const CurvePiece& piece : curve) {
            if (piece.touch != Touch::Element && piece.touch != Touch::Vertex) continue;
            const Eigen::Vector2d middle = piece.point(0.5);
            double nearest = 1e9;
            for (const ContourPiece& drawn : contour.pieces) {
                CurvePiece part;
                part.from = drawn.from_mm;
                part.to = drawn.to_mm;
                if (drawn.isArc()) {
                    part.centre = drawn.centre_mm();
                    part.radius_mm = drawn.arc_radius_mm;
                }
                nearest = std::min(nearest, part.distanceTo(middle));
            }
            EXPECT_NEAR(nearest, 0.4, 1e-9);
        }
    }
}

TEST(NoseCurve, MirroredShaftHasTheMirroredCurve)
{
    std::mt19937 random(9);
    for (int i = 0; i < 50; ++i) {
        const HeightContour contour = heightContour(randomShaft(random));
        // Without edges both hands give the same curve.
        const Curve there = noseCurve(contour, {0.4, 90, 90});
        const Curve back = mirrored(noseCurve(mirrored(contour), {0.4, 90, 90}), contour.length_mm);
        for (int k = 1; k < 50; ++k) {
            const double u = contour.length_mm * (k + 0.37) / 51;
            EXPECT_NEAR(heightAt(there, u), heightAt(back, u), 1e-9);
        }
    }
}

TEST(NoseCurve, ScalesWithEverything)
{
    std::mt19937 random(10);
    for (int i = 0; i < 50; ++i) {
        Shaft shaft = randomShaft(random);
        const HeightContour small = heightContour(shaft);
        for (ShaftSegment& segment : shaft.segments) {
            segment.length_mm *= 3;
            segment.start_diameter_mm *= 3;
            segment.end_diameter_mm *= 3;
            if (segment.arc_radius_mm) *segment.arc_radius_mm *= 3;
        }
        const HeightContour large = heightContour(shaft);
        const Curve a = noseCurve(small, {0.4, 30, 93}), b = noseCurve(large, {1.2, 30, 93});
        for (int k = 1; k < 50; ++k) {
            const double u = small.length_mm * (k + 0.37) / 51;
            EXPECT_NEAR(3 * heightAt(a, u), heightAt(b, 3 * u), 1e-8);
        }
    }
}

}  // namespace
}  // namespace lathelier::cam
