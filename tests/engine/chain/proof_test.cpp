// Predicted and measured errors of a chain, the stock of two clampings, and the machine identified from the copy.
#include "engine/chain/proof.h"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "engine/cam/plan.h"
#include "engine/chain/held_bar.h"
#include "engine/chain/machine_fit.h"
#include "engine/deflection/setup_file.h"
#include "engine/deflection/turning_job.h"
#include "engine/io/file.h"
#include "engine/io/shaft/shaft_file.h"
#include "tests/engine/cam/plan_data.h"
#include "tests/scratch_folder.h"

namespace lathelier::chain {
namespace {

Json deflected()
{
    return {{"final", {{"z_mm", {1, 11, 21}}, {"diameter_error_um", {10, 20, 30}}}},
            {"band", {{"z_mm", {1, 11, 21}}, {"low_um", {9, 18, 27}}, {"high_um", {11, 22, 33}}}}};
}

/// |E_n| <= 1 in micrometres: the difference against both uncertainties together.
TEST(Proof, AnswersWithTheDifferenceAgainstBothUncertainties)
{
    Proof proof;
    proof.places = {{1, 0, 50, 10, 3, 12, 4, 0.4}, {2, 50, 90, 20, 3, 16, 4, -0.8}};
    const report::Answer agrees = proofAnswer(proof, {});
    EXPECT_EQ(agrees.value, 4);
    EXPECT_EQ(agrees.upper_limit, 5);
    EXPECT_EQ(agrees.verdict, Verdict::Pass);
    report::Finding copy;
    copy.verdict = Verdict::Fail;
    EXPECT_EQ(proofAnswer(proof, copy).verdict, Verdict::Fail);  // predicted well, but out of its limit
    copy.verdict = Verdict::Undecided;
    EXPECT_EQ(proofAnswer(proof, copy).verdict, Verdict::Undecided);
    proof.places.push_back({3, 90, 100, 0, 3, 7.5, 4, 1.5});
    const report::Answer differs = proofAnswer(proof, {});
    EXPECT_EQ(differs.value, 7.5);
    EXPECT_EQ(differs.verdict, Verdict::Fail);
    ASSERT_EQ(differs.findings.size(), 1u);
    EXPECT_EQ(differs.findings.front().verdict, Verdict::Fail);
}

TEST(Proof, PlacesOfThePredictionCountFromTheFinishedFace)
{
    const PredictedErrors predicted = predictedErrors(deflected(), 1);
    EXPECT_EQ(predicted.z_mm, (std::vector<double>{0, 10, 20}));
    EXPECT_EQ(predicted.low_um, (std::vector<double>{9, 18, 27}));
}

TEST(Proof, TheSecondClampingIsSeenFromTheOtherEnd)
{
    const PredictedErrors mirrored = predictedErrors(deflected(), 1, 100);
    EXPECT_EQ(mirrored.z_mm, (std::vector<double>{80, 90, 100}));
    EXPECT_EQ(mirrored.error_um, (std::vector<double>{30, 20, 10}));
    EXPECT_EQ(mirrored.high_um, (std::vector<double>{33, 22, 11}));
    const PredictedErrors all = joined(predictedErrors(deflected(), 1), mirrored, 85);
    EXPECT_EQ(all.z_mm, (std::vector<double>{0, 10, 20, 90, 100}));
    EXPECT_EQ(all.low_um.size(), 5u);
}

Json drawn()
{
    return {
        {"segments",
         Json::array(
             {{{"z_start_mm", 0.0}, {"z_end_mm", 50.0}, {"start_diameter_mm", 30.0}, {"end_diameter_mm", 30.0}},
              {{"z_start_mm", 50.0}, {"z_end_mm", 60.0}, {"start_diameter_mm", 30.0}, {"end_diameter_mm", 20.0}}})}};
}

Json zone(double from_mm, double to_mm)
{
    return {{"z_start_mm", from_mm}, {"z_end_mm", to_mm}, {"mean_mm", 0.01}, {"uncertainty_mm", 0.001}};
}

TEST(Proof, TheCopyIsMeasuredWithinCylindersAlone)
{
    const Json compared = {
        {"zones",
         Json::array({zone(2, 12), zone(45, 55), zone(51, 58),
                      Json{{"z_start_mm", 20}, {"z_end_mm", 30}, {"mean_mm", nullptr}, {"uncertainty_mm", 1}}})},
        {"rows", Json::array()}};
    const std::vector<MeasuredPlace> places = measuredPlaces(drawn(), compared);
    ASSERT_EQ(places.size(), 1u);
    EXPECT_DOUBLE_EQ(places[0].z_mm, 7);
    EXPECT_DOUBLE_EQ(places[0].error_um, 20);
    EXPECT_DOUBLE_EQ(places[0].uncertainty_um, 2);
    EXPECT_EQ(places[0].row, 1);
    EXPECT_TRUE(measuredPlaces({}, {}).empty());
}

TEST(Proof, ItsFileIsReadBack)
{
    const PredictedErrors predicted = predictedErrors(deflected(), 1);
    const std::vector<ComparedError> places = compareErrors(predicted, {{1, 0, 20, 25, 2}});
    const auto read = proofFrom(proofJson(predicted, places, {{7, 20, 2, 1}}));
    ASSERT_TRUE(read);
    EXPECT_EQ(read->predicted.z_mm, predicted.z_mm);
    ASSERT_EQ(read->places.size(), 1u);
    EXPECT_DOUBLE_EQ(read->places[0].normalized_error, places[0].normalized_error);
    ASSERT_EQ(read->along.size(), 1u);
    EXPECT_EQ(proofTable(*read).rows.size(), 1u);
    EXPECT_EQ(proofPlot(*read).curves.size(), 4u);  // band, prediction, rows, along
    EXPECT_FALSE(proofFrom({}));
    EXPECT_FALSE(proofFrom(Json::array()));
}

TEST(Proof, ADamagedFileIsNone)
{
    const PredictedErrors predicted = predictedErrors(deflected(), 1);
    const Json whole = proofJson(predicted, compareErrors(predicted, {{1, 0, 20, 25, 2}}), {{7, 20, 2, 1}});
    ASSERT_TRUE(proofFrom(whole));
    for (const char* list : {"error_um", "low_um", "high_um"}) {
        Json shorter = whole;
        shorter["predicted"][list].erase(0);
        EXPECT_FALSE(proofFrom(shorter)) << list;
    }
    for (const char* list : {"places", "along"})
        for (const Json& row : {Json(nullptr), Json("1"), Json(1e300)}) {
            Json other = whole;
            other[list][0]["row"] = row;
            EXPECT_FALSE(proofFrom(other)) << list << row;
        }
}

ShaftSegment row(double length_mm, double diameter_mm)
{
    ShaftSegment made;
    made.length_mm = length_mm;
    made.start_diameter_mm = made.end_diameter_mm = diameter_mm;
    return made;
}

cam::Job simpleJob()
{
    cam::Job job;
    job.stock.diameter_mm = 40;
    job.stock.face_allowance_mm = 1;
    job.setup.chuck_face_z_mm = 150;
    job.tools = {cam::roughD55(), cam::finishD55()};
    job.cutting.rough = {2, 0.25, 190, 0.3};
    job.cutting.finish = {0.1, 190};
    return job;
}

TEST(HeldBar, EndsAtTheChuck)
{
    const HeldBar held = firstBar(simpleJob());
    EXPECT_NEAR(held.bar.length_mm(), 151, 1e-9);
    EXPECT_EQ(held.z_zero_mm, 1);
}

TEST(HeldBar, OfTheSecondClampingIsRawInFrontAndFinishedBehind)
{
    Shaft part;
    part.segments = {row(60, 25), row(20, 36), row(40, 28)};
    const auto held = secondBar(part, simpleJob());
    ASSERT_TRUE(held);
    EXPECT_TRUE(held->is_mirrored);
    // Raw up to the middle of the collar, z = 120 - 70 from the other end, then half the collar, then the held
    // cylinder.
    ASSERT_EQ(held->bar.segments.size(), 3u);
    EXPECT_NEAR(held->bar.segments[0].length_mm, 51, 1e-9);
    EXPECT_EQ(held->bar.segments[0].start_diameter_mm, 40);
    EXPECT_NEAR(held->bar.segments[1].length_mm, 10, 1e-9);
    EXPECT_EQ(held->bar.segments[1].start_diameter_mm, 36);
    EXPECT_EQ(held->bar.segments[2].start_diameter_mm, 25);
    deflection::TurningSetup setup;
    setup.tailstock.emplace();
    EXPECT_FALSE(setupFor(setup, *held, "bar_2.json").tailstock);
    Shaft single;
    single.segments = {row(60, 25)};
    EXPECT_FALSE(secondBar(single, simpleJob()));
}

/// A chain's folder with a program, its bar and its set-up, and a dossier that names them.
struct FitFixture {
    ScratchFolder scratch;
    std::string folder = scratch.path().string();
    deflection::TurningSetup setup;
    Shaft bar;
    Dossier dossier;
    std::string program;

