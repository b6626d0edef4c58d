#include "engine/trajectory/trajectory_report.h"
#include "engine/io/io_codes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "engine/io/file.h"
#include "engine/report/html.h"
#include "engine/report/plain_text.h"
#include "engine/sample/sample_record.h"
#include "engine/trajectory/section_file.h"
#include "engine/trajectory/trajectory_plots.h"
#include "engine/trajectory/trajectory_quantities.h"
#include "tests/scratch_folder.h"

namespace lathelier::trajectory {
namespace {

template <class Record>
TrajectoryResult resultOf(Record record, const TrajectoryParameters& parameters = {})
{
    std::vector<io::ProbeFile> files(1);
    files[0].facts.path = record.name;
    files[0].record = std::move(record);
    return trajectory(files, parameters);
}

sample::SpindleModel fourSectionModel()
{
    sample::SpindleModel model = sample::quietSpindle();
    model.sections = 4;
    model.revolutions = 5;
    model.whirl_um = 0.5;
    return model;
}

TrajectoryResult rawResult(std::optional<double> tolerance_um = {})
{
    TrajectoryParameters parameters;
    parameters.revolutions = 5;
    parameters.form.tolerance_um = tolerance_um;
    return resultOf(sample::makeProbeRecord(fourSectionModel()), parameters);
}

std::size_t count(const std::string& text, const std::string& part)
{
    std::size_t found = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
    return found;
}

TEST(TrajectoryReport, TheAnswerGivesTheWorstSectionTaperBarrelAndVerdict)
{
    TrajectoryResult result = rawResult(50);
    const std::string answerText = report::plainText(answer(result));
    EXPECT_TRUE(answerText.starts_with("RONt(MZCI) ")) << answerText;
    for (const char* part :
         {" of 4 is the worst", "no filter", "Taper +16.", "Barrel ", "limit 50\u00A0µm", "✓ within"})
        EXPECT_NE(answerText.find(part), std::string::npos) << part << " in " << answerText;
    EXPECT_EQ(answer(result).verdict, Verdict::Pass);
    EXPECT_EQ(answer(result).expanded_uncertainty,
              result.sections[*result.worstSection()].roundness.RONt_expanded_uncertainty_um);
    result.longitudinal->barrel_um = -5.04;
    result.longitudinal->taper_diameter_um = -3.21;
    EXPECT_NE(report::plainText(answer(result)).find("Saddle 5.0"), std::string::npos);
    EXPECT_NE(report::plainText(answer(result)).find("Taper -3.2"), std::string::npos);
    EXPECT_EQ(answer(rawResult(0.5)).verdict, Verdict::Fail);
    EXPECT_EQ(answer(rawResult()).verdict, std::nullopt);
    EXPECT_FALSE(answer(TrajectoryResult{}).value);
}

TEST(TrajectoryReport, HoldsWhatAnAuditAsksFor)
{
    const std::string html = report::toHtml(trajectoryReport(rawResult(50), {{"record.csv", 4711, "0123abcd"}}));
    for (const char* part : {"Longitudinal section",
                             "Taper on diameter",
                             "GOST 24642-81",
                             "Cylindricity",
                             "All sections",
                             "within tolerance",
                             "Profile and reference circle",
                             "Trajectories over one turn",
                             "Error motion",
                             "asynchronous",
                             "rotating direction",
                             "single revolutions",
                             "run-out",
                             "Cutting data",
                             "shaft D50 of steel C45",
                             "0.125",
                             "Parameters",
                             "record.csv",
                             "0123abcd",
                             "mandrel",
                             "nominal"})
        EXPECT_NE(html.find(part), std::string::npos) << part;
    const std::size_t body = html.find("</style>");
    EXPECT_EQ(html.find('{', body), std::string::npos) << "an unfilled pattern";
}

TEST(TrajectoryReport, SyntheticDataAreMarked)
{
    TrajectoryResult result = rawResult();
    EXPECT_FALSE(trajectoryReport(result, {}).synthetic);
    result.notes.push_back({notes::syntheticData, {{"path", "record.csv"}}});
    EXPECT_TRUE(trajectoryReport(result, {}).synthetic);
}

TEST(TrajectoryReport, AveragesAndEmptyResultsMakeAReportToo)
{
    const std::string html =
        report::toHtml(trajectoryReport(resultOf(sample::makeAveragedRecord(fourSectionModel())), {}));
    EXPECT_NE(html.find("Longitudinal section"), std::string::npos);
    EXPECT_EQ(html.find("images of single revolutions"), std::string::npos);
    EXPECT_EQ(html.find("nan"), std::string::npos);
    EXPECT_NE(report::toHtml(trajectoryReport(TrajectoryResult{}, {})).find("</html>"), std::string::npos);
    EXPECT_FALSE(report::toPlainText(trajectorySummary(TrajectoryResult{})).find("nan") != std::string::npos);
}

TEST(TrajectoryPlots, EveryRevolutionStandsInThePolarPlot)
{
    const TrajectoryResult result = rawResult();
    const report::PolarPlot plot = errorMotionPlot(result.sections[1], 50);
    ASSERT_EQ(plot.traces.size(), 6u);
    for (std::size_t i = 0; i < plot.traces.size(); ++i) {
        EXPECT_EQ(plot.traces[i].angle_deg.size(), i == 4 ? 200u : 201u);  // the last one runs into nothing
        EXPECT_EQ(plot.traces[i].deviation_um.size(), plot.traces[i].angle_deg.size());
        EXPECT_EQ(plot.traces[i].thin, i < 5);
    }
    EXPECT_EQ(errorMotionPlot(resultOf(sample::makeAveragedRecord(fourSectionModel())).sections[0], 50).traces.size(),
              1u);
}

TEST(TrajectoryJson, NumbersThatDoNotExistAreNull)
{
    const Json raw = toJson(rawResult(50));
    EXPECT_EQ(raw["sections"].size(), 4u);
    EXPECT_EQ(raw["sections"][0]["radius_mm"].size(), 200u);
    EXPECT_EQ(raw["sections"][0]["workpiece_axis"]["x_um"].size(), 200u);
    EXPECT_EQ(raw["verdict"], "pass");
    EXPECT_TRUE(raw["longitudinal"]["CYLt_LSCY_um"].is_number());
    const Json averaged = toJson(resultOf(sample::makeAveragedRecord(fourSectionModel())));
    EXPECT_TRUE(averaged["sections"][0]["spindle"]["asynchronous_um"].is_null());
    EXPECT_TRUE(averaged["verdict"].is_null());
    TrajectoryResult nowhere = rawResult();
    nowhere.longitudinal.reset();
    nowhere.sections[0].z_mm = NAN;
    EXPECT_TRUE(toJson(nowhere)["longitudinal"].is_null());
    EXPECT_TRUE(toJson(nowhere)["sections"][0]["z_mm"].is_null());
}

TEST(SectionFile, OneRowForEachSectionAndOneForEachPoint)
{
    const ScratchFolder folder;
    const std::string table = (folder / "sections.csv").string();
    const std::string images = (folder / "images.csv").string();
    TrajectoryResult result = rawResult();
    result.sections[1].z_mm = NAN;
    writeSectionTable(table, result);
    writeImages(images, result);
    const io::FileBytes written(table);
    const std::string rows(written.view());
    EXPECT_EQ(count(rows, "\n"), 5u);
    EXPECT_NE(rows.find("\n2,,5,"), std::string::npos);
    const io::FileBytes points(images);
    EXPECT_EQ(count(std::string(points.view()), "\n"), 1 + 4 * 200u);
}

}  // namespace
}  // namespace lathelier::trajectory
