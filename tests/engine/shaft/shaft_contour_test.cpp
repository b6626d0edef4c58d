// The meridian of a shaft as exact pieces: volumes against closed forms, bores, beam view, and the rules one by one.
#include "engine/shaft/shaft_contour.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "engine/shaft/shaft_codes.h"
#include "engine/shaft/shaft_rules.h"
#include "tests/engine/core/code_of_error.h"
#include "tests/engine/shaft/shaft_row.h"

namespace lathelier {
namespace {

using std::numbers::pi;

/// The shaft of the paper's Table 1.
Shaft tableOne()
{
    Shaft shaft;
    shaft.segments = {shaftRow(98, 30, 30), shaftRow(10, 37, 37), shaftRow(70, 33.8, 33.8), shaftRow(5, 33.8, 23.8)};
    return shaft;
}

TEST(ShaftContour, VolumeOfThePapersTable)
{
    EXPECT_NEAR(volume_mm3(tableOne()), 146123.0665, 5e-5);
}

TEST(ShaftContour, VolumesOfSphereAndTorus)
{
    Shaft sphere;
    sphere.segments = {shaftRow(10, 0, 20, 10.0), shaftRow(10, 20, 0, 10.0)};
    EXPECT_NEAR(volume_mm3(sphere), 4 * pi * 1000 / 3, 1e-9);
    EXPECT_TRUE(checkShaft(sphere).empty());
    // A half-round groove of radius 2 in a bar of 20: Pappus, the half disc's centroid 4·2/(3π) inside.
    Shaft groove;
    groove.segments = {shaftRow(8, 20, 20), shaftRow(2, 20, 16, -2.0), shaftRow(2, 16, 20, -2.0), shaftRow(8, 20, 20)};
    EXPECT_NEAR(volume_mm3(groove), pi * 100 * 20 - 2 * pi * (10 - 8 / (3 * pi)) * (pi * 4 / 2), 1e-9);
}

/// Reference: Simpson's rule over 20 000 steps in 80 bits.
TEST(ShaftContour, VolumeOfACrownOfManyMetres)
{
    Shaft crowned;
    crowned.segments = {shaftRow(70.00021429133636, 33.800039817124485, 33.800162388055384, 15354.549983683628)};
    EXPECT_NEAR(volume_mm3(crowned), 63007.3475469155, 1e-8);
    crowned.segments.front().arc_radius_mm = -15354.549983683628;  // hollow
    // What the crown adds the hollow takes away, but for the way of its centroid from the chord: 4π · 0.016 mm · 1.86
    // mm².
    const double cylinder = pi * 70.00021429133636 * 16.90005 * 16.90005;
    EXPECT_NEAR(volume_mm3(crowned) + 63007.3475469155, 2 * cylinder + 0.374, 0.02);
    crowned.segments = {shaftRow(70, 33.8, 33.8, 1e6)};
    EXPECT_GT(volume_mm3(crowned), pi * 70 * 16.9 * 16.9);
    EXPECT_NEAR(volume_mm3(crowned), pi * 70 * 16.9 * 16.9, 4);
}

TEST(ShaftContour, BoresAreTakenOut)
{
    Shaft shaft;
    shaft.segments = {shaftRow(50, 40, 40)};
    shaft.bores = {{ShaftEnd::Free, {{10, 20, 10, {}, ""}}}, {ShaftEnd::Chuck, {{15, 12, 12, {}, ""}}}};
    const double cone = pi * 10 * (100 + 50 + 25) / 3;
    EXPECT_NEAR(volume_mm3(shaft), pi * (400 * 50 - 36 * 15) - cone, 1e-9);
    Shaft rows = shaft;
    rows.bores.clear();
    rows.segments = {shaftRow(30, 40, 40), shaftRow(20, 40, 40)};
    for (ShaftSegment& one : rows.segments) one.bore_diameter_mm = 12;
    EXPECT_NEAR(volume_mm3(rows), pi * (400 - 36) * 50, 1e-9);
    rows.segments[0].bore_diameter_mm = 0;
    EXPECT_NEAR(volume_mm3(rows), pi * (400 * 50 - 36 * 20), 1e-9);
    const Shaft beam = beamView(shaft);
    EXPECT_TRUE(beam.bores.empty());
    EXPECT_NEAR(beam.length_mm(), 50, 1e-12);
    EXPECT_EQ(beam.segments.back().bore_diameter_mm, 12);
    EXPECT_EQ(beam.segments.front().bore_diameter_mm, 19.75);
}

TEST(ShaftContour, AnArcBulgesTheSameWayInABoreFromEitherEnd)
{
    for (const ShaftEnd end : {ShaftEnd::Free, ShaftEnd::Chuck}) {
        Shaft shaft;
        shaft.segments = {shaftRow(50, 40, 40)};
        shaft.bores = {{end, {{10, 20, 20, 8.0, ""}}}};
        Shaft plain = shaft;
        plain.bores[0].segments[0].arc_radius_mm.reset();
        EXPECT_LT(volume_mm3(shaft), volume_mm3(plain) - 100);  // the hole is larger
    }
}

TEST(ShaftContour, AnUndercutFaceIsNoPartOfTheBeam)
{
    Shaft shaft;  // DIN 509 form F before a shoulder, in short
    shaft.segments = {shaftRow(20, 25, 25), shaftRow(3, 24.4, 24.4), shaftRow(1, 24.4, 26.4, -1.0),
                      shaftRow(-0.2, 26.4, 28), shaftRow(10, 34, 34)};
    EXPECT_TRUE(checkShaft(shaft).empty());
    const Shaft beam = beamView(shaft);
    ASSERT_EQ(beam.segments.size(), 4U);
    EXPECT_NEAR(beam.segments[2].length_mm, 0.8, 1e-12);
    EXPECT_NEAR(beam.length_mm(), shaft.length_mm(), 1e-12);
}

TEST(ShaftRules, EachRuleNamesItsRow)
{
    const auto rowRefused = [](Shaft shaft) -> std::int64_t {
        try {
            checkShaft(shaft);
        } catch (const Error& error) {
            EXPECT_EQ(error.code(), errors::shaftRowWrong);
            const Value* found = find(error.values(), "row");
            return found ? std::get<std::int64_t>(*found) : 0;
        }
        return -1;
    };
    const Shaft good = tableOne();
    EXPECT_TRUE(checkShaft(good).empty());
    EXPECT_EQ(rowRefused({}), 1);
    const auto spoiled = [&](std::size_t index, auto spoil) {
        Shaft shaft = good;
        spoil(shaft.segments[index]);
        return rowRefused(shaft);
    };
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(spoiled(1, [&](auto& r) { r.length_mm = nan; }), 2);
    EXPECT_EQ(spoiled(2, [&](auto& r) { r.end_diameter_mm = nan; }), 3);
    EXPECT_EQ(spoiled(0, [&](auto& r) { r.start_diameter_mm = -1; }), 1);
    EXPECT_EQ(spoiled(1, [&](auto& r) { r.start_diameter_mm = 0; }), 2);
    EXPECT_EQ(spoiled(1, [&](auto& r) { r.length_mm = -1; }), 2);
    EXPECT_EQ(spoiled(1, [&](auto& r) { r.arc_radius_mm = 4.9; }), 2);
    EXPECT_EQ(spoiled(1, [&](auto& r) { r.arc_radius_mm = 5.0; }), -1);
    EXPECT_EQ(spoiled(1, [&](auto& r) { r.bore_diameter_mm = 37; }), 2);
}

TEST(ShaftRules, ContoursThatCrossAndBoresThatMeetAreRefused)
{
    Shaft shaft = tableOne();
    shaft.bores = {{ShaftEnd::Free, {{20, 30, 30, {}, ""}}}};
    EXPECT_EQ(codeOfError([&] { checkShaft(shaft); }), errors::shaftCrosses);
    shaft.bores = {{ShaftEnd::Free, {{100, 10, 10, {}, ""}}}, {ShaftEnd::Chuck, {{100, 10, 10, {}, ""}}}};
    EXPECT_EQ(codeOfError([&] { checkShaft(shaft); }), errors::shaftBoresMeet);
    shaft.bores = {{ShaftEnd::Free, {{100, 10, 10, {}, ""}}}};
    shaft.segments[0].bore_diameter_mm = 5;
    EXPECT_EQ(codeOfError([&] { checkShaft(shaft); }), errors::boresStatedTwice);
    // A hollow arc that dips under the axis' side of a bore.
    Shaft saddle;
    saddle.segments = {shaftRow(10, 30, 30), shaftRow(20, 30, 30, -10.5), shaftRow(10, 30, 30)};
    EXPECT_TRUE(checkShaft(saddle).empty());
    saddle.bores = {{ShaftEnd::Free, {{40, 16, 16, {}, ""}}}};
    EXPECT_EQ(codeOfError([&] { checkShaft(saddle); }), errors::shaftCrosses);
}

TEST(ShaftRules, Remarks)
{
    const auto codeOf = [](const Shaft& shaft) {
        const Notes notes = checkShaft(shaft);
        return notes.size() == 1 ? std::string(notes.front().code.key) : std::to_string(notes.size());
    };
    Shaft shaft = tableOne();
    shaft.segments[1].length_mm = 0.04;
    EXPECT_EQ(codeOf(shaft), "shaft_row_short");
    shaft = tableOne();
    shaft.segments.insert(shaft.segments.begin(), shaftRow(2, 30, 30));
    EXPECT_EQ(codeOf(shaft), "shaft_rows_in_line");
    shaft = tableOne();
    shaft.bores = {{ShaftEnd::Free, {{20, 29.99, 29.99, {}, ""}}}};
    EXPECT_EQ(codeOf(shaft), "shaft_wall_thin");
    shaft = tableOne();
    shaft.marks = {{.kind = MarkKind::Keyway, .z_start_mm = 90, .z_end_mm = 104}};
    EXPECT_EQ(codeOf(shaft), "mark_outside_row");
}

}  // namespace
}  // namespace lathelier
