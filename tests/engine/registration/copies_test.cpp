// Several copies of one original as a table and as a trend.
#include "engine/registration/copies.h"

#include <gtest/gtest.h>

#include <cmath>

#include "engine/io/io_codes.h"
#include "tests/engine/registration/made_result.h"

namespace lathelier::registration {
namespace {

std::vector<CopySummary> threeCopies()
{
    CompareResult result = madeResult();
    WorstPlace worst;
    worst.z_mm = 104.4;
    worst.deviation_mm = 0.053;
    worst.uncertainty_mm = 0.003;
    result.worst = worst;
    result.verdict = Verdict::Pass;
    CopySummary refused;
    refused.name = "broken.ply";
    refused.error = Error(errors::fileEmpty, {{"path", std::string("broken.ply")}});
    CopySummary other = summaryOf("second.ply", result);
    other.worst->deviation_mm = -0.02;
    return {summaryOf("first.ply", result), refused, other};
}

TEST(Copies, EachHasItsRowAndARefusedOneSaysWhy)
{
    const report::Table table = copiesTable(threeCopies());
    ASSERT_EQ(table.rows.size(), 3U);
    for (const std::vector<Value>& row : table.rows) EXPECT_EQ(row.size(), table.columns.size());
    EXPECT_EQ(std::get<std::string>(table.rows[0][0]), "first.ply");
    EXPECT_EQ(std::get<double>(table.rows[0][2]), 0.053);
    EXPECT_NE(std::get<std::string>(table.rows[1][1]).find("empty"), std::string::npos);
    EXPECT_TRUE(std::holds_alternative<std::monostate>(table.rows[1][2]));
}

TEST(Copies, TheTrendHasAGapWhereThereAreNoNumbers)
{
    CompareParameters parameters;
    parameters.tolerance_mm = 0.1;
    const report::Plot plot = copiesTrend(threeCopies(), parameters);
    EXPECT_EQ(plot.limits.size(), 2U);
    const report::Curve& worst = plot.curves.back();
    ASSERT_EQ(worst.y.size(), 3U);
    EXPECT_EQ(worst.y[0], 0.053);
    EXPECT_TRUE(std::isnan(worst.y[1]));
    EXPECT_EQ(worst.y[2], -0.02);
    const report::Curve& reach = plot.curves.front();
    EXPECT_NEAR(reach.y[0], 0.050, 1e-12);
    EXPECT_NEAR(reach.y[1], 0.056, 1e-12);
    EXPECT_EQ(plot.x.range->to, 3.5);
}

}  // namespace
}  // namespace lathelier::registration
