// Report of a recognition: tables, charts, accepted sizes, the part of a shaft outside the chuck.
#include "engine/features/report/recognition_report.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <regex>

#include "engine/features/nominal/roles.h"
#include "engine/features/nominal/snap.h"
#include "engine/features/report/recognition_plots.h"
#include "engine/features/stock_part.h"
#include "engine/report/plain_text.h"
#include "engine/shaft/shaft_contour.h"
#include "tests/engine/features/made_recognition.h"

namespace lathelier::features {
namespace {

Recognition describedPart(const Table& table)
{
    Recognition result = recognitionOf(table);
    describeRows(result);
    result.shaft = measuredShaft(result);
    for (std::size_t i = 0; i < result.segments.size(); ++i) {
        const RecognizedRow& row = result.segments[i];
        for (double z = row.z_start_mm + 0.05; z < row.z_end_mm; z += 0.1)
            result.meridian.push_back({z, row.start_diameter_mm / 2, 0.003, 0.001, static_cast<std::int32_t>(i)});
    }
    return result;
}

std::vector<const report::Curve*> named(const report::Plot& plot, const char* name)
{
    std::vector<const report::Curve*> found;
    for (const report::Curve& curve : plot.curves)
        if (report::captionText(curve.name) == name) found.push_back(&curve);
    return found;
}

TEST(RecognitionReport, AnswersWithLengthAndLargestDiameter)
{
    Recognition result = describedPart(tableOne());
    result.length_uncertainty_mm = 0.012;
    const std::string said = std::regex_replace(plainText(answer(result)), std::regex("\u00a0"), std::string(1, ' '));
    EXPECT_NE(said.find("Length 183.000 ± 0.012 mm"), std::string::npos) << said;
    EXPECT_NE(said.find("37.000 mm ± 1.0 µm · 4 rows"), std::string::npos) << said;
    result.length_mm.reset();
    result.gaps = {{40, 50}};
    const report::Answer open = answer(result);
    EXPECT_FALSE(open.value);
    ASSERT_FALSE(open.findings.empty());
    EXPECT_EQ(open.findings.front().place.z_mm, (Interval{40, 50}));
}

TEST(RecognitionReport, SaysWhereAnUndecidedEndMayLie)
{
    Recognition result = describedPart(tableOne());
    result.length_mm.reset();
    result.ends = {{}, {}};
    result.ends[1].closed_by = "undecided";
    result.ends[1].span_mm = Interval{182.4, 183.1};
    result.gaps = {{40, 50}};
    const report::Answer open = answer(result);
    EXPECT_EQ(open.findings.front().place.z_mm, (Interval{182.4, 183.1}));
    EXPECT_LE(open.findings.size(), 3u);
    const std::string said = std::regex_replace(plainText(open), std::regex("\u00a0"), std::string(1, ' '));
    EXPECT_NE(said.find("Chuck end not decided: it lies from z 182.400 to 183.100 mm"), std::string::npos) << said;
    EXPECT_EQ(said.find("Free end not decided"), std::string::npos) << said;
    result.ends[0] = result.ends[1];
    result.ends[0].span_mm = Interval{-0.6, 0.1};
    EXPECT_EQ(answer(result).findings.front().place.z_mm, (Interval{-0.6, 0.1}));
}

TEST(RecognitionReport, PutsUncertaintiesBesideValues)
{
    Recognition result = describedPart(tableOne());
    result.bores = {rowsOf(cylinder(12, 20))};
    const report::Table table = rowsTable(result);
    ASSERT_EQ(table.rows.size(), 5u);
    EXPECT_EQ(std::get<std::string>(table.rows[0][2]), "30.0000 ± 0.0010");
    EXPECT_EQ(std::get<std::string>(table.rows[3][1]), "cone, chamfer");
    EXPECT_EQ(std::get<std::string>(table.rows[4][0]), "B1.1");
    EXPECT_NE(std::get<std::string>(table.rows[0][nominalColumn]).find("⌀ 30"), std::string::npos);
    const std::string text = report::toPlainText(recognitionSummary(result));
    EXPECT_NE(text.find("cone, chamfer"), std::string::npos) << text;
    EXPECT_EQ(std::count(text.begin(), text.end(), '\0'), 0);
}

TEST(RecognitionReport, WritesRowsWithTheirUncertaintiesAsCsv)
{
    const std::string csv = rowsCsv(describedPart(tableOne()));
    EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 5);
    EXPECT_EQ(csv.substr(0, csv.find('\n')).find("start_diameter_U_um") != std::string::npos, true);
}

TEST(RecognitionPlots, ShareTheRangeOfZ)
{
    const Recognition result = describedPart(tableOne());
    const report::Plot meridian = meridianPlot(result), residuals = residualPlot(result);
    EXPECT_EQ(meridian.x.range, residuals.x.range);
    EXPECT_TRUE(meridian.equal_scales);
    EXPECT_EQ(named(meridian, "cylinder").size(), 1u);
    EXPECT_EQ(named(meridian, "arc").size(), 0u);
    const auto means = named(residuals, "mean of five bins");
    ASSERT_EQ(means.size(), 1u);
    for (const double residual_um : means.front()->y) {
        if (!std::isnan(residual_um)) {
            EXPECT_NEAR(residual_um, 1, 1e-9);
        }
    }
    ASSERT_EQ(residuals.limits.size(), 2u);
    EXPECT_DOUBLE_EQ(residuals.limits.back().place, 20);
}

TEST(RecognitionPlots, DrawArcsOnTheirCircle)
{
    const Recognition result = describedPart(taperPart());
    for (std::size_t i = 0; i < result.segments.size(); ++i) {
        const RecognizedRow& row = result.segments[i];
        if (!row.arc_radius_mm) continue;
        ContourPiece piece{{row.z_start_mm, row.start_diameter_mm / 2}, {row.z_end_mm, row.end_diameter_mm / 2}};
        piece.arc_radius_mm = *row.arc_radius_mm;
        for (const Eigen::Vector2d& point : contourOf(row))
            EXPECT_NEAR((point - piece.centre_mm()).norm(), std::abs(*row.arc_radius_mm), 1e-9) << "row " << i + 1;
    }
}

TEST(AcceptedSizes, KeepTheirTextAndDropWhatIsNone)
{
    const std::vector<AcceptedSize> sizes{{2, "diameter_mm"}, {5, "radius_mm"}};
    EXPECT_EQ(acceptedSizes(textOf(sizes)), sizes);
    EXPECT_TRUE(acceptedSizes("").empty());
    EXPECT_EQ(acceptedSizes(",x:y,3,:,7:,2:diameter_mm,"), (std::vector<AcceptedSize>{{2, "diameter_mm"}}));
}

TEST(AcceptedSizes, ChangeTheirRowAlone)
{
    Table table = tableOne();
    table[0].start_mm = table[0].end_mm = 30.004;
    table[1].start_mm = table[1].end_mm = 36.997;
    const Recognition result = describedPart(table);
    const Shaft shaft = withAccepted(result, {{1, "diameter_mm"}, {9, "diameter_mm"}, {2, "nothing"}});
    ASSERT_EQ(shaft.segments.size(), 4u);
    EXPECT_DOUBLE_EQ(shaft.segments[0].start_diameter_mm, 30);
    ASSERT_TRUE(shaft.segments[0].measured);
    EXPECT_DOUBLE_EQ(*shaft.segments[0].measured->start_diameter_mm, 30.004);
    EXPECT_DOUBLE_EQ(shaft.segments[1].start_diameter_mm, 36.997);
    EXPECT_EQ(withAccepted(result, {}), result.shaft);
}

TEST(StockPart, EndsAtTheChuck)
{
    const Shaft shaft = describedPart(tableOne()).shaft;
    EXPECT_NEAR(outOfChuck(shaft, 0).length_mm(), 183, 1e-9);
    const Shaft out = outOfChuck(shaft, 2);
    EXPECT_NEAR(out.length_mm(), 181, 1e-9);
    EXPECT_NEAR(out.segments.back().end_diameter_mm, 27.8, 1e-9);  // in the chamfer
    EXPECT_EQ(outOfChuck(shaft, 80).segments.size(), 2u);
    EXPECT_TRUE(outOfChuck(shaft, 500).segments.empty());
}

}  // namespace
}  // namespace lathelier::features
