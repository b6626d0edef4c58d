// The rows of a drawing against those of a recognised part.
#include "engine/features/comparison/nominal_rows.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "engine/features/comparison/shaft_comparison.h"
#include "engine/features/nominal/standards.h"
#include "made_recognition.h"
#include "made_scan.h"

namespace lathelier::features {
namespace {

Shaft drawingOf(const Table& table)
{
    Shaft shaft;
    for (const TableRow& row : table)
        shaft.segments.push_back({row.length_mm, row.start_mm, row.end_mm, 0, row.arc_mm, {}});
    return shaft;
}

/// The same part seen from its other end.
Recognition turned(const Table& table)
{
    Table back;
    for (auto row = table.rbegin(); row != table.rend(); ++row)
        back.push_back({row->length_mm, row->end_mm, row->start_mm, row->arc_mm});
    return recognitionOf(back);
}

const ComparedRow& rowOf(const std::vector<ComparedRow>& rows, std::int64_t row, const std::string& quantity)
{
    for (const ComparedRow& one : rows)
        if (one.row == row && one.quantity == quantity && !one.bore) return one;
    throw std::logic_error("no such row: " + quantity);
}

TEST(GeneralTolerance, TablesOneAndTwo)
{
    EXPECT_EQ(parseGeneralTolerance("ISO 2768-m"), GeneralClass::Medium);
    EXPECT_EQ(parseGeneralTolerance("ISO 2768-fH"), GeneralClass::Fine);
    for (const char* other : {"", "ISO 2768-", "ISO 2768-x", "ISO 2768-mkK", "ISO 8062-3", "m"})
        EXPECT_FALSE(parseGeneralTolerance(other)) << other;
    EXPECT_EQ(generalTolerance_mm(30, GeneralClass::Fine), 0.1);
    EXPECT_EQ(generalTolerance_mm(30.01, GeneralClass::Fine), 0.15);
    EXPECT_EQ(generalTolerance_mm(183), 0.5);
    EXPECT_EQ(generalTolerance_mm(5, GeneralClass::Coarse), 0.3);
    EXPECT_EQ(generalTolerance_mm(183, GeneralClass::VeryCoarse), 2.5);
    EXPECT_FALSE(generalTolerance_mm(3, GeneralClass::VeryCoarse));
    EXPECT_FALSE(generalTolerance_mm(2001, GeneralClass::Fine));
    EXPECT_EQ(generalEdgeTolerance_mm(1), 0.2);
    EXPECT_EQ(generalEdgeTolerance_mm(5, GeneralClass::Coarse), 1);
    EXPECT_EQ(generalEdgeTolerance_mm(50, GeneralClass::Fine), 1);
    EXPECT_FALSE(generalEdgeTolerance_mm(0.4));
}

TEST(NominalRows, DeviationsAndLimits)
{
    Shaft drawing = drawingOf(tableOne());
    drawing.general_tolerance = "ISO 2768-m";
    drawing.segments[0].tolerance = SizeTolerance{"h6", {}, {}};
    drawing.segments[1].tolerance = SizeTolerance{"", -30, {}};
    drawing.segments[3].role = "chamfer";
    Table made = tableOne();
    made[0] = {98.2, 29.99, 29.99};
    made[1] = {9.9, 36.95, 36.95};
    made[3] = {5.1, 33.8, 23.6};
    const auto rows = compareRows(drawing, recognitionOf(made), DecisionRule::Simple);
    ASSERT_EQ(rows.size(), 9U);
    const ComparedRow& seat = rowOf(rows, 1, "diameter");
    EXPECT_NEAR(seat.deviation_mm.value(), -0.01, 1e-12);
    EXPECT_NEAR(seat.uncertainty_mm.value(), 0.001, 1e-12);
    EXPECT_NEAR(seat.lower_mm.value(), -0.013, 1e-12);
    EXPECT_EQ(seat.upper_mm, 0);
    EXPECT_EQ(seat.verdict, Verdict::Pass);
    EXPECT_NEAR(rowOf(rows, 1, "length").deviation_mm.value(), 0.2, 1e-9);
    EXPECT_NEAR(rowOf(rows, 1, "length").uncertainty_mm.value(), 0.007, 1e-12);
    EXPECT_EQ(rowOf(rows, 1, "length").verdict, Verdict::Pass);  // 98: ±0.3
    EXPECT_EQ(rowOf(rows, 2, "diameter").verdict, Verdict::Fail);
    EXPECT_FALSE(rowOf(rows, 2, "diameter").upper_mm);
    EXPECT_EQ(rowOf(rows, 3, "diameter").upper_mm, 0.3);
    EXPECT_EQ(rowOf(rows, 4, "length").upper_mm, 0.5);  // a broken edge
    EXPECT_NEAR(rowOf(rows, 4, "end_diameter").deviation_mm.value(), -0.2, 1e-9);
    EXPECT_FALSE(rowOf(rows, 4, "end_diameter").verdict);
    EXPECT_EQ(worstVerdict(rows), Verdict::Fail);
}

TEST(NominalRows, GuardedLeavesOpenWhatIsTooNear)
{
    Shaft drawing = drawingOf(tableOne());
    drawing.segments[2].tolerance = SizeTolerance{{}, -20, 0};
    Table made = tableOne();
    made[2].start_mm = made[2].end_mm = made[3].start_mm = 33.8 - 0.0195;
    EXPECT_EQ(rowOf(compareRows(drawing, recognitionOf(made), DecisionRule::Simple), 3, "diameter").verdict,
              Verdict::Pass);
    EXPECT_EQ(rowOf(compareRows(drawing, recognitionOf(made), DecisionRule::Guarded), 3, "diameter").verdict,
              Verdict::Undecided);
}

TEST(NominalRows, WithoutLimitsThereIsNoVerdict)
{
    const auto rows = compareRows(drawingOf(tableOne()), recognitionOf(tableOne()), DecisionRule::Simple);
    for (const ComparedRow& row : rows) {
        EXPECT_NEAR(row.deviation_mm.value(), 0, 1e-9);
        EXPECT_FALSE(row.verdict);
        EXPECT_FALSE(row.lower_mm);
    }
    EXPECT_FALSE(worstVerdict(rows));
}

TEST(NominalRows, EitherEndFirst)
{
    for (const Table& table : {tableOne(), taperPart(), undercutPart()}) {
        const Shaft drawing = drawingOf(table);
        for (const ComparedRow& row : compareRows(drawing, turned(table), DecisionRule::Simple)) {
            SCOPED_TRACE(row.quantity + " of row " + std::to_string(row.row));
            ASSERT_TRUE(row.deviation_mm);
            EXPECT_NEAR(*row.deviation_mm, 0, 1e-9);
        }
    }
}

TEST(NominalRows, ArcsAreRadii)
{
    Shaft drawing = drawingOf(taperPart());
    drawing.general_tolerance = "ISO 2768-f";
    const auto rows = compareRows(drawing, recognitionOf(taperPart()), DecisionRule::Simple);
    EXPECT_EQ(rowOf(rows, 1, "arc_radius").upper_mm, 0.2);     // a broken edge of radius 1
    EXPECT_EQ(rowOf(rows, 3, "arc_radius").upper_mm, 0.05);    // a fillet of radius 0.8
    EXPECT_EQ(rowOf(rows, 9, "arc_radius").nominal_mm, 60.0);  // hollow: without a sign
    EXPECT_NEAR(rowOf(rows, 9, "arc_radius").measured_mm.value(), 60, 1e-9);
    EXPECT_NEAR(rowOf(rows, 9, "arc_radius").uncertainty_mm.value(), 0.012, 1e-12);
    EXPECT_FALSE(rowOf(rows, 9, "length").verdict);
}

TEST(NominalRows, WhatIsNotThereIsUndecided)
{
    Shaft drawing = drawingOf(tableOne());
    drawing.general_tolerance = "ISO 2768-m";
    const Table made = cylinder(30, 98) + cylinder(33.8, 80) + cone(33.8, 23.8, 5);
    const auto rows = compareRows(drawing, recognitionOf(made), DecisionRule::Simple);
    EXPECT_FALSE(rowOf(rows, 2, "diameter").measured_mm);
    EXPECT_FALSE(rowOf(rows, 2, "diameter").deviation_mm);
    EXPECT_EQ(rowOf(rows, 2, "diameter").verdict, Verdict::Undecided);
    EXPECT_EQ(rowOf(rows, 1, "diameter").verdict, Verdict::Pass);
    EXPECT_EQ(rowOf(rows, 3, "length").verdict, Verdict::Fail);
}

TEST(NominalRows, WearCutsACylinderIntoPieces)
{
    Shaft drawing = drawingOf(tableOne());
    drawing.segments[2].tolerance = SizeTolerance{{}, -50, 300};
    const Table made = cylinder(30, 98) + cylinder(37, 10) + cone(33.8, 34, 20) + cylinder(34.12, 30) +
                       cone(34, 33.8, 20) + cone(33.8, 23.8, 5);
    const auto rows = compareRows(drawing, recognitionOf(made), DecisionRule::Simple);
    const ComparedRow& seat = rowOf(rows, 3, "diameter");
    EXPECT_NEAR(seat.measured_mm.value(), (33.9 * 40 + 34.12 * 30) / 70, 1e-9);
    EXPECT_NEAR(seat.largest_mm.value(), 34.12, 1e-9);
    EXPECT_EQ(seat.verdict, Verdict::Fail);  // the mean is within, the largest is not
    EXPECT_NEAR(rowOf(rows, 3, "length").deviation_mm.value(), 0, 1e-9);
    EXPECT_NEAR(rowOf(rows, 3, "length").uncertainty_mm.value(), std::hypot(0.005, 0.005), 1e-12);
    EXPECT_NEAR(rowOf(rows, 4, "length").deviation_mm.value(), 0, 1e-9);
}

TEST(NominalRows, Bores)
{
    Shaft drawing = drawingOf(cylinder(40, 30) + cylinder(60, 10));
    drawing.general_tolerance = "ISO 2768-m";
    drawing.bores = {{ShaftEnd::Chuck, {{10, 30, 30, {}, {}}, {5, 30, 20, {}, {}}}}};
    Recognition part = recognitionOf(cylinder(40, 30) + cylinder(60, 10));
    part.bores = {rowsOf(cone(20.1, 30.1, 5) + cylinder(30.1, 10), 25)};
    const auto rows = compareRows(drawing, part, DecisionRule::Simple);
    ASSERT_EQ(rows.size(), 9U);
    const auto& bore = *(rows.end() - 5);
    EXPECT_EQ(bore.bore, 1);
    EXPECT_EQ(bore.row, 1);
    EXPECT_EQ(bore.quantity, "diameter");
    EXPECT_NEAR(bore.deviation_mm.value(), 0.1, 1e-9);
    EXPECT_EQ(bore.verdict, Verdict::Pass);
    EXPECT_EQ(rows[6].quantity, "start_diameter");
    EXPECT_EQ(rows[6].nominal_mm, 30);
    EXPECT_NEAR(rows[6].deviation_mm.value(), 0.1, 1e-9);
    EXPECT_EQ(rows[7].nominal_mm, 20);
    EXPECT_NEAR(rows[7].deviation_mm.value(), 0.1, 1e-9);
}

TEST(NominalRows, BoresThatTheRowsState)
{
    Shaft drawing = drawingOf(cylinder(40, 30) + cylinder(60, 10) + cylinder(50, 20));
    for (std::size_t i = 0; i < 2; ++i) drawing.segments[i].bore_diameter_mm = 20;
    drawing.general_tolerance = "ISO 2768-m";
    Recognition part = recognitionOf(cylinder(40, 30) + cylinder(60, 10) + cylinder(50, 20));
    part.bores = {rowsOf(cylinder(20.3, 40))};
    const auto rows = compareRows(drawing, part, DecisionRule::Simple);
    ASSERT_EQ(rows.size(), 8U);  // one row of the bore, though two of the outside state it
    EXPECT_EQ(rows[6].bore, 1);
    EXPECT_EQ(rows[6].quantity, "diameter");
    EXPECT_EQ(rows[6].nominal_mm, 20);
    EXPECT_NEAR(rows[6].deviation_mm.value(), 0.3, 1e-9);
    EXPECT_EQ(rows[6].verdict, Verdict::Fail);
    EXPECT_EQ(rows[7].quantity, "length");
    EXPECT_EQ(rows[7].nominal_mm, 40);
}

/// The practice copy, scanned askew: taper ±30 µm, a collar 50 µm over, a barrel of 40 µm, all on the radius.
TEST(ShaftComparison, ThePracticeCopyAgainstTheDrawing)
{
    Shaft drawing = drawingOf(tableOne());
    drawing.general_tolerance = "ISO 2768-m";
    drawing.segments[3].role = "chamfer";
    drawing.segments[1].tolerance = SizeTolerance{"h6", {}, {}};
    registration::CompareParameters parameters;
    parameters.tolerance_mm = 0.3;
    const Scan copy = sample::scanShaft(sample::copiedShaft(), askew(5));
    const ShaftComparison found = compareWithShaft(drawing, copy, parameters, {}, registration::CompareDetail::Summary);
    EXPECT_EQ(found.surface.verdict, Verdict::Pass);
    EXPECT_EQ(found.verdict, Verdict::Fail);  // the collar
    const ComparedRow& collar = rowOf(found.rows, 2, "diameter");
    EXPECT_NEAR(collar.deviation_mm.value(), 0.1, 0.004);
    EXPECT_EQ(collar.verdict, Verdict::Fail);
    EXPECT_NEAR(rowOf(found.rows, 1, "diameter").deviation_mm.value(), 0, 0.01);
    EXPECT_NEAR(rowOf(found.rows, 1, "length").deviation_mm.value(), 0, 0.03);
    EXPECT_NEAR(rowOf(found.rows, 3, "diameter").deviation_mm.value(), 2 * 0.040 * 2 / 3, 0.003);
    EXPECT_NEAR(rowOf(found.rows, 3, "length").deviation_mm.value(), 0, 0.1);
    const Eigen::Isometry3d off = found.surface.alignment.reference_T_copy * askew(5).scan_T_part;
    EXPECT_NEAR(off.translation().z(), 0, 0.02);
    EXPECT_LT(off.linear().col(2).head<2>().norm(), 1e-4);
    EXPECT_LT(off.translation().head<2>().norm(), 0.005);
}

TEST(ShaftComparison, WhatCannotBeRecognisedIsSaid)
{
    Shaft drawing = drawingOf(cylinder(30, 98) + cylinder(37, 10) + cylinder(33.8, 75));
    Scan copy;  // a narrow strip of the part
    for (int i = 0; i < 60000; ++i) {
        const double z = 183.0 * (i % 2000) / 2000, angle = 0.8 * (i / 2000) / 30;
        const double radius = z < 98 ? 15 : z < 108 ? 18.5 : 16.9;
        copy.points_mm.emplace_back(radius * std::cos(angle), radius * std::sin(angle), z);
    }
    registration::CompareParameters parameters;
    parameters.symmetry = registration::Symmetry::None;
    const ShaftComparison found = compareWithShaft(drawing, copy, parameters, {}, registration::CompareDetail::Summary);
    EXPECT_TRUE(contains(found.surface.notes, {"sizes_not_recognized", Severity::Warning, {}}));
    ASSERT_EQ(found.rows.size(), 6U);
    EXPECT_FALSE(found.rows[0].measured_mm);
    EXPECT_FALSE(found.verdict);
}

}  // namespace
}  // namespace lathelier::features
