// Keyways, cross holes and bolt circles: sizes by their rims, and what is no hole.
#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

#include "engine/core/random.h"
#include "engine/features/marks/rim_fit.h"
#include "engine/features/marks/slot.h"
#include "engine/features/marks/wall_rays.h"
#include "shaped_scan.h"

namespace lathelier::features {
namespace {

Recognition recognized(const Shape& shape, std::uint64_t seed = 1)
{
    return recognize(shapedScan(collarPart(), coarser(seed), shape), {});
}

std::vector<ShaftMark> marksOfKind(const Recognition& result, MarkKind kind)
{
    std::vector<ShaftMark> found;
    for (const ShaftMark& mark : result.marks)
        if (mark.kind == kind) found.push_back(mark);
    return found;
}

/// Distance from the axis of a hole at z and angle, of points on its side of the part.
double fromHole_mm(const AroundPoint& p, double z_mm, double angle_rad)
{
    if (std::cos(p.angle_rad - angle_rad) < 0) return HUGE_VAL;
    return std::hypot(p.z_mm - z_mm, p.r_mm * std::sin(p.angle_rad - angle_rad));
}

/// Rays toward the axis see 5.4 mm of the floor of a slot of 8 mm; a step of the rays is 0.33 mm on the wall.
TEST(Keyways, WidthLengthAndDepth)
{
    for (const double width_mm : {5.0, 6.0, 8.0, 10.0})
        for (std::uint64_t seed = 1; seed <= 2; ++seed) {
            const double floor_mm = 8.5, middle = 0.4 * static_cast<double>(seed);
            const Recognition result = recognized(
                [&](const AroundPoint& p) {
                    const double across = p.r_mm * std::sin(p.angle_rad - middle),
                                 along = std::cos(p.angle_rad - middle);
                    const double over = std::max({8 + width_mm / 2 - p.z_mm, p.z_mm - (33 - width_mm / 2), 0.0});
                    return along > 0 && std::hypot(across, over) < width_mm / 2 ? floor_mm / along : p.r_mm;
                },
                seed);
            ASSERT_EQ(result.marks.size(), 1U) << width_mm;
            const ShaftMark& mark = result.marks[0];
            ASSERT_EQ(mark.kind, MarkKind::Keyway) << width_mm;
            EXPECT_NEAR(*mark.width_mm, width_mm, 0.2) << width_mm;
            ASSERT_TRUE(mark.uncertainty_mm) << width_mm;
            EXPECT_LT(std::abs(*mark.width_mm - width_mm), *mark.uncertainty_mm) << width_mm;
            EXPECT_LT(*mark.uncertainty_mm, 0.35) << width_mm;
            EXPECT_NEAR(*mark.z_start_mm, 8, 0.12) << width_mm;
            EXPECT_NEAR(*mark.z_end_mm, 33, 0.12) << width_mm;
            ASSERT_TRUE(mark.place_uncertainty_mm && mark.depth_uncertainty_mm && mark.angle_uncertainty_deg);
            EXPECT_LT(std::abs(*mark.z_start_mm - 8), *mark.place_uncertainty_mm) << width_mm;
            EXPECT_LT(std::abs(*mark.z_end_mm - 33), *mark.place_uncertainty_mm) << width_mm;
            EXPECT_LT(*mark.place_uncertainty_mm, 0.3) << width_mm;
            EXPECT_LT(std::abs(*mark.floor_mm - floor_mm), *mark.depth_uncertainty_mm) << width_mm;
            EXPECT_LT(*mark.depth_uncertainty_mm, 0.02) << width_mm;
            EXPECT_LT(*mark.angle_uncertainty_deg, 1) << width_mm;
            EXPECT_NEAR(*mark.floor_mm, floor_mm, 0.02) << width_mm;
            EXPECT_NEAR(*mark.depth_mm, 12.5 - floor_mm, 0.02) << width_mm;
            EXPECT_EQ(mark.designation, width_mm == 8 ? "DIN 6885 - A 8×7×25" : "") << width_mm;
            EXPECT_TRUE(result.unexplained.empty()) << width_mm;
        }
}

TEST(Keyways, KeysOfTheStandard)
{
    ShaftMark slot{MarkKind::Keyway};
    slot.z_start_mm = 10;
    slot.z_end_mm = 50.1;
    slot.width_mm = 11.9;
    slot.uncertainty_mm = 0.15;
    EXPECT_EQ(keyOf(slot, 40, true), "DIN 6885 - A 12×8×40");
    EXPECT_EQ(keyOf(slot, 37, true), "");   // 30 to 38: 10 mm
    EXPECT_EQ(keyOf(slot, 40, false), "");  // not of form A
    slot.z_end_mm = 53;
    EXPECT_EQ(keyOf(slot, 40, true), "DIN 6885 - A 12×8");
}

/// Cells of 1 mm with two or three rows of points part the floor; its rim is that of one slot.
TEST(Keyways, OneOfACoarseScan)
{
    sample::ScannerModel scanner = coarser(5);
    scanner.row_pitch_mm = 0.36;
    scanner.angle_step_deg = 2.4;
    const Scan scan = shapedScan(collarPart(), scanner, [](const AroundPoint& p) {
        const double across = p.r_mm * std::sin(p.angle_rad - 0.6), along = std::cos(p.angle_rad - 0.6);
        const double over = std::max({12 - p.z_mm, p.z_mm - 30, 0.0});
        return along > 0 && std::hypot(across, over) < 4 ? 8.5 / along : p.r_mm;
    });
    const Recognition result = recognize(scan, {});
    ASSERT_EQ(result.marks.size(), 1U);
    EXPECT_EQ(result.marks[0].kind, MarkKind::Keyway);
    EXPECT_NEAR(*result.marks[0].width_mm, 8, 0.25);
    EXPECT_NEAR(*result.marks[0].z_start_mm, 8, 0.3);
    EXPECT_NEAR(*result.marks[0].z_end_mm, 34, 0.3);
}

TEST(CrossHoles, ThroughHoleIsOneMark)
{
    for (const double diameter_mm : {5.0, 6.6, 11.0}) {
        const Recognition result = recognized([&](const AroundPoint& p) -> std::optional<double> {
            const double inside = std::min(fromHole_mm(p, 20, 0.7), fromHole_mm(p, 20, 0.7 + std::numbers::pi));
            return inside < diameter_mm / 2 ? std::nullopt : std::optional(p.r_mm);
        });
        ASSERT_EQ(result.marks.size(), 1U) << diameter_mm;
        const ShaftMark& mark = result.marks[0];
        ASSERT_EQ(mark.kind, MarkKind::CrossHole) << diameter_mm;
        EXPECT_EQ(mark.through, 1.0) << diameter_mm;
        EXPECT_NEAR(*mark.diameter_mm, diameter_mm, 0.15) << diameter_mm;
        EXPECT_LT(std::abs(*mark.diameter_mm - diameter_mm), *mark.uncertainty_mm) << diameter_mm;
        EXPECT_NEAR((*mark.z_start_mm + *mark.z_end_mm) / 2, 20, 0.08) << diameter_mm;
        ASSERT_TRUE(mark.place_uncertainty_mm && mark.angle_uncertainty_deg) << diameter_mm;
        EXPECT_LT(std::abs((*mark.z_start_mm + *mark.z_end_mm) / 2 - 20), *mark.place_uncertainty_mm) << diameter_mm;
        EXPECT_LT(*mark.place_uncertainty_mm, 0.3) << diameter_mm;
        EXPECT_TRUE(result.unexplained.empty()) << diameter_mm;
    }
}

TEST(CrossHoles, BlindHoleWithItsFloor)
{
    for (const double tip_mm : {0.0, 1.8}) {
        const Recognition result = recognized([&](const AroundPoint& p) {
            if (fromHole_mm(p, 20, 0.7) > 3) return p.r_mm;
            // The point of a drill rises to the full diameter: where the ray meets this cone.
            AroundPoint on_floor = p;
            for (int i = 0; i < 40; ++i) {
                const double from_axis = fromHole_mm(on_floor, 20, 0.7);
                on_floor.r_mm = (7.5 - tip_mm * (1 - from_axis / 3)) / std::cos(p.angle_rad - 0.7);
            }
            return on_floor.r_mm;
        });
        ASSERT_EQ(result.marks.size(), 1U) << tip_mm;
        EXPECT_EQ(result.marks[0].kind, MarkKind::CrossHole) << tip_mm;
        EXPECT_NEAR(*result.marks[0].diameter_mm, 6, 0.15) << tip_mm;
        EXPECT_EQ(result.marks[0].through, 0.0) << tip_mm;
        ASSERT_TRUE(result.marks[0].depth_mm) << tip_mm;
        EXPECT_NEAR(*result.marks[0].depth_mm, 5, 0.2) << tip_mm;
        EXPECT_TRUE(result.unexplained.empty()) << tip_mm;
    }
}

/// The few points of a floor at the axis lie all around it, like a wall of hardly any radius.
TEST(CrossHoles, BlindHoleWhoseFloorIsAtTheAxis)
{
    const sample::ScannerModel scanner = coarser(3);
    Scan scan = shapedScan(collarPart(), scanner, [](const AroundPoint& p) -> std::optional<double> {
        return fromHole_mm(p, 20, 0.7) > 3 ? std::optional(p.r_mm) : std::nullopt;
    });
    for (std::uint64_t i = 0; i < 160; ++i)
        scan.points_mm.push_back(scanner.scan_T_part * Eigen::Vector3d(0.03 * randomNormal(5, 0, i),
                                                                       0.34 * (2 * randomUniform(5, 1, i) - 1),
                                                                       17.2 + 0.15 * static_cast<double>(i / 4)));
    const Recognition result = recognize(scan, {});
    EXPECT_TRUE(result.bores.empty());
    ASSERT_EQ(result.marks.size(), 1U);
    EXPECT_EQ(result.marks[0].kind, MarkKind::CrossHole);
    EXPECT_NEAR(*result.marks[0].diameter_mm, 6, 0.3);
    EXPECT_TRUE(result.unexplained.empty());
}

TEST(CrossHoles, UnequalOppositeHolesAreTwo)
{
    const Recognition result = recognized([](const AroundPoint& p) -> std::optional<double> {
        const bool gone = fromHole_mm(p, 20, 0.7) < 3 || fromHole_mm(p, 20, 0.7 + std::numbers::pi) < 4.5;
        return gone ? std::nullopt : std::optional(p.r_mm);
    });
    const std::vector<ShaftMark> holes = marksOfKind(result, MarkKind::CrossHole);
    ASSERT_EQ(holes.size(), 2U);
    for (const ShaftMark& hole : holes) EXPECT_NE(hole.through, 1.0);
}

/// What is not round has no diameter.
TEST(CrossHoles, OvalPlacesWithoutPointsStayUnexplained)
{
    const Recognition result = recognized([](const AroundPoint& p) -> std::optional<double> {
        const double across = p.r_mm * std::sin(p.angle_rad - 0.7), along = (p.z_mm - 20) / 1.5;
        return std::cos(p.angle_rad - 0.7) > 0 && std::hypot(across, along) < 3 ? std::nullopt : std::optional(p.r_mm);
    });
    EXPECT_TRUE(result.marks.empty());
    EXPECT_FALSE(result.unexplained.empty());
}

TEST(CrossHoles, RoundDentsAreNone)
{
    const Recognition result = recognized([](const AroundPoint& p) {
        const double from_axis = fromHole_mm(p, 20, 0.7);
        return from_axis < 4 ? p.r_mm - 1.2 * (1 - from_axis * from_axis / 16) : p.r_mm;
    });
    EXPECT_TRUE(result.marks.empty());
    EXPECT_FALSE(result.unexplained.empty());
}

/// Ø20 × 30 with a flange Ø60 × 12, evenly seen from all sides, 16 points in a mm², holes through the flange.
Scan flange(const std::vector<double>& angles_rad, double diameter_mm, double circle_mm, bool is_through)
{
    Scan scan;
    std::uint64_t index = 0;
    const Eigen::Isometry3d pose(Eigen::Translation3d(3, -2, 5) *
                                 Eigen::AngleAxisd(0.6, Eigen::Vector3d(0.3, 0.9, 0.2).normalized()));
    const auto uniform = [&](std::uint64_t stream) { return randomUniform(11, stream, index); };
    const auto add = [&](double from_r, double to_r, double from_z, double to_z, bool has_holes) {
        const double area = from_z == to_z ? std::numbers::pi * (to_r * to_r - from_r * from_r)
                                           : 2 * std::numbers::pi * from_r * (to_z - from_z);
        for (int i = 0; i < static_cast<int>(16 * area); ++i, ++index) {
            const double turn = 2 * std::numbers::pi * uniform(0), share = uniform(1),
                         noise = 0.02 * randomNormal(11, 2, index);
            double r = std::sqrt(from_r * from_r + share * (to_r * to_r - from_r * from_r));
            double z = from_z + share * (to_z - from_z);
            bool gone = false;
            for (const double angle : angles_rad)
                gone |= has_holes && std::hypot(r * std::cos(turn) - circle_mm / 2 * std::cos(angle),
                                                r * std::sin(turn) - circle_mm / 2 * std::sin(angle)) < diameter_mm / 2;
            if (gone) continue;
            (from_z == to_z ? z : r) += noise;
            scan.points_mm.push_back(pose * Eigen::Vector3d(r * std::cos(turn), r * std::sin(turn), z));
        }
    };
    add(0, 10, 0, 0, false);
    add(10, 10, 0, 30, false);
    add(10, 30, 30, 30, is_through);
    add(30, 30, 30, 42, false);
    add(0, 30, 42, 42, true);
    // Not face by face, which would look like the rows of a rotary scanner.
    for (std::size_t i = scan.points_mm.size() - 1; i > 0; --i)
        std::swap(scan.points_mm[i], scan.points_mm[randomBits(12, 0, i) % (i + 1)]);
    return scan;
}

std::vector<double> evenly(int count, double first_rad)
{
    std::vector<double> angles;
    for (int i = 0; i < count; ++i) angles.push_back(first_rad + 2 * std::numbers::pi * i / count);
    return angles;
}

TEST(BoltCircles, CountDiameterAndPitchCircle)
{
    for (const auto& [count, diameter_mm, is_through] :
         {std::tuple(3, 9.0, true), std::tuple(6, 6.6, false), std::tuple(12, 5.5, true)}) {
        const Recognition result = recognize(flange(evenly(count, 0.3), diameter_mm, 44, is_through), {});
        ASSERT_EQ(result.marks.size(), 1U) << count;
        const ShaftMark& mark = result.marks[0];
        ASSERT_EQ(mark.kind, MarkKind::BoltCircle) << count;
        EXPECT_EQ(mark.count, static_cast<double>(count));
        EXPECT_NEAR(*mark.diameter_mm, diameter_mm, 0.1) << count;
        EXPECT_NEAR(*mark.pitch_circle_mm, 44, 0.1) << count;
        EXPECT_EQ(mark.through, is_through ? 1.0 : 0.0) << count;
        EXPECT_NEAR(*mark.z_end_mm - *mark.z_start_mm, is_through ? 12 : 0, 0.05) << count;
        EXPECT_LT(*mark.angle_deg, 360.0 / count) << count;
        EXPECT_TRUE(result.unexplained.empty()) << count;
    }
}

TEST(BoltCircles, UnevenHolesStayUnexplained)
{
    std::vector<double> angles = evenly(6, 0.3);
    angles.pop_back();
    const Recognition result = recognize(flange(angles, 6.6, 44, true), {});
    EXPECT_TRUE(result.marks.empty());
    ASSERT_FALSE(result.unexplained.empty());
    EXPECT_EQ(result.unexplained.front().kind, StructureKind::NoPoints);
    EXPECT_EQ(result.unexplained.front().places, 5);
}

TEST(Columns, EqualStepsOnly)
{
    std::vector<double> even, chance;
    for (std::uint64_t i = 0; i < 4000; ++i) {
        even.push_back(0.01 + 0.02 * static_cast<double>(i % 25) + 1e-5 * randomNormal(1, 0, i));
        chance.push_back(0.5 * randomUniform(1, 1, i));
    }
    const auto columns = columnsOf(even);
    ASSERT_TRUE(columns);
    EXPECT_NEAR(columns->step_rad, 0.02, 1e-6);
    EXPECT_NEAR(columns->first_rad, 0.01, 1e-5);
    EXPECT_FALSE(columnsOf(chance));
    EXPECT_FALSE(columnsOf({}));
}

/// Points of even density about a hole of known size, and U that holds.
TEST(Rims, CircleAmongPoints)
{
    int held = 0;
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        RimView view;
        for (std::uint64_t i = 0; i < 2000; ++i) {
            const RimRay ray{10 * randomUniform(seed, 0, i) - 5, 10 * randomUniform(seed, 1, i) - 5, true};
            if (std::hypot(ray.z_mm - 0.2, ray.across_mm + 0.1) > 3) view.rays.push_back(ray);
        }
        const RimFit fit = fitRim(view, circleRim(0.5, 0.4, 2.6));
        EXPECT_NEAR(fit.rim.width_mm(), 6, 0.15) << seed;
        EXPECT_NEAR(fit.rim.middle_mm(), -0.1, 0.1) << seed;
        held += std::abs(fit.rim.width_mm() - 6) < 2 * fit.width_sigma_mm ? 1 : 0;
    }
    EXPECT_GE(held, 16);
}

/// A straight rim between two columns of rays may be anywhere between them.
TEST(Rims, StraightRimsBetweenColumnsAreUncertainByTheirStep)
{
    RimView view;
    view.has_misses = true;
    RimShape slot;
    slot.kind = RimKind::Slot;
    slot.round_start = slot.round_end = false;
    slot.low_mm = -3;
    slot.high_mm = 3.05;
    slot.start_mm = -40;
    slot.end_mm = 40;
    for (int column = -12; column <= 12; ++column)
        for (int row = -60; row <= 60; ++row) {
            const double across = 0.4 * column + 0.1, z = 0.15 * row;
            view.rays.push_back({z, across, across < slot.low_mm || across > slot.high_mm});
        }
    const RimFit fit = fitRim(view, slot);
    // Columns at -3.1, -2.7 and 2.9, 3.3: middles -2.9 and 3.1; each even over 0.4 mm.
    EXPECT_NEAR(fit.rim.low_mm, -2.9, 0.06);
    EXPECT_NEAR(fit.rim.high_mm, 3.1, 0.06);
    EXPECT_NEAR(fit.width_sigma_mm, 0.4 / std::sqrt(6.0), 0.05);
}

}  // namespace
}  // namespace lathelier::features
