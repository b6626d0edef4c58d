// Stretches that are not round: named with their sizes where one shape explains them, else left as they are.
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <numbers>

#include "engine/core/random.h"
#include "engine/features/stretches/eccentric_fit.h"
#include "engine/features/stretches/helix_fit.h"
#include "engine/features/stretches/prism_fit.h"
#include "engine/features/stretches/spline_fit.h"
#include "shaped_scan.h"

namespace lathelier::features {
namespace {

constexpr double halfTurn = std::numbers::pi;

Recognition recognizedAs(const Shape& shape, std::uint64_t seed = 1)
{
    return recognize(shapedScan(collarPart(), coarser(seed), shape), {});
}

const ShaftMark* onlyMark(const Recognition& result, MarkKind kind)
{
    return result.marks.size() == 1 && result.marks.front().kind == kind ? &result.marks.front() : nullptr;
}

/// The row at z.
const RecognizedRow& rowAt(const Recognition& result, double z_mm)
{
    return *std::find_if(result.segments.begin(), result.segments.end(),
                         [&](const RecognizedRow& row) { return row.z_end_mm > z_mm; });
}

void expectDiameter(const Recognition& result, double z_mm, double diameter_mm)
{
    const RecognizedRow& row = rowAt(result, z_mm);
    EXPECT_NEAR(row.start_diameter_mm, diameter_mm, 2e-3 * *row.uncertainty.start_diameter_um + 1e-3) << z_mm;
}

/// Distance of a ray at this angle from the axis to a circle of radius R at an offset along angle 0.
double onCircle_mm(double offset_mm, double radius_mm, double angle_rad)
{
    const double side = offset_mm * std::sin(angle_rad);
    return offset_mm * std::cos(angle_rad) + std::sqrt(radius_mm * radius_mm - side * side);
}

/// The same to a regular polygon with a face of this distance at angle 0.
double onPolygon_mm(int faces, double face_mm, double angle_rad)
{
    const double step = 2 * halfTurn / faces;
    return face_mm / std::cos(std::remainder(angle_rad, step));
}

/// A prism cut into the first part of the collar part, with the noise of the scan.
double cutTo_mm(const AroundPoint& p, double prism_mm)
{
    const double noise_mm = p.r_mm - (p.z_mm < 1 ? 11.5 + p.z_mm : 12.5);
    return std::min(p.r_mm, prism_mm + noise_mm);
}

/// Points with noise of a section that is the same along z.
template <class Radius>
StretchPoints madePoints(const Radius& radius, double sigma_mm = 0.02)
{
    StretchPoints points;
    points.sigma_mm = sigma_mm;
    constexpr std::uint64_t count = 20000;
    for (std::uint64_t i = 0; i < count; ++i) {
        const double turn = (static_cast<double>(i % 400) + 0.5 * randomUniform(7, 2, i)) / 400.5;
        const double z = 0.3 * static_cast<double>(i / 400);
        points.turn.push_back(turn);
        points.z_mm.push_back(z);
        points.r_mm.push_back(radius(2 * halfTurn * turn, z) + sigma_mm * randomNormal(7, 1, i));
    }
    return points;
}

TEST(EccentricFit, FindsTheCircleOfACrankPinWhoseAxisIsOutside)
{
    StretchPoints points;
    points.sigma_mm = 0.02;
    for (std::uint64_t i = 0; i < 10000; ++i) {
        const double own = 2 * halfTurn * randomUniform(1, 0, i), r = 8 + 0.02 * randomNormal(1, 1, i);
        const double x = 12 * std::cos(2.0) + r * std::cos(own), y = 12 * std::sin(2.0) + r * std::sin(own);
        points.r_mm.push_back(std::hypot(x, y));
        const double turn = std::atan2(y, x) / (2 * halfTurn);
        points.turn.push_back(turn - std::floor(turn));
        points.z_mm.push_back(10 * randomUniform(1, 2, i));
    }
    const auto found = eccentricOf(points);
    ASSERT_TRUE(found);
    EXPECT_NEAR(*found->mark.offset_mm, 12, *found->mark.uncertainty_mm);
    EXPECT_LT(*found->mark.uncertainty_mm, 0.01);
    EXPECT_NEAR(*found->mark.diameter_mm, 16, 0.002);
    EXPECT_NEAR(*found->mark.angle_deg, 2.0 * 180 / halfTurn, 0.02);
}

TEST(EccentricFit, AnEllipseAndABentStretchAreNone)
{
    EXPECT_FALSE(eccentricOf(madePoints([](double a, double) { return 20 + 0.3 * std::cos(2 * a); })));
    EXPECT_FALSE(eccentricOf(madePoints([](double a, double) { return 20 + 0.1 * std::cos(a); })));
    EXPECT_FALSE(eccentricOf(madePoints([](double a, double z) { return onCircle_mm(0.2 + 0.02 * z, 20, a); })));
    EXPECT_TRUE(eccentricOf(madePoints([](double a, double) { return onCircle_mm(0.3, 20, a); })));
}

TEST(PrismFit, SizeAndDirectionOfHexagonAndSquare)
{
    for (const int faces : {6, 4}) {
        const auto found =
            prismOf(madePoints([&](double a, double) { return std::min(11.0, onPolygon_mm(faces, 9.5, a - 0.4)); }));
        ASSERT_TRUE(found) << faces;
        EXPECT_EQ(found->mark.kind, faces == 6 ? MarkKind::Hexagon : MarkKind::Square);
        EXPECT_NEAR(*found->mark.across_flats_mm, 19, *found->mark.uncertainty_mm);
        EXPECT_LT(*found->mark.uncertainty_mm, 0.02);
        EXPECT_NEAR(*found->mark.angle_deg, 0.4 * 180 / halfTurn, 0.1);
        EXPECT_NEAR(*found->mark.diameter_mm, faces == 6 ? 2 * 9.5 / std::cos(halfTurn / 6) : 22, 0.03);
    }
}

TEST(PrismFit, OtherPolygonsAndTwoFlatsAreNone)
{
    for (const int faces : {3, 5, 8, 12})
        EXPECT_FALSE(prismOf(madePoints([&](double a, double) { return std::min(12.0, onPolygon_mm(faces, 10, a)); })))
            << faces;
    EXPECT_FALSE(prismOf(madePoints([](double a, double) {
        return std::min({11.0, std::abs(std::cos(a)) > 0.5 ? 10 / std::abs(std::cos(a)) : 11.0});
    })));
    EXPECT_FALSE(prismOf(madePoints(  // twisted
        [](double a, double z) { return std::min(11.0, onPolygon_mm(6, 9.5, a - 0.02 * z)); })));
}

class Teeth : public testing::TestWithParam<int> {};

TEST_P(Teeth, NumberDiametersAndDirection)
{
    const int teeth = GetParam();
    const auto found = splineOf(madePoints([&](double a, double) {
        const double phase = std::remainder(teeth * (a - 0.03) / (2 * halfTurn), 1);
        return std::abs(phase) < 0.22 ? 30.0 : 28.5;
    }));
    ASSERT_TRUE(found);
    EXPECT_EQ(*found->mark.teeth, teeth);
    EXPECT_NEAR(*found->mark.major_mm, 60, *found->mark.uncertainty_mm);
    EXPECT_LT(*found->mark.uncertainty_mm, 0.03);
    EXPECT_NEAR(*found->mark.minor_mm, 57, 0.01);
    EXPECT_FALSE(found->mark.width_mm);
    EXPECT_NEAR(std::remainder(*found->mark.angle_deg - 0.03 * 180 / halfTurn, 360.0 / teeth), 0, 0.5);
}

INSTANTIATE_TEST_SUITE_P(Splines, Teeth, testing::Values(6, 7, 10, 24, 36, 60));

TEST(SplineFit, ParallelFlanksHaveAWidth)
{
    const auto found = splineOf(madePoints([](double a, double) {
        const double off = std::remainder(a - 0.3, 2 * halfTurn / 6), flank = 3 / std::abs(std::sin(off));
        return std::clamp(flank, 11.5, 14.0);
    }));
    ASSERT_TRUE(found);
    ASSERT_TRUE(found->mark.width_mm);
    EXPECT_NEAR(*found->mark.width_mm, 6, 0.03);
    EXPECT_NEAR(*found->mark.major_mm, 28, 0.01);
    EXPECT_NEAR(*found->mark.minor_mm, 23, 0.01);
}

TEST(SplineFit, LobesPolygonsAndAnOddToothAreNone)
{
    EXPECT_FALSE(splineOf(madePoints([](double a, double) { return 15 + 0.2 * std::cos(6 * a); })));
    EXPECT_FALSE(splineOf(madePoints([](double a, double) { return std::min(11.0, onPolygon_mm(6, 9.5, a)); })));
    EXPECT_FALSE(splineOf(madePoints([](double a, double) { return std::min(12.0, onPolygon_mm(8, 11, a)); })));
    EXPECT_FALSE(splineOf(madePoints([](double a, double) {
        const double phase = 8 * a / (2 * halfTurn);
        return phase > 1 && phase - std::floor(phase) < 0.5 ? 15.0 : 13.8;  // one tooth is missing
    })));
}

TEST(HelixFit, PitchStartsAndHandOfAWorm)
{
    for (const int starts : {1, 2})
        for (const double hand : {1.0, -1.0}) {
            const double pitch_mm = 2 * halfTurn;
            const auto found = helixOf(madePoints([&](double a, double z) {
                const double phase = std::remainder(hand * z / pitch_mm - starts * a / (2 * halfTurn), 1);
                return std::clamp(18 - (std::abs(phase) - 0.2) * 30, 13.6, 18.0);
            }));
            ASSERT_TRUE(found) << starts;
            EXPECT_NEAR(*found->mark.pitch_mm, pitch_mm, 0.01);
            EXPECT_EQ(*found->mark.starts, starts);
            EXPECT_EQ(*found->mark.hand, hand);
            EXPECT_NEAR(*found->mark.major_mm, 36, 0.02);
            EXPECT_EQ(found->mark.designation, "m 2");
        }
    EXPECT_FALSE(helixOf(madePoints([](double, double z) { return 18 - 3 * std::abs(std::remainder(z / 5, 1)); })))
        << "rings";
}

TEST(NotRound, AHexagonIsOneRowOverItsCorners)
{
    const Recognition result = recognizedAs([](const AroundPoint& p) {
        return p.z_mm > 5 && p.z_mm < 20 ? cutTo_mm(p, onPolygon_mm(6, 10.5, p.angle_rad)) : p.r_mm;
    });
    const ShaftMark* const mark = onlyMark(result, MarkKind::Hexagon);
    ASSERT_TRUE(mark);
    EXPECT_NEAR(*mark->across_flats_mm, 21, std::max(0.01, *mark->uncertainty_mm));
    EXPECT_NEAR(*mark->z_start_mm, 5, 0.3);
    EXPECT_NEAR(*mark->z_end_mm, 20, 0.3);
    EXPECT_TRUE(result.unexplained.empty());
    EXPECT_TRUE(result.bores.empty());
    expectDiameter(result, 10, 21 / std::cos(halfTurn / 6));
    expectDiameter(result, 30, 25);
    expectDiameter(result, 48, 40);
}

TEST(NotRound, ASquareWithTurnedCorners)
{
    const Recognition result = recognizedAs([](const AroundPoint& p) {
        return p.z_mm > 10 && p.z_mm < 30 ? cutTo_mm(p, onPolygon_mm(4, 10, p.angle_rad - 1)) : p.r_mm;
    });
    const ShaftMark* const mark = onlyMark(result, MarkKind::Square);
    ASSERT_TRUE(mark);
    EXPECT_NEAR(*mark->across_flats_mm, 20, std::max(0.01, *mark->uncertainty_mm));
    EXPECT_NEAR(*mark->z_start_mm, 10, 0.3);
    EXPECT_NEAR(*mark->z_end_mm, 30, 0.3);
    EXPECT_TRUE(result.unexplained.empty());
    expectDiameter(result, 20, 25);
}

/// What is cut beside an end of the collar part, with its chamfer 1 × 45° from Ø23 to Ø25.
struct CutEnd {
    const char* name;
    MarkKind kind;
    bool at_free;
    double chamfer_mm;  ///< length of what is left of the chamfer
    std::function<double(double)> radius_mm;
};

/// The radius of teeth over the angle; their crests are those of the bar.
std::function<double(double)> teethOf(int count, double root_mm)
{
    return [=](double angle_rad) {
        return std::abs(std::remainder(count * angle_rad / (2 * halfTurn), 1)) < 0.25 ? 99.0 : root_mm;
    };
}

class CutEnds : public testing::TestWithParam<CutEnd> {};

TEST_P(CutEnds, KeepTheirChamferAndTheirPlace)
{
    const CutEnd& cut = GetParam();
    const Recognition result = recognizedAs(
        [&](const AroundPoint& p) {
            if (!(cut.at_free ? p.z_mm < 20 : p.z_mm > 77)) return p.r_mm;
            const double wall_mm = 12.5 - std::max({0.0, 1 - p.z_mm, p.z_mm - 96});
            return std::min(p.r_mm, cut.radius_mm(p.angle_rad) + p.r_mm - wall_mm);
        },
        3);
    ASSERT_TRUE(onlyMark(result, cut.kind));
    const RecognizedEnd& end = cut.at_free ? result.ends.front() : result.ends.back();
    EXPECT_EQ(end.closed_by, cut.chamfer_mm > 0 ? "chamfer" : "edge");
    EXPECT_LT(end.uncertainty_mm, 0.05);
    EXPECT_NEAR(result.ends.back().z_mm, 97,
                std::hypot(result.ends.front().uncertainty_mm, result.ends.back().uncertainty_mm));
    const RecognizedRow& row = cut.at_free ? result.segments.front() : result.segments.back();
    if (!(cut.chamfer_mm > 0)) return;
    EXPECT_EQ(row.kind, RowKind::Cone);
    EXPECT_NEAR(row.z_end_mm - row.z_start_mm, cut.chamfer_mm, 0.06);
    EXPECT_NEAR(cut.at_free ? row.start_diameter_mm : row.end_diameter_mm, 23, 0.1);
}

INSTANTIATE_TEST_SUITE_P(NotRound, CutEnds,
                         testing::Values(CutEnd{"SquareWithTurnedCorners", MarkKind::Square, true, 1,
                                                [](double a) { return onPolygon_mm(4, 10, a - 1); }},
                                         CutEnd{"SquareAtTheChuck", MarkKind::Square, false, 1,
                                                [](double a) { return onPolygon_mm(4, 9, a - 1); }},
                                         CutEnd{"HexagonWithCornersCut", MarkKind::Hexagon, true,
                                                10.5 / std::cos(halfTurn / 6) - 11.5,
                                                [](double a) { return onPolygon_mm(6, 10.5, a); }},
                                         CutEnd{"HexagonWithinTheChamfer", MarkKind::Hexagon, true, 0,
                                                [](double a) { return onPolygon_mm(6, 9, a); }},
                                         CutEnd{"SplineWithRootsBelow", MarkKind::Spline, true, 1, teethOf(10, 10.5)},
                                         CutEnd{"SplineWithRootsCut", MarkKind::Spline, false, 1, teethOf(12, 11.8)}),
                         [](const testing::TestParamInfo<CutEnd>& one) { return one.param.name; });

/// Gaps that sink with the chamfer lie on no shape that is known: the end stays uncertain.
TEST(NotRound, AnEndThatIsNotExplainedIsUncertain)
{
    const Recognition result = recognizedAs([](const AroundPoint& p) {
        const bool is_gap = std::abs(std::remainder(8 * p.angle_rad / (2 * halfTurn), 1)) > 0.25;
        return p.z_mm < 20 && is_gap ? p.r_mm - 1.5 : p.r_mm;
    });
    ASSERT_TRUE(onlyMark(result, MarkKind::Spline));
    EXPECT_GT(result.ends.front().uncertainty_mm, 0.15);
    EXPECT_NEAR(result.ends.back().z_mm, 97, result.ends.front().uncertainty_mm);
}

/// A third of the area off the axis leaves an axis.
TEST(NotRound, AnEccentricOfAThirdOfTheAreaIsNamed)
{
    const sample::ShaftModel shaft{piece(0, 33, 25, 25), piece(33, 57, 33, 33), piece(57, 90, 25, 25)};
    const Scan scan = shapedScan(shaft, coarser(12), [](const AroundPoint& p) {
        return p.z_mm > 33 && p.z_mm < 57 ? onCircle_mm(1.5, p.r_mm, p.angle_rad) : p.r_mm;
    });
    const Recognition result = recognize(scan, {});
    const ShaftMark* const mark = onlyMark(result, MarkKind::Eccentric);
    ASSERT_TRUE(mark);
    EXPECT_NEAR(*mark->offset_mm, 1.5, *mark->uncertainty_mm);
    expectDiameter(result, 15, 25);
    expectDiameter(result, 75, 25);
}

TEST(NotRound, ATriangleStaysUnexplained)
{
    const Recognition result = recognizedAs(
        [](const AroundPoint& p) { return p.z_mm < 20 ? cutTo_mm(p, onPolygon_mm(3, 9, p.angle_rad)) : p.r_mm; });
    for (const ShaftMark& mark : result.marks) EXPECT_EQ(mark.kind, MarkKind::Flat);
    EXPECT_TRUE(!result.unexplained.empty() || result.marks.size() == 3);
    expectDiameter(result, 48, 40);
}

}  // namespace
}  // namespace lathelier::features
