// The shaft of a recognition, as measured and with nominal sizes in place.
#include "engine/features/nominal/snap.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "engine/core/random.h"
#include "engine/features/nominal/roles.h"
#include "engine/shaft/shaft_contour.h"
#include "engine/shaft/shaft_rules.h"
#include "made_recognition.h"

namespace lathelier::features {
namespace {

void expectTable(const Shaft& shaft, const Table& table, double within_mm)
{
    ASSERT_EQ(shaft.segments.size(), table.size());
    for (std::size_t i = 0; i < table.size(); ++i) {
        SCOPED_TRACE("row " + std::to_string(i + 1));
        const ShaftSegment& row = shaft.segments[i];
        EXPECT_NEAR(row.length_mm, table[i].length_mm, within_mm);
        EXPECT_NEAR(row.start_diameter_mm, table[i].start_mm, within_mm);
        EXPECT_NEAR(row.end_diameter_mm, table[i].end_mm, within_mm);
        EXPECT_NEAR(row.arc_radius_mm.value_or(0), table[i].arc_mm.value_or(0), within_mm);
    }
}

/// The table as if it were made and measured a little off: diameters of lines, z of planes and corners, legs and radii;
/// tangent arcs stay tangent, joints stay joined.
Table disturbed(Table table, std::uint64_t seed)
{
    const auto off = [&](std::uint64_t stream, std::size_t i, double most) {
        return most * (2 * randomUniform(seed, stream, i) - 1);
    };
    const Table truth = table;
    const auto isQuarter = [&](const TableRow& row) {
        return row.arc_mm && std::abs(row.length_mm - std::abs(*row.arc_mm)) < 1e-9;
    };
    // Cylinders first, in length and diameter.
    for (std::size_t i = 0; i < table.size(); ++i) {
        TableRow& row = table[i];
        if (truth[i].start_mm == truth[i].end_mm && !truth[i].arc_mm && truth[i].length_mm > 1) {
            row.start_mm = row.end_mm = truth[i].start_mm + off(0, i, 0.004);
            row.length_mm += off(1, i, 0.006);
        }
    }
    for (std::size_t i = 0; i < table.size(); ++i) {
        TableRow& row = table[i];
        if (truth[i].start_mm == truth[i].end_mm && !truth[i].arc_mm) continue;
        const bool at_start = i > 0 && std::abs(truth[i - 1].end_mm - truth[i].start_mm) < 1e-9;
        const bool at_end = i + 1 < table.size() && std::abs(truth[i].end_mm - truth[i + 1].start_mm) < 1e-9;
        if (isQuarter(truth[i])) {
            const double radius = row.length_mm * (1 + off(2, i, 0.015)), sign = row.arc_mm.value() > 0 ? 1 : -1;
            const double rise = truth[i].end_mm > truth[i].start_mm ? 2 * radius : -2 * radius;
            row.length_mm = radius;
            row.arc_mm = sign * radius;
            if (at_start) {
                row.start_mm = table[i - 1].end_mm;
                row.end_mm = row.start_mm + rise;
            } else {
                row.end_mm = table[i + 1].start_mm;
                row.start_mm = row.end_mm - rise;
            }
            continue;
        }
        if (at_start) row.start_mm = table[i - 1].end_mm;
        if (at_end) row.end_mm = table[i + 1].start_mm;
        if (truth[i].arc_mm) continue;
        const double rise = truth[i].end_mm - truth[i].start_mm, leg = truth[i].length_mm;
        if (at_start && at_end) {  // the taper stays what it is
            row.length_mm = leg * (row.end_mm - row.start_mm) / rise;
            continue;
        }
        row.length_mm = leg + off(3, i, 0.01);
        if (at_start)
            row.end_mm = row.start_mm + rise * row.length_mm / leg;
        else if (at_end)
            row.start_mm = row.end_mm - rise * row.length_mm / leg;
    }
    return table;
}

Shaft applied(Recognition recognition)
{
    describeRows(recognition);
    return appliedNominal(recognition);
}

TEST(Snap, ThePapersShaft)
{
    Table measured = tableOne();
    measured[0] = {98.004, 30.0004, 30.0004};
    measured[1] = {9.999, 36.9995, 36.9995};
    measured[2] = {69.99, 33.7998, 33.7998};
    measured[3] = {5.012, 33.7998, 33.7998 - 2 * 5.006};
    Recognition part = recognitionOf(measured);
    for (RecognizedRow& row : part.segments) row.uncertainty.start_diameter_um = row.uncertainty.end_diameter_um = 0.4;
    const Shaft shaft = applied(part);
    expectTable(shaft, tableOne(), 1e-9);
    EXPECT_NEAR(volume_mm3(shaft), 146123.0665, 5e-5);
    EXPECT_NEAR(shaft.length_mm(), 183, 1e-9);
    const MeasuredSize kept = shaft.segments[2].measured.value();
    EXPECT_NEAR(kept.start_diameter_mm.value(), 33.7998, 1e-12);
    EXPECT_NEAR(kept.length_mm.value(), 69.99, 1e-9);
    EXPECT_EQ(kept.uncertainty.start_diameter_um, 0.4);
    EXPECT_EQ(shaft.segments[3].role, "chamfer");
    EXPECT_TRUE(checkShaft(shaft).empty());
}

TEST(Snap, MeasuredIsUntouched)
{
    const Table measured = disturbed(taperPart(), 3);
    Recognition part = recognitionOf(measured);
    part.marks.resize(1);
    part.marks[0].kind = MarkKind::Knurl;
    describeRows(part);
    const Shaft shaft = measuredShaft(part);
    expectTable(shaft, measured, 1e-12);
    EXPECT_EQ(shaft.marks, part.marks);
    EXPECT_TRUE(shaft.name.empty());
    for (const ShaftSegment& row : shaft.segments) {
        ASSERT_TRUE(row.measured);
        EXPECT_EQ(row.measured->start_diameter_mm, row.start_diameter_mm);
        EXPECT_NEAR(*row.measured->length_mm, row.length_mm, 1e-12);
        EXPECT_FALSE(row.tolerance);
    }
    EXPECT_NO_THROW(checkShaft(shaft));
}

/// With any suggestions the contour is closed and valid; drawn sizes are recovered.
TEST(Snap, PracticeParts)
{
    for (const Table& truth : {tableOne(), undercutPart(), taperPart()})
        for (std::uint64_t seed = 0; seed < 40; ++seed) {
            SCOPED_TRACE("seed " + std::to_string(seed));
            const Shaft shaft = applied(recognitionOf(disturbed(truth, seed)));
            ASSERT_EQ(shaft.segments.size(), truth.size());
            EXPECT_NO_THROW(checkShaft(shaft));
            for (std::size_t i = 0; i < truth.size(); ++i) {
                SCOPED_TRACE("row " + std::to_string(i + 1));
                const ShaftSegment& row = shaft.segments[i];
                const TableRow& drawn = truth[i];
                if (drawn.start_mm == drawn.end_mm && !drawn.arc_mm && std::round(drawn.start_mm) == drawn.start_mm) {
                    EXPECT_NEAR(row.start_diameter_mm, drawn.start_mm, 1e-9);
                }
                if (i > 0 && std::abs(truth[i - 1].end_mm - drawn.start_mm) < 1e-9) {
                    EXPECT_NEAR(row.start_diameter_mm, shaft.segments[i - 1].end_diameter_mm, 1e-9);
                }
                if (drawn.arc_mm && std::abs(drawn.length_mm - std::abs(*drawn.arc_mm)) < 1e-9) {
                    EXPECT_NEAR(row.length_mm, std::abs(*row.arc_radius_mm), 1e-9);
                    EXPECT_NEAR(std::abs(row.end_diameter_mm - row.start_diameter_mm), 2 * std::abs(*row.arc_radius_mm),
                                1e-9);
                    EXPECT_NEAR(*row.arc_radius_mm, *drawn.arc_mm, 1e-9);
                }
            }
        }
}

TEST(Snap, TaperFollowsFromItsCylinders)
{
    const Shaft shaft = applied(recognitionOf(disturbed(taperPart(), 5)));
    EXPECT_NEAR(shaft.segments[4].length_mm, 40, 1e-9);
    EXPECT_NEAR(shaft.segments[4].end_diameter_mm, 28, 1e-9);
    EXPECT_NEAR(shaft.segments[8].arc_radius_mm.value(), -60, 1e-9);
    EXPECT_NEAR(shaft.segments[8].start_diameter_mm, 42, 1e-9);
    EXPECT_NEAR(shaft.segments[13].length_mm, 1, 1e-9);
}

TEST(Snap, UndercutsBecomeThoseOfTheStandard)
{
    const Table truth = undercutPart();
    const Shaft shaft = applied(recognitionOf(disturbed(truth, 1)));
    ASSERT_EQ(shaft.segments.size(), truth.size());
    for (const std::size_t i : {2U, 4U, 5U, 6U, 8U, 9U, 10U, 11U}) {
        SCOPED_TRACE("row " + std::to_string(i + 1));
        EXPECT_NEAR(shaft.segments[i].start_diameter_mm, truth[i].start_mm, 1e-9);
        EXPECT_NEAR(shaft.segments[i].end_diameter_mm, truth[i].end_mm, 1e-9);
        EXPECT_NEAR(shaft.segments[i].length_mm, truth[i].length_mm, 1e-9);
    }
}

TEST(Snap, HiddenUndercutGetsItsFace)
{
    const Table truth = undercutPart();
    Table seen = truth;
    seen.erase(seen.begin() + 11);
    Recognition part = recognitionOf(seen);
    RecognizedRow& arc = part.segments[10];
    arc.fully_visible = false;
    arc.uncertainty.arc_radius_um = 200;
    for (std::size_t i = 11; i < part.segments.size(); ++i) {
        part.segments[i].z_start_mm += truth[11].length_mm;
        part.segments[i].z_end_mm += truth[11].length_mm;
    }
    part.length_mm = part.segments.back().z_end_mm;
    Recognition past = part;  // the arc as far as its circle goes; and cut off at the face
    arc.end_diameter_mm = 2 * ContourPiece{{arc.z_start_mm, arc.start_diameter_mm / 2},
                                           {arc.z_end_mm, arc.end_diameter_mm / 2},
                                           *arc.arc_radius_mm}
                                  .radiusAt_mm(70);
    arc.z_end_mm = 70;
    for (Recognition* one : {&past, &part}) {
        const Shaft shaft = applied(*one);
        expectTable(shaft, truth, 1e-9);
        EXPECT_EQ(shaft.segments[11].role, "undercut");
        describeRows(*one);
        const Shaft measured = measuredShaft(*one);
        EXPECT_NO_THROW(checkShaft(measured));
        EXPECT_EQ(measured.segments.size(), truth.size() - 1);
        EXPECT_NEAR(measured.length_mm(), shaft.length_mm(), 1e-9);
    }
}

TEST(Snap, BoresKeepToThePart)
{
    Recognition part = recognitionOf(cylinder(60.003, 48.004));
    part.bores = {rowsOf(cone(42.01, 40.002, 1.004) + cylinder(40.002, 46.99))};
    part.bores[0].back().z_end_mm = 48.004 - 0.006;
    describeRows(part);
    const Shaft through = appliedNominal(part);
    ASSERT_EQ(through.bores.size(), 1U);
    EXPECT_TRUE(isThrough(through, through.bores[0]));
    EXPECT_NEAR(through.length_mm(), 48, 1e-9);
    EXPECT_NEAR(through.bores[0].segments[0].length_mm, 1, 1e-9);
    EXPECT_NEAR(through.bores[0].segments[0].start_diameter_mm, 42, 1e-9);
    EXPECT_NEAR(through.bores[0].segments[1].end_diameter_mm, 40, 1e-9);

    std::vector<RecognizedRow> chuck = rowsOf(cone(49, 47, 1) + cylinder(47.0, 8.01));
    for (RecognizedRow& row : chuck) {
        row.z_start_mm = 48.004 - row.z_start_mm;
        row.z_end_mm = 48.004 - row.z_end_mm;
    }
    part.bores = {chuck};
    describeRows(part);
    const Shaft blind = appliedNominal(part);
    EXPECT_EQ(blind.bores[0].from, ShaftEnd::Chuck);
    EXPECT_NEAR(blind.bores[0].segments[0].length_mm + blind.bores[0].segments[1].length_mm, 9, 1e-9);
    EXPECT_NO_THROW(checkShaft(blind));
}

TEST(Snap, AGapIsBridged)
{
    Recognition part = recognitionOf(tableOne());
    part.segments[1].z_start_mm += 2;
    part.complete = false;
    describeRows(part);
    const Shaft shaft = measuredShaft(part);
    ASSERT_EQ(shaft.segments.size(), 5U);
    EXPECT_EQ(shaft.segments[1].role, "gap");
    EXPECT_NEAR(shaft.length_mm(), 183, 1e-9);
    EXPECT_NO_THROW(checkShaft(appliedNominal(part)));
}

TEST(Snap, WhatBreaksARuleIsLeftOut)
{
    // A chamfer on a shoulder so thin that its nominal leg does not fit.
    Recognition part = recognitionOf(cylinder(20, 20) + cone(38.2, 40, 0.9) + cylinder(40, 0.06) + cylinder(30, 20));
    describeRows(part);
    const Shaft shaft = appliedNominal(part);
    EXPECT_NO_THROW(checkShaft(shaft));
    EXPECT_NEAR(shaft.segments[0].start_diameter_mm, 20, 1e-9);
    EXPECT_GT(shaft.segments[2].length_mm, 0);
}

TEST(Snap, EditedSuggestionsCount)
{
    Recognition part = recognitionOf(tableOne());
    describeRows(part);
    for (Suggestion& one : part.segments[1].suggestions)
        if (one.quantity == "diameter_mm") one.nominal_mm = 37.5;
    part.segments[0].suggestions.clear();
    part.segments[0].start_diameter_mm = part.segments[0].end_diameter_mm = 30.002;
    const Shaft shaft = appliedNominal(part);
    EXPECT_NEAR(shaft.segments[1].end_diameter_mm, 37.5, 1e-9);
    EXPECT_NEAR(shaft.segments[0].end_diameter_mm, 30.002, 1e-9);
    EXPECT_EQ(shaft.segments[0].measured->start_diameter_mm, 30.002);
}

/// Contours of any rows: wherever the measured shaft keeps the rules, the nominal one does.
TEST(Snap, AnyContourStaysSound)
{
    int sound = 0, changed = 0;
    for (std::uint64_t seed = 0; seed < 3000; ++seed) {
        std::uint64_t count = 0;
        const auto uniform = [&](double low, double high) {
            return low + (high - low) * randomUniform(seed, 9, count++);
        };
        Table table;
        double d = uniform(8, 40);
        const auto rows = static_cast<int>(uniform(1, 10));
        for (int i = 0; i < rows; ++i) {
            const double length = uniform(0, 1) < 0.5 ? uniform(0.1, 2) : uniform(2, 30), kind = uniform(0, 1);
            if (uniform(0, 1) < 0.4) d = uniform(8, 40);
            const double end = kind < 0.5 ? d : std::max(1.0, d + uniform(-1, 1) * 2 * length);
            TableRow row{length, d, end};
            if (kind > 0.75) row.arc_mm = (kind > 0.87 ? 1 : -1) * std::hypot(length, (end - d) / 2) * uniform(0.5, 2);
            table.push_back(row);
            d = end;
        }
        Recognition part = recognitionOf(table);
        for (RecognizedRow& row : part.segments)
            if (uniform(0, 1) < 0.1) row.fully_visible = false;
        describeRows(part);
        const Shaft measured = measuredShaft(part), nominal = appliedNominal(part);
        try {
            checkShaft(measured);
        } catch (const Error&) {
            continue;
        }
        ++sound;
        changed += !(nominal == measured);
        EXPECT_NO_THROW(checkShaft(nominal)) << seed;
    }
    EXPECT_GT(sound, 1000);
    EXPECT_GT(changed, 500);
}

}  // namespace
}  // namespace lathelier::features
