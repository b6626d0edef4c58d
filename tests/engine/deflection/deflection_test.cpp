// Prediction: signatures of implementation errors, properties, error propagation between passes, stock shapes,
// refusals.
#include "engine/deflection/deflection.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "../core/code_of_error.h"
#include "case_a.h"
#include "engine/deflection/bent_skin.h"
#include "engine/deflection/deflected_shape.h"
#include "engine/deflection/deflection_codes.h"
#include "engine/deflection/deflection_quantities.h"
#include "engine/deflection/deflection_report.h"
#include "engine/deflection/deflection_verification.h"
#include "engine/deflection/measured_places.h"

namespace lathelier::deflection {
namespace {

DeflectionResult caseA(const TurningSetup& setup = caseASetup())
{
    return predictDeflection(caseAStock(), caseARuns(), setup);
}

double caseAAt(const TurningSetup& setup, double z_mm)
{
    return errorAt(caseA(setup).passes.front(), z_mm);
}

TEST(Deflection, SignaturesOfWrongPrograms)
{
    const PassResult pass = caseA().passes.front();
    const double dx = pass.dx_um.front() / 1000, dy = pass.dy_um.front() / 1000;
    EXPECT_LT(dx, 0);
    EXPECT_NEAR(2000 * (std::hypot(14 + dx, dy) - 14), -53.8, 0.1);  // dx with the wrong sign
    EXPECT_NEAR(-2000 * dx, 57.55, 0.05);                            // dy ignored
    EXPECT_NEAR(pass.diameter_error_um.front() / 2, 30.65, 0.01);    // radius for diameter
    TurningSetup rigid = caseASetup();
    rigid.chuck.radial_N_mm = 1e15;
    rigid.chuck.tilt_N_mm_rad = 1e15;
    EXPECT_NEAR(caseAAt(rigid, 143.75), 12.3, 0.1);
    TurningSetup in_N_m = caseASetup();
    in_N_m.chuck.tilt_N_mm_rad *= 1000;
    EXPECT_NEAR(caseAAt(in_N_m, 143.75), 18.8, 0.1);
    TurningSetup hutchinson = caseASetup();
    hutchinson.shear = beam::ShearModel::Hutchinson;
    double moved = 0;
    for (const double z : {0.0, 50.0, 143.75, 280.0})
        moved = std::max(moved, std::abs(caseAAt(hutchinson, z) - caseAAt(caseASetup(), z)));
    EXPECT_NEAR(moved, 0.019, 0.003);
}

TEST(Deflection, FeedMomentLowersTheError)
{
    TurningSetup with = caseASetup();
    with.feed_moment = true;
    const double ratio = caseA(with).summary.mean_abs_um / caseA().summary.mean_abs_um;
    EXPECT_GT(ratio, 0.70);
    EXPECT_LT(ratio, 0.90);
}

TEST(Deflection, TheErrorIsNotMonotoneInTheDepth)
{
    for (const auto& [depth_mm, max_um] : {std::pair{0.5, 46.6}, {1.0, 62.5}, {2.0, 65.4}, {3.0, 61.3}})
        EXPECT_NEAR(predictDeflection(caseAStock(), straightCut(17 - depth_mm, 280), caseASetup()).summary.max_um,
                    max_um, 0.06);
}

TEST(Deflection, DimensionScaling)
{
    const double length = 2.5, force = 3;
    TurningSetup scaled = caseASetup();
    scaled.material.elastic.elastic_modulus_MPa *= force / (length * length);
    cutting::CuttingCoefficients& k = scaled.material.cutting;
    k = {k.K_tc_N_mm2 * force / (length * length), k.K_te_N_mm * force / length,
         k.K_rfc_N_mm2 * force / (length * length), k.K_rfe_N_mm * force / length};
    *scaled.tool.corner_radius_mm *= length;
    scaled.chuck.radial_N_mm *= force / length;
    scaled.chuck.tilt_N_mm_rad *= force * length;
    scaled.tailstock->radial_N_mm *= force / length;
    scaled.step_mm *= length;
    const DeflectionResult other = predictDeflection(
        rod(287.5 * length, 34 * length), straightCut(14 * length, 280 * length, -2 * length, 0.2 * length), scaled);
    const DeflectionResult one = caseA();
    EXPECT_NEAR(other.summary.max_um, length * one.summary.max_um, 1e-4);
    EXPECT_NEAR(other.summary.mean_abs_um, length * one.summary.mean_abs_um, 1e-3);
    EXPECT_NEAR(other.passes.front().F_t_N.front(), force * one.passes.front().F_t_N.front(), 1e-4);
}

TEST(Deflection, SymmetryOfASymmetricHolding)
{
    TurningSetup setup = caseASetup();
    setup.chuck = {6000, 0, 0, 0};
    setup.tailstock = HoldingSprings{6000, 0, 0, 0};
    const WorkPlan plan = workPlan(rod(300, 34), straightCut(1e3, 300), setup);
    TurningWork work(plan, setup);
    std::vector<Station> stations;
    work.take(plan.cuts.front(), CutTask::Predict, stations);
    const std::size_t last = plan.pieces();
    for (std::size_t i = 0; i <= last; i += 50)
        EXPECT_NEAR(work.complianceAt(i).ww / work.complianceAt(last - i).ww, 1, 1e-9);
}

TEST(Deflection, ShapesSuperposeAndAreReciprocal)
{
    const TurningSetup setup = caseASetup();
    const WorkPlan plan = workPlan(caseAStock(), caseARuns(), setup);
    const TurningWork work(plan, setup);
    const auto one = work.shapeUnder(100, {10, 0}), two = work.shapeUnder(100, {0, 5000}),
               both = work.shapeUnder(100, {10, 5000});
    const auto far = work.shapeUnder(400, {10, 0});
    for (std::size_t i = 0; i < both.size(); i += 37) EXPECT_NEAR(both[i].w, one[i].w + two[i].w, 1e-15);
    EXPECT_NEAR(far[100].w / one[400].w, 1, 1e-9);
}

TEST(Deflection, DeflectedShapeMeetsTheStation)
{
    const TurningSetup setup = caseASetup();
    const WorkPlan plan = workPlan(caseAStock(), caseARuns(), setup);
    const PassResult pass = predictDeflection(plan, setup).passes.front();
    const DeflectedShape shape = deflectedShape(plan, setup, 0, 143);
    const auto place = std::find(pass.z_mm.begin(), pass.z_mm.end(), shape.tool_z_mm) - pass.z_mm.begin();
    const auto node = std::find(shape.z_mm.begin(), shape.z_mm.end(), shape.tool_z_mm) - shape.z_mm.begin();
    EXPECT_NEAR(shape.x_um[static_cast<std::size_t>(node)], pass.dx_um[static_cast<std::size_t>(place)], 1e-4);
    EXPECT_NEAR(shape.y_um[static_cast<std::size_t>(node)], pass.dy_um[static_cast<std::size_t>(place)], 1e-4);
}

TEST(Deflection, PassesCarryErrorsOver)
{
    std::vector<ToolRun> runs = straightCut(16, 280);
    runs.push_back(straightCut(15, 280).front());
    runs.push_back(straightCut(14.5, 150).front());
    const DeflectionResult result = predictDeflection(caseAStock(), runs, caseASetup());
    ASSERT_EQ(result.passes.size(), 3U);
    // The second pass removes its nominal depth plus the error of the first pass minus its own.
    const PassResult &first = result.passes[0], &second = result.passes[1];
    EXPECT_NEAR(second.depth_mm[0], 1 + (first.diameter_error_um[0] - second.diameter_error_um[0]) / 2000, 1e-8);
    EXPECT_EQ(result.final.target_radius_mm.front(), 14.5);
    EXPECT_EQ(result.final.target_radius_mm.back(), 15);
    EXPECT_TRUE(std::is_sorted(result.final.z_mm.begin(), result.final.z_mm.end()));
}

TEST(Deflection, WhatACutTowardTheFreeEndLeavesIsNotJudged)
{
    std::vector<ToolRun> runs = straightCut(15, 280);
    const DeflectionResult without = predictDeflection(caseAStock(), runs, caseASetup());
    runs.push_back({ToolRun::Kind::TowardFreeEnd, {{160, 13, 0.2, 9}, {120, 13, 0.2, 10}}});
    const DeflectionResult result = predictDeflection(caseAStock(), runs, caseASetup());
    EXPECT_TRUE(contains(result.notes, notes::towardFreeEnd));
    for (const double z_mm : result.final.z_mm) EXPECT_FALSE(z_mm > 120.001 && z_mm < 159.999) << z_mm;
    ASSERT_EQ(result.final.gaps.size(), 1U);
    EXPECT_NEAR(result.final.z_mm[result.final.gaps[0]], 160, 1e-9);
    EXPECT_EQ(result.summary.max_um, without.summary.max_um);
    EXPECT_EQ(result.summary.wear_offset_um, without.summary.wear_offset_um);
    // A diameter measured there has no predicted value.
    const std::vector<MeasuredDiameter> inside{{140, 26, 1}}, beside{{100, 30, 1}};
    EXPECT_EQ(codeOfError([&] { MeasuredPlaces(result.final, inside); }), errors::measuredOutsideCut);
    EXPECT_NO_THROW(MeasuredPlaces(result.final, beside));
    // After another cut toward the chuck it is predicted again.
    runs.push_back(straightCut(12.5, 200, 110).front());
    const DeflectionResult again = predictDeflection(caseAStock(), runs, caseASetup());
    EXPECT_TRUE(again.final.gaps.empty());
    const auto at =
        std::lower_bound(again.final.z_mm.begin(), again.final.z_mm.end(), 140.0) - again.final.z_mm.begin();
    EXPECT_EQ(again.final.target_radius_mm[static_cast<std::size_t>(at)], 12.5);
    EXPECT_GT(again.final.diameter_error_um[static_cast<std::size_t>(at)], 0);
}

TEST(Deflection, NothingPredictedIsNoAnswer)
{
    std::vector<ToolRun> runs = straightCut(15, 100);
    runs.push_back({ToolRun::Kind::TowardFreeEnd, {{120, 13, 0.2, 9}, {-2, 13, 0.2, 10}}});
    EXPECT_EQ(codeOfError([&] { predictDeflection(caseAStock(), runs, caseASetup()); }), errors::noCut);
}

TEST(Deflection, SeriesOfToolPostAddsItsCompliance)
{
    TurningSetup setup = caseASetup();
    setup.tool_post = ToolPost{40000, 1e15};
    const PassResult soft = caseA(setup).passes.front(), rigid = caseA().passes.front();
    EXPECT_NEAR(1 / soft.stiffness_N_mm[0] - 1 / rigid.stiffness_N_mm[0], 1.0 / 40000, 1e-9);
    EXPECT_GT(soft.diameter_error_um[0], rigid.diameter_error_um[0]);
}

TEST(Deflection, Refusals)
{
    const auto predict = [](const Shaft& stock, const std::vector<ToolRun>& runs, const TurningSetup& setup) {
        return codeOfError([&] { predictDeflection(stock, runs, setup); });
    };
    EXPECT_EQ(predict(rod(250, 34), caseARuns(), caseASetup()), errors::stockTooShort);
    EXPECT_EQ(errors::stockTooShort.kind, ErrorKind::NoAnswer);
    EXPECT_EQ(predict(rod(287.5, 27), caseARuns(), caseASetup()), errors::noCut);
    EXPECT_EQ(predict(rod(287.5, 34, 29), caseARuns(), caseASetup()), errors::nothingLeft);
    TurningSetup loose = caseASetup();
    loose.chuck = {};
    EXPECT_EQ(predict(caseAStock(), caseARuns(), loose), errors::notHeld);
    TurningSetup fine = caseASetup();
    fine.step_mm = 1e-3;
    EXPECT_EQ(predict(caseAStock(), caseARuns(), fine), errors::tooManySteps);
}

TEST(Deflection, RubbingIsNotedAndHasNoForce)
{
    const DeflectionResult result = predictDeflection(rod(287.5, 28.01), caseARuns(), caseASetup());
    EXPECT_TRUE(contains(result.notes, notes::belowScallop));
    EXPECT_EQ(result.passes.front().F_t_N.front(), 0);
    EXPECT_EQ(result.summary.max_um, 0);
    // A very compliant workpiece deflects until the edge rubs.
    TurningSetup soft = caseASetup();
    soft.tailstock.reset();
    const DeflectionResult thin = predictDeflection(rod(287.5, 6), straightCut(2.9, 280), soft);
    EXPECT_TRUE(contains(thin.notes, notes::belowScallop));
    EXPECT_LE(thin.summary.max_um, 200);
}

TEST(ToolRuns, MovesBecomeRuns)
{
    const std::vector<ToolMove> moves{{-2, 19, false, 0, 1, {}},
                                      {-2, 14, false, 0, 2, {}},
                                      {100, 14, true, 0.2, 3, {}},
                                      {100, 15, true, 0.2, 4, {}},
                                      {103, 18, true, 0.2, 5, ArcCentre{100, 18, false}},
                                      {200, 18, true, 0.2, 6, {}},
                                      {200, 19, true, 0.2, 7, {}},
                                      {100, 19, true, 0.2, 8, {}},
                                      {100, 10, true, 0.1, 9, {}},
                                      {-2, 19, false, 0, 10, {}}};
    const std::vector<ToolRun> runs = toolRuns(moves);
    ASSERT_EQ(runs.size(), 3U);
    EXPECT_EQ(runs[0].kind, ToolRun::Kind::TowardChuck);
    EXPECT_EQ(runs[0].points.front().x_mm, 14);
    EXPECT_EQ(runs[0].points.back().z_mm, 200);
    EXPECT_EQ(runs[0].points.back().x_mm, 18);
    EXPECT_GT(runs[0].points.size(), 20U);
    for (const PathPoint& point : runs[0].points) {
        if (!point.is_block_end) {
            EXPECT_NEAR(std::hypot(point.z_mm - 100, point.x_mm - 18), 3, 1e-9);
        }
    }
    EXPECT_EQ(runs[1].kind, ToolRun::Kind::TowardFreeEnd);
    EXPECT_EQ(runs[2].kind, ToolRun::Kind::Plunge);
}

TEST(Deflection, ResultHasTheNamesOfTheCommandLine)
{
    const Json json = nestedJson(describedValues(caseA()));
    for (const char* name : {"z_mm", "diameter_error_um", "F_t_N", "F_f_N", "F_ap_N", "depth_mm"})
        EXPECT_EQ(json.at("passes").at(0).at(name).size(), json.at("passes").at(0).at("z_mm").size()) << name;
    for (const char* name : {"z_mm", "target_radius_mm", "radius_mm", "diameter_error_um"})
        EXPECT_FALSE(json.at("final").at(name).empty()) << name;
    for (const char* name : {"max_um", "mean_abs_um", "range_um", "wear_offset_um"})
        EXPECT_TRUE(json.at(name).is_number()) << name;
}

TEST(Deflection, VerificationAndReport)
{
    for (const auto& check : deflectionVerification().checks) {
        const VerifyKind kind = check({});
        EXPECT_TRUE(kind.pass) << kind.kind << ' ' << kind.largest_deviation;
    }
    const DeflectionResult result = caseA();
    CorrectedProgram corrected;
    corrected.compensation = compensate(caseAStock(), caseARuns(), caseASetup());
    const report::Document document = deflectionReport(result, {&corrected, nullptr, nullptr, nullptr, nullptr, 20.0});
    EXPECT_GE(document.sections.size(), 4U);
}

/// What a correction leaves is told with the uncertainty of the prediction, against the limit of the part.
TEST(Deflection, ACorrectionIsNotSurerThanItsPrediction)
{
    CompensationResult result;
    result.residual.max_um = 0.5;
    result.parameters.tolerance_um = 0.6;
    ErrorBand band;
    band.max_low_um = 20;
    band.max_high_um = 40;
    const report::Answer met = answer(result, 25.0, &band);
    EXPECT_EQ(met.value, 0.5);
    EXPECT_EQ(met.expanded_uncertainty, 10);
    EXPECT_EQ(met.upper_limit, 25);
    EXPECT_EQ(met.verdict, Verdict::Pass);
    EXPECT_EQ(answer(result, 8.0, &band).verdict, Verdict::Undecided);
    result.residual.max_um = 30;
    EXPECT_EQ(answer(result, 8.0, &band).verdict, Verdict::Fail);
    EXPECT_FALSE(answer(result, std::nullopt, &band).verdict);
    // Without a band: how far the error grows on the other machines.
    result.residual.max_um = 0.5;
    EXPECT_FALSE(answer(result, 8.0, nullptr).expanded_uncertainty);
    EXPECT_EQ(answer(result, 8.0, nullptr).verdict, Verdict::Undecided);  // nothing is known of it
    result.robustness.emplace_back().max_after_um = 10.5;
    EXPECT_EQ(answer(result, 8.0, nullptr).expanded_uncertainty, 10);
    EXPECT_EQ(answer(result, 8.0, nullptr).verdict, Verdict::Undecided);
    // Whether the program follows the prediction is another question.
    EXPECT_EQ(met.findings.front().verdict, Verdict::Pass);
}

/// The part bends where it is pushed, and carries its error.
TEST(Deflection, TheBentSkinIsDisplacedAsItsAxis)
{
    const WorkPlan plan = workPlan(caseAStock(), caseARuns(), caseASetup());
    const DeflectionResult result = caseA();
    const DeflectedShape shape = deflectedShape(plan, caseASetup(), 0, 40);
    const Skin skin = bentSkin(plan, shape, result.final);
    const auto columns = static_cast<std::size_t>(skin.angle_count);
    ASSERT_EQ(skin.values.size(), skin.vertexCount());
    ASSERT_EQ(skin.shift_mm.size(), skin.vertexCount());
    EXPECT_NEAR(skin.stations.front().z_mm, 0, 1e-9);
    EXPECT_NEAR(skin.stations.back().z_mm, plan.length_mm(), 1e-9);
    double largest_um = 0;
    for (std::size_t row = 0; row < skin.stations.size(); ++row) {
        // A ring moves as a whole.
        EXPECT_EQ(skin.shift_mm[row * columns], skin.shift_mm[row * columns + columns / 2]);
        const float value = skin.values[row * columns];
        if (!std::isnan(value)) largest_um = std::max(largest_um, std::abs(static_cast<double>(value)));
    }
    EXPECT_NEAR(largest_um, result.summary.max_um, 0.02 * result.summary.max_um);
    const double free_end_um = 1000 * static_cast<double>(skin.shift_mm.front().x());
    EXPECT_NEAR(free_end_um, shape.x_um.front(), 1e-3 * std::abs(shape.x_um.front()));
    EXPECT_GT(bendMagnification(skin), 1);
}

}  // namespace
}  // namespace lathelier::deflection