    FitFixture()
    {
        cam::Job job = simpleJob();
        Shaft part;
        part.segments = {row(80, 26), row(50, 32)};
        cam::TurningInputs inputs;
        inputs.post = cam::postNamed("fanuc_a");
        program = cam::planTurning(part, job, inputs).setups.front().text;
        const HeldBar held = firstBar(job);
        bar = held.bar;
        setup.material.cutting = {1748, 99, 600, 80};
        setup.tool.corner_radius_mm = 0.4;
        setup.tool.entering_angle_deg = 93;
        setup.chuck = {45000, 0, 198e6, 0};
        setup = setupFor(setup, held, "bar.json");
        const auto write = [&](const std::string& name, const std::string& text) {
            io::writeFile(folder + "/" + name, text);
            return InputFile{name, static_cast<std::int64_t>(text.size()), io::sha256(text)};
        };
        ChainStep step;
        step.id = "deflection";
        step.state = StepState::Done;
        step.inputs = {write("program.nc", program), write("setup.json", deflection::setupText(setup)),
                       write("bar.json", io::shaftText(bar))};
        step.parameters = {{"setup", folder + "/setup.json"}};
        dossier.steps = {step};
    }

    deflection::FinalContour contour(const deflection::TurningSetup& held) const
    {
        gcode::Program read = gcode::readProgram(program);
        gcode::Toolpath path = findToolpath(read);
        return predictJob(deflection::turningJob(std::move(read), std::move(path), bar, held)).final;
    }
};

TEST(MachineFit, FindsTheMachineThatMadeTheCopy)
{
    const FitFixture fixture;
    deflection::TurningSetup real = fixture.setup;
    real.chuck.tilt_N_mm_rad *= 0.7;
    for (double* force : {&real.material.cutting.K_tc_N_mm2, &real.material.cutting.K_te_N_mm,
                          &real.material.cutting.K_rfc_N_mm2, &real.material.cutting.K_rfe_N_mm})
        *force *= 1.2;
    const deflection::FinalContour made = fixture.contour(real);
    Proof proof;
    for (const double z_mm : {8., 16., 24., 32., 40., 48., 56., 64., 72., 90., 100., 110., 120.}) {
        const double at = z_mm + fixture.setup.z_zero_mm;
        for (std::size_t i = 0; i + 1 < made.z_mm.size(); ++i)
            if (made.z_mm[i] <= at && at < made.z_mm[i + 1])
                proof.along.push_back({z_mm, made.diameter_error_um[i], 0.5, 1});
    }
    ASSERT_EQ(proof.along.size(), 13u);
    deflection::IdentificationParameters sought;
    sought.tailstock = false;
    sought.chuck_tilt = sought.forces = true;
    const auto fit = fitMachine(fixture.folder, fixture.dossier, proof, sought);
    ASSERT_TRUE(fit);
    ASSERT_EQ(fit->found.factors.size(), 2u);
    EXPECT_LT(fit->found.rms_after_um, 0.05 * fit->found.rms_before_um);
    for (const deflection::IdentifiedFactor& factor : fit->found.factors)
        EXPECT_NEAR(factor.factor, factor.influence == deflection::Influence::Forces ? 1.2 : 0.7, 0.03);
    // Returned set-up: the chain replaces the stock, the panel uses its original path.
    Notes notes;
    EXPECT_TRUE(deflection::readSetup(fit->setup_text, notes).stock.empty());
    EXPECT_NE(deflection::readSetup(fit->whole_text, notes).stock.find("bar.json"), std::string::npos);
    EXPECT_NEAR(deflection::readSetup(fit->setup_text, notes).chuck.tilt_N_mm_rad, 0.7 * 198e6, 0.03 * 198e6);
}

TEST(MachineFit, WithoutDeflectionOrCopyThereIsNone)
{
    const FitFixture fixture;
    EXPECT_FALSE(fitMachine(fixture.folder, {}, {}, {}));
    EXPECT_FALSE(fitMachine(fixture.folder, fixture.dossier, {}, {}));
}

}  // namespace
}  // namespace lathelier::chain
