// Correction: the direct formula, the corrected program, its corners, robustness, refusals.
#include "engine/deflection/compensation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "../core/code_of_error.h"
#include "case_a.h"
#include "engine/deflection/deflection_codes.h"

namespace lathelier::deflection {
namespace {

TEST(Compensation, DirectFormulaOfCaseA)
{
    TurningSetup setup = caseASetup();
    const std::vector<ToolRun> runs = caseARuns();
    const WorkPlan plan = workPlan(caseAStock(), runs, setup);
    TurningWork work(plan, setup);
    std::vector<Station> stations;
    work.take(plan.cuts.front(), CutTask::Correct, stations);
    const auto diameterAt = [&](double z_mm) {
        for (const Station& s : stations)
            if (s.z_mm >= z_mm - 1e-6) return 2 * s.x_mm;
        return 0.0;
    };
    EXPECT_NEAR(diameterAt(0), 27.938827, 2e-6);
    // The depth of 3 mm in full lowers F_ap a little against the uncorrected cut.
    EXPECT_NEAR(2000 * (14 - diameterAt(143.5) / 2), errorAt(predictDeflection(plan, setup).passes.front(), 143.5),
                0.1);
    EXPECT_NEAR(2 * stations.back().x_mm, 27.989549, 2e-6);

    // Programmed without rounding it leaves no error: same stations as a contour.
    CutPlan corrected = plan.cuts.front();
    for (const Station& s : stations) {
        if (s.at_start) corrected.pieces[s.piece].start_mm = s.x_mm;
        if (!s.at_start) corrected.pieces[s.piece].end_mm = s.x_mm;
        if (!s.at_start && s.piece + 1 < corrected.pieces.size()) corrected.pieces[s.piece + 1].start_mm = s.x_mm;
    }
    TurningWork again(plan, setup);
    again.take(corrected, CutTask::Predict, stations);
    for (const Station& s : stations) EXPECT_NEAR(s.radius_mm, 14, 5e-8);
}

TEST(Compensation, WrittenProgramOfCaseA)
{
    const CompensationResult result = compensate(caseAStock(), caseARuns(), caseASetup());
    ASSERT_EQ(result.runs.size(), 1U);
    const std::vector<CorrectedNode>& nodes = result.runs.front().nodes;
    EXPECT_LE(result.residual.max_um, 0.6);
    EXPECT_LE(result.blocks_added, 8);
    EXPECT_EQ(result.blocks_changed, 1);  // the block that ends at z = 280
    EXPECT_EQ(nodes.front().z_mm, -2);
    EXPECT_EQ(nodes.front().x_mm, 14);
    EXPECT_EQ(nodes[1].z_mm, 0);
    EXPECT_TRUE(nodes[1].added);
    EXPECT_NEAR(2 * nodes[1].x_mm, 27.939, 1e-9);
    EXPECT_LT(nodes[1].dx_um, 0);
    EXPECT_NEAR(nodes[1].F_ap_N, 173.5, 0.05);
    EXPECT_EQ(nodes.back().z_mm, 280);
    EXPECT_FALSE(nodes.back().added);
    EXPECT_NEAR(result.largest_correction_um, -61, 0.5);
    for (const CorrectedNode& node : nodes) {
        EXPECT_NEAR(node.x_mm * 2000, std::round(node.x_mm * 2000), 1e-6);
        EXPECT_NEAR(node.z_mm * 1000, std::round(node.z_mm * 1000), 1e-6);
    }
    struct Known {
        const char* key;
        double least_percent, largest_percent;
    };
    ASSERT_EQ(result.robustness.size(), 7U);
    for (const Known& known :
         {Known{"tailstock_plus_20", 88, 90}, Known{"tailstock_minus_20", 88, 90}, Known{"springs_plus_20", 83, 84},
          Known{"springs_minus_20", 83, 84}, Known{"forces_plus_20", 73.5, 83}, Known{"forces_minus_20", 73.5, 83},
          Known{"forces_plus_20_springs_minus_20", 67.5, 69}}) {
        const auto row = std::find_if(result.robustness.begin(), result.robustness.end(),
                                      [&](const RobustnessRow& one) { return one.key == known.key; });
        ASSERT_NE(row, result.robustness.end()) << known.key;
        EXPECT_GE(row->reduction_percent(), known.least_percent) << known.key;
        EXPECT_LE(row->reduction_percent(), known.largest_percent) << known.key;
    }
}

TEST(Compensation, StagesWithShoulderConeAndArc)
{
    const std::vector<ToolMove> moves{
        {-2, 16, false, 0, 10, {}},      {220, 16, true, 0.2, 11, {}},
        {220, 18, true, 0.2, 12, {}},    {-2, 18, false, 0, 13, {}},
        {-2, 14, false, 0, 14, {}},      {90, 14, true, 0.2, 15, {}},
        {90, 15, true, 0.2, 16, {}},     {120, 15, true, 0.2, 17, {}},
        {160, 15.5, true, 0.2, 18, {}},  {170, 15.9, true, 0.15, 19, ArcCentre{165, -110.3, true}},
        {175, 17.5, true, 0.15, 20, {}}, {-2, 20, false, 0, 21, {}}};
    std::vector<ToolMove> path = moves;
    path[9].arc.reset();
    const CompensationResult result = compensate(rod(287.5, 35), toolRuns(path), caseASetup());
    ASSERT_EQ(result.runs.size(), 2U);
    EXPECT_LE(result.residual.max_um, 0.6);
    EXPECT_LT(result.blocks_added, 40);
    // Where the feed changes the correction jumps: two corners at one z.
    EXPECT_TRUE(std::any_of(result.runs[1].nodes.begin(), result.runs[1].nodes.end(),
                            [](const CorrectedNode& node) { return node.z_mm == 160 && node.added; }));
    // Block ends are unchanged, in order, with their lines.
    std::vector<std::int64_t> lines;
    for (const CorrectedNode& node : result.runs[1].nodes)
        if (!node.added) lines.push_back(node.line);
    EXPECT_EQ(lines, (std::vector<std::int64_t>{14, 15, 16, 17, 18, 19, 20}));
    // A run that is not corrected is unchanged.
    CompensationParameters finish;
    finish.runs = CorrectedRuns::Finish;
    std::vector<ToolRun> hidden = straightCut(16, 280);
    hidden.push_back(straightCut(15, 280).front());
    const CompensationResult last = compensate(rod(287.5, 35), hidden, caseASetup(), finish);
    ASSERT_EQ(last.runs.size(), 1U);
    EXPECT_EQ(last.written.front(), hidden.front());
    EXPECT_LE(last.residual.max_um, 0.6);
}

TEST(Compensation, ArcsStayArcs)
{
    const std::vector<ToolMove> moves{{-2, 14, false, 0, 1, {}},
                                      {80, 14, true, 0.2, 2, {}},
                                      {83, 17, true, 0.2, 3, ArcCentre{80, 17, false}},
                                      {90, 17.5, true, 0.2, 4, {}}};
    const CompensationResult result = compensate(rod(287.5, 36), toolRuns(moves), caseASetup());
    EXPECT_LE(result.residual.max_um, residualOfArcs_um(result.parameters));
    const std::vector<CorrectedNode>& nodes = result.runs.front().nodes;
    const auto arcs =
        std::count_if(nodes.begin(), nodes.end(), [](const CorrectedNode& node) { return node.arc.has_value(); });
    EXPECT_GE(arcs, 1);
    EXPECT_LE(arcs, 2);
    for (const CorrectedNode& node : nodes)
        EXPECT_EQ(node.arc.has_value(), node.z_mm > 80 && node.z_mm <= 83) << node.z_mm;
    EXPECT_LT(result.blocks_added, 10);
}

TEST(Compensation, Refusals)
{
    CompensationParameters small;
    small.largest_correction_um = 20;
    EXPECT_EQ(codeOfError([&] { compensate(caseAStock(), caseARuns(), caseASetup(), small); }),
              errors::correctionTooLarge);
    CompensationParameters coarse;
    coarse.grid_um = 10;
    EXPECT_EQ(codeOfError([&] { compensate(caseAStock(), caseARuns(), caseASetup(), coarse); }),
              errors::cannotBeWritten);
}

}  // namespace
}  // namespace lathelier::deflection
