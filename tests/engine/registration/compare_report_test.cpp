#include "engine/registration/compare_report.h"
#include "engine/io/io_codes.h"

#include <gtest/gtest.h>

#include "engine/registration/compare_plots.h"
#include "engine/report/html.h"
#include "tests/engine/registration/made_result.h"

namespace lathelier::registration {
namespace {

TEST(CompareReport, TheAnswerGivesNumberMethodAndVerdict)
{
    CompareResult result = madeResult();
    EXPECT_EQ(report::valueLine(answer(result)), "RMS deviation 0.0571\u00A0mm");
    EXPECT_EQ(report::sentenceText(answer(result)),
              "mean +0.0092\u00A0mm · body of revolution · 92.7\u00A0% of the points within ±0.1\u00A0mm");
    EXPECT_EQ(answer(result).verdict, Verdict::Fail);
    result.verdict = Verdict::Pass;
    EXPECT_EQ(answer(result).verdict, Verdict::Pass);
    result.verdict.reset();
    result.within_tolerance_percent.reset();
    result.statistics.mean_mm = -0.0092;
    EXPECT_EQ(report::sentenceText(answer(result)), "mean -0.0092\u00A0mm · body of revolution");
    EXPECT_EQ(answer(result).verdict, std::nullopt);
}

TEST(CompareReport, WithoutASignNoSignedNumberIsSaid)
{
    CompareResult result = madeResult();
    result.has_sign = false;
    EXPECT_EQ(report::sentenceText(answer(result)).find("mean"), std::string::npos);
    const std::string html = report::toHtml(compareReport(result, {}));
    EXPECT_EQ(html.find("0.0092"), std::string::npos);
    EXPECT_EQ(html.find("Median"), std::string::npos);
    EXPECT_NE(html.find("Root mean square"), std::string::npos);
    EXPECT_NE(html.find("without a sign"), std::string::npos);
}

TEST(CompareReport, HoldsWhatAnAuditAsksFor)
{
    const std::string html = report::toHtml(compareReport(madeResult(), {{"original.ply", 8785428, "0123abcd"}}));
    for (const char* part : {"out of tolerance",
                             "0.0571",
                             "92.70",
                             "0.1412",
                             "0.0781",
                             "Nearest-point figure",
                             "1.90",
                             "0.00021",
                             "rotation",
                             "original.ply",
                             "0123abcd",
                             "SHA-256",
                             "Lathelier",
                             "Tolerance",
                             "Roll about the axis is not determined",
                             "Unrolled surface: tolerance",
                             "Meridian",
                             "error drawn × 20",
                             "Histogram",
                             "Zones along the axis",
                             "8\u202F785\u202F428"})
        EXPECT_NE(html.find(part), std::string::npos) << part;
    EXPECT_EQ(html.find("{"), html.find("{", html.find("<style>"))) << "an unfilled pattern";
    EXPECT_EQ(html.find("{", html.find("</style>")), std::string::npos) << "an unfilled pattern";
}

TEST(CompareReport, SyntheticDataAreMarked)
{
    CompareResult result = madeResult();
    EXPECT_FALSE(compareReport(result, {}).synthetic);
    result.notes.push_back({notes::syntheticData, {{"path", "copy.ply"}}});
    EXPECT_TRUE(compareReport(result, {}).synthetic);
}

TEST(CompareReport, AResultWithoutAnAxisNeedsNoMap)
{
    CompareResult result = madeResult();
    result.method_used = CompareMethod::Plane;
    result.alignment.reference_axis.reset();
    result.unrolled.reset();
    result.meridian.reset();
    result.zones.clear();
    const std::string html = report::toHtml(compareReport(result, {}));
    EXPECT_EQ(html.find("Unrolled"), std::string::npos);
    EXPECT_NE(html.find("point to plane"), std::string::npos);
}

TEST(CompareReport, AnEmptyResultStillMakesAReport)
{
    CompareResult result;
    result.meridian = Meridian{};
    result.unrolled = UnrolledMap{};
    EXPECT_NE(report::toHtml(compareReport(result, {})).find("</html>"), std::string::npos);
}

TEST(ComparePlots, TheMapKeepsLengthAndAngleApart)
{
    CompareResult result = madeResult();
    result.unrolled = UnrolledMap{1, 2, 3, 2, {11, 12, 21, 22, 31, 32}};  // z slow
    const report::ColourMap map = unrolledMap(result, false);
    EXPECT_EQ(map.columns, 3);
    EXPECT_EQ(map.rows, 2);
    EXPECT_EQ(map.values, (std::vector<float>{11, 21, 31, 12, 22, 32}));
    EXPECT_EQ(map.x_from, 1);
    EXPECT_EQ(map.x_to, 7);
    EXPECT_FALSE(map.tolerance);
    EXPECT_EQ(unrolledMap(result, true).tolerance, 0.1);
}

TEST(ComparePlots, MagnificationIsRoundAndShowsTheDeviation)
{
    CompareResult result = madeResult();
    const double factor = magnification(result);
    EXPECT_EQ(factor, 20);
    const report::Plot plot = magnifiedMeridian(result);
    EXPECT_NEAR(plot.curves[3].y[200] - plot.curves[2].y[200], factor * result.meridian->deviation_mm[200], 1e-9);
    for (double& deviation_mm : result.meridian->deviation_mm) deviation_mm /= 100;
    EXPECT_EQ(magnification(result), 2000);
    for (double& deviation_mm : result.meridian->deviation_mm) deviation_mm = 0;
    EXPECT_EQ(magnification(result), 1);
}

}  // namespace
}  // namespace lathelier::registration
