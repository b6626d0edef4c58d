// Rows of a shaft edited as in a drawing: changed, kept and adapted sizes.
#include "engine/shaft/shaft_edit.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>

#include "engine/shaft/shaft_codes.h"
#include "engine/shaft/shaft_contour.h"
#include "engine/shaft/shaft_item.h"
#include "engine/shaft/shaft_rules.h"
#include "engine/shaft/shaft_sizes.h"

namespace lathelier {
namespace {

/// Chamfer 1×45°, ⌀30, groove, ⌀30, fillet R1 to a shoulder, chamfer on ⌀40, ⌀40, taper, ⌀50.
ShaftRows turnedRows()
{
    return {{1, 28, 30, 0, {}, "chamfer"}, {20, 30, 30, 0, {}, ""},      {2, 27, 27, 0, {}, "groove"},
            {17, 30, 30, 0, {}, ""},       {1, 30, 32, 0, -1, "fillet"}, {0.5, 39, 40, 0, {}, "chamfer"},
            {30, 40, 40, 0, {}, ""},       {40, 40, 46, 0, {}, ""},      {25, 50, 50, 0, {}, ""}};
}

double length(const ShaftRows& rows)
{
    return startOf_mm(rows, rows.size());
}

std::string codeOf(const std::function<void()>& act)
{
    try {
        act();
    } catch (const Error& error) {
        return error.code().key;
    }
    return {};
}

TEST(ShaftEdit, ADeletedRowGivesItsLengthToWhatItMeets)
{
    const ShaftRows without = deleteRow(turnedRows(), 0, KeepAfter::Places);  // the chamfer
    ASSERT_EQ(without.size(), turnedRows().size() - 1);
    EXPECT_DOUBLE_EQ(without[0].length_mm, 21);
    EXPECT_DOUBLE_EQ(length(without), length(turnedRows()));
    const ShaftRows no_break = deleteRow(turnedRows(), 5, KeepAfter::Places);  // the chamfer after the shoulder
    EXPECT_DOUBLE_EQ(no_break[5].length_mm, 30.5);
    const ShaftRows no_fillet = deleteRow(turnedRows(), 4, KeepAfter::Places);
    EXPECT_DOUBLE_EQ(no_fillet[3].length_mm, 18);
    const ShaftRows shorter = deleteRow(turnedRows(), 6, KeepAfter::Lengths);
    EXPECT_DOUBLE_EQ(length(shorter), length(turnedRows()) - 30);
}

TEST(ShaftEdit, RowsAreMergedByTheirKinds)
{
    ShaftRows rows{{10, 30, 30, 0, {}, ""}, {30, 30.4, 30.4, 0, {}, ""}};
    rows[0].measured = MeasuredSize{10.0, 30.01, 30.01, {}, {}};
    rows[1].measured = MeasuredSize{30.0, 30.41, 30.41, {}, {}};
    const ShaftRows one = mergeWithNext(rows, 0);
    ASSERT_EQ(one.size(), 1u);
    EXPECT_DOUBLE_EQ(one[0].length_mm, 40);
    EXPECT_DOUBLE_EQ(one[0].start_diameter_mm, 30.3);
    EXPECT_DOUBLE_EQ(one[0].end_diameter_mm, 30.3);
    ASSERT_TRUE(one[0].measured);
    EXPECT_DOUBLE_EQ(*one[0].measured->start_diameter_mm, 30.31);
    const ShaftRows cone = mergeWithNext(turnedRows(), 7);
    EXPECT_DOUBLE_EQ(cone[7].start_diameter_mm, 40);
    EXPECT_DOUBLE_EQ(cone[7].end_diameter_mm, 50);
    EXPECT_DOUBLE_EQ(cone[7].length_mm, 65);
}

TEST(ShaftEdit, ASplitArcStaysTheSameContour)
{
    const ShaftRows arc{{20, 30, 50, 0, -15, "fillet"}};
    const ShaftRows two = splitRow(arc, 0, 7);
    ASSERT_EQ(two.size(), 2u);
    Shaft before, after;
    before.segments = arc;
    after.segments = two;
    EXPECT_NEAR(volume_mm3(before), volume_mm3(after), 1e-9 * volume_mm3(before));
    EXPECT_NEAR(mergeWithNext(two, 0)[0].arc_radius_mm.value_or(0), -15, 1e-9);
    EXPECT_DOUBLE_EQ(splitRow(turnedRows(), 7, 20)[8].start_diameter_mm, 43);
    for (const double wrong : {0.0, -1.0, 40.0, std::nan("")})
        EXPECT_EQ(codeOf([&] { splitRow(turnedRows(), 7, wrong); }), errors::shaftRowWrong.key) << wrong;
}

TEST(ShaftEdit, EveryRowCanBecomeEveryForm)
{
    for (std::size_t row = 0; row < turnedRows().size(); ++row)
        for (const RowForm form :
             {RowForm::Cylinder, RowForm::Cone, RowForm::Chamfer, RowForm::Round, RowForm::Fillet, RowForm::Groove}) {
            const ShaftRows rows = changeForm(turnedRows(), row, form);
            ASSERT_EQ(rows.size(), turnedRows().size());
            EXPECT_DOUBLE_EQ(rows[row].length_mm, turnedRows()[row].length_mm);
            EXPECT_EQ(isCylinder(rows[row]), form == RowForm::Cylinder || form == RowForm::Groove);
            EXPECT_EQ(rows[row].arc_radius_mm.has_value(), form == RowForm::Round || form == RowForm::Fillet);
            if (rows[row].arc_radius_mm) {
                EXPECT_EQ(*rows[row].arc_radius_mm > 0, form == RowForm::Round);
            }
        }
    const ShaftRows cone = changeForm(turnedRows(), 3, RowForm::Cone);  // between the groove's ⌀27 and the fillet's ⌀30
    EXPECT_DOUBLE_EQ(cone[3].start_diameter_mm, 27);
    EXPECT_DOUBLE_EQ(cone[3].end_diameter_mm, 30);
    const ShaftRows round =
        changeForm(turnedRows(), 0, RowForm::Round);  // a chamfer of 45°: a quarter over the same legs
    EXPECT_NEAR(*round[0].arc_radius_mm, 1, 1e-12);
}

TEST(ShaftSizes, ADiameterTakesItsChamfersAlong)
{
    const ShaftRows rows = setDiameter(turnedRows(), 1, 32);
    EXPECT_DOUBLE_EQ(rows[0].start_diameter_mm, 30);
    EXPECT_DOUBLE_EQ(rows[0].end_diameter_mm, 32);
    EXPECT_DOUBLE_EQ(rows[3].start_diameter_mm, 30);  // behind the groove: another cylinder
    const ShaftRows beside = setDiameter(turnedRows(), 6, 44);
    EXPECT_DOUBLE_EQ(beside[5].start_diameter_mm, 43);  // the chamfer keeps its legs
    EXPECT_DOUBLE_EQ(beside[5].end_diameter_mm, 44);
    EXPECT_DOUBLE_EQ(beside[7].start_diameter_mm, 44);  // the taper follows with the end that meets it
    EXPECT_DOUBLE_EQ(beside[7].end_diameter_mm, 46);
    const ShaftRows foot = setDiameter(turnedRows(), 3, 31);
    EXPECT_DOUBLE_EQ(foot[4].start_diameter_mm, 31);
    EXPECT_DOUBLE_EQ(foot[4].end_diameter_mm, 33);
    Shaft shaft;
    shaft.segments = foot;
    EXPECT_NO_THROW(checkShaft(shaft));
    for (const double wrong : {0.0, -3.0, std::nan(""), std::numeric_limits<double>::infinity()})
        EXPECT_EQ(codeOf([&] { setDiameter(turnedRows(), 1, wrong); }), errors::shaftRowWrong.key);
}

TEST(ShaftSizes, TiedRowsShareOneDiameter)
{
    ShaftRows rows = tieDiameters(turnedRows(), 3, 1);
    EXPECT_EQ(tiedTo(rows, 1), std::vector<std::size_t>{3});
    rows = setDiameter(rows, 3, 29);
    EXPECT_DOUBLE_EQ(rows[1].start_diameter_mm, 29);
    EXPECT_DOUBLE_EQ(rows[0].end_diameter_mm, 29);
    EXPECT_DOUBLE_EQ(rows[4].start_diameter_mm, 29);
    rows = tieDiameters(rows, 8, 1);
    EXPECT_DOUBLE_EQ(rows[8].end_diameter_mm, 29);
    EXPECT_EQ(tiedTo(rows, 8).size(), 2u);
    ShaftRows typed = rows;
    typed[8].start_diameter_mm = typed[8].end_diameter_mm = 33;
    typed = followTies(rows, typed);
    EXPECT_DOUBLE_EQ(typed[1].start_diameter_mm, 33);
    EXPECT_DOUBLE_EQ(typed[3].start_diameter_mm, 33);
    rows = deleteRow(rows, 2, KeepAfter::Places);  // a tie belongs to its row, whatever its number
    EXPECT_EQ(tiedTo(rows, 1), (std::vector<std::size_t>{2, 7}));
    rows = untieDiameter(untieDiameter(rows, 7), 1);
    for (const ShaftSegment& row : rows) EXPECT_TRUE(row.tie.empty());
    EXPECT_EQ(codeOf([] { tieDiameters(turnedRows(), 0, 1); }), errors::shaftRowWrong.key);
}

TEST(ShaftSizes, LengthsHoldPlacesOrLengthsAfterThem)
{
    const ShaftRows places = setLength(turnedRows(), 3, 4, 20, KeepAfter::Places);
    EXPECT_DOUBLE_EQ(places[3].length_mm, 19);
    EXPECT_DOUBLE_EQ(places[5].length_mm, 0.5);  // minor: goes along
    EXPECT_DOUBLE_EQ(places[6].length_mm, 28);
    EXPECT_DOUBLE_EQ(length(places), length(turnedRows()));
    const ShaftRows chain = setLength(turnedRows(), 3, 4, 20, KeepAfter::Lengths);
    EXPECT_DOUBLE_EQ(chain[6].length_mm, 30);
    EXPECT_DOUBLE_EQ(length(chain), length(turnedRows()) + 2);
    const ShaftRows moved = moveShoulder(turnedRows(), 4, 45, KeepAfter::Places);  // was at 41
    EXPECT_DOUBLE_EQ(startOf_mm(moved, 5), 45);
    EXPECT_DOUBLE_EQ(startOf_mm(moved, 3), startOf_mm(turnedRows(), 3));
    EXPECT_DOUBLE_EQ(length(moved), length(turnedRows()));
    const ShaftRows longer = moveShoulder(turnedRows(), 8, 150, KeepAfter::Places);  // the end of the part
    EXPECT_DOUBLE_EQ(length(longer), 150);
    EXPECT_EQ(codeOf([] { moveShoulder(turnedRows(), 4, 75, KeepAfter::Places); }), errors::shaftRowWrong.key);
    EXPECT_EQ(codeOf([] { moveShoulder(turnedRows(), 4, 3, KeepAfter::Places); }), errors::shaftRowWrong.key);
}

TEST(ShaftSizes, ChamfersArcsConesAndGrooves)
{
    ShaftRows rows = setChamfer(turnedRows(), 0, 2, 30);
    EXPECT_NEAR(rows[0].start_diameter_mm, 30 - 4 * std::tan(std::numbers::pi / 6), 1e-12);
    EXPECT_DOUBLE_EQ(rows[0].end_diameter_mm, 30);
    EXPECT_DOUBLE_EQ(rows[1].length_mm, 19);
    EXPECT_DOUBLE_EQ(length(rows), length(turnedRows()));
    rows = setArcRadius(turnedRows(), 4, 2);  // a quarter: grows over the cylinder before it
    EXPECT_DOUBLE_EQ(rows[4].length_mm, 2);
    EXPECT_DOUBLE_EQ(rows[4].end_diameter_mm, 34);
    EXPECT_DOUBLE_EQ(*rows[4].arc_radius_mm, -2);
    EXPECT_DOUBLE_EQ(rows[3].length_mm, 16);
    const ShaftRows barrel = setArcRadius({{30, 40, 40, 0, 200, ""}}, 0, 5);
    EXPECT_NEAR(*barrel[0].arc_radius_mm, 15, 1e-9);  // half its chord
    rows = setConeAngle(turnedRows(), 7, 2);
    EXPECT_DOUBLE_EQ(rows[7].end_diameter_mm, 46);
    EXPECT_NEAR(rows[7].start_diameter_mm, 46 - 80 * std::tan(2 * std::numbers::pi / 180), 1e-12);
    rows = setGroove(turnedRows(), 2, 2, 3, 26);
    EXPECT_DOUBLE_EQ(rows[2].length_mm, 3);
    EXPECT_DOUBLE_EQ(rows[2].end_diameter_mm, 26);
    EXPECT_DOUBLE_EQ(length(rows), length(turnedRows()));
    EXPECT_EQ(codeOf([] { setChamfer(turnedRows(), 0, 25, 45); }), errors::shaftRowWrong.key);
    EXPECT_EQ(codeOf([] { setChamfer(turnedRows(), 0, 1, 90); }), errors::shaftRowWrong.key);
    EXPECT_EQ(codeOf([] { setConeAngle(turnedRows(), 7, 60); }), errors::shaftRowWrong.key);
}

TEST(ShaftSizes, WhatWasMeasuredIsKeptBesideAnEditedValue)
{
    const ShaftRows edited = keepMeasured(turnedRows(), setDiameter(turnedRows(), 1, 32));
    ASSERT_TRUE(edited[1].measured);
    EXPECT_DOUBLE_EQ(*edited[1].measured->start_diameter_mm, 30);
    EXPECT_FALSE(edited[6].measured);
    EXPECT_TRUE(edited[0].measured);  // the chamfer went along
}

TEST(ShaftItem, KeepsWhatItWasRecoveredFrom)
{
    Shaft shaft;
    shaft.segments = turnedRows();
    shaft.recovered = {"worn.ply", std::string(64, 'a'), "robust"};
    EXPECT_EQ(shaftOf(toValues(shaft)), shaft);
    EXPECT_EQ(*find(toValues(shaft), "recovered_from_scan"), Value(std::string("worn.ply")));
}

}  // namespace
}  // namespace lathelier
