// Speeds by section of the papers' shaft: bar D40, overhang 200 mm, spindle 14 850 N/mm and 198.3e6 N mm/rad.
#include "engine/cam/section_speeds.h"

#include <gtest/gtest.h>

#include <cmath>

#include "engine/cam/cutting_data.h"
#include "engine/cam/plan_codes.h"
#include "tests/engine/cam/plan_data.h"

namespace lathelier::cam {
namespace {

TurningPlan paperPlan(stability::SpeedRelation relation, PartModel model)
{
    TurningInputs inputs;
    inputs.post = postNamed("fanuc_a");
    inputs.spindle = receptance::SpindleReceptance{receptance::SpindleSprings{14850, 198.3e6, 0.06}};
    TurningParameters parameters;
    parameters.relation = relation;
    parameters.part_model = model;
    const Job job = paperJob({roughC80(), finishC80()});
    return planTurning(*job.shaft, job, inputs, parameters);
}

TEST(SectionSpeeds, FinishOfD30AsThePaperHasIt)
{
    const TurningPlan plan = paperPlan(stability::SpeedRelation::Published, PartModel::Finished);
    ASSERT_EQ(plan.setups.size(), 2U);
    ASSERT_FALSE(plan.sections.empty());
    ASSERT_TRUE(plan.sections[0].speed_rpm);
    EXPECT_NEAR(plan.sections[0].diameter_mm, 30, 1e-9);
    EXPECT_NEAR(*plan.sections[0].speed_rpm, 2154, 3);
    EXPECT_NEAR(*plan.sections[0].frequency_hz, 369, 0.7);
    EXPECT_NE(plan.setups[0].text.find("G97 S21"), std::string::npos);
    // Roughing has speeds of its own, from the bar as each pass leaves it.
    const std::string rough = plan.setups[0].text.substr(plan.setups[0].text.find("(ROUGH)"), 200);
    EXPECT_NE(rough.find("G97 S"), std::string::npos) << rough;
    EXPECT_EQ(rough.find("S2154"), std::string::npos);
}

TEST(SectionSpeeds, WorkOfTheMomentIsSlower)
{
    const TurningPlan plan = paperPlan(stability::SpeedRelation::Published, PartModel::Moment);
    // 30.6 mm ahead, the bar behind: 364.0 Hz, 2124 1/min.
    EXPECT_NEAR(*plan.sections[0].frequency_hz, 364.0, 1.0);
    EXPECT_NEAR(*plan.sections[0].speed_rpm, 2124, 6);
}

TEST(SectionSpeeds, ExactRelationStaysInItsPocket)
{
    const TurningPlan plan = paperPlan(stability::SpeedRelation::Exact, PartModel::Finished);
    const SectionSpeed& first = plan.sections[0];
    const double k = std::floor(60 * *first.frequency_hz / 2016 + 0.25);
    EXPECT_GT(*first.speed_rpm, 60 * *first.frequency_hz / (k + 0.75));
    EXPECT_LT(*first.speed_rpm, 60 * *first.frequency_hz / (k - 0.25));
}

TEST(SectionSpeeds, WithoutAStableSpeedTheDepthThatWouldBe)
{
    // The stable speed lies above the spindle's limit: the catalogue's speed is kept.
    Job job = jobWith({row(98, 30, 30), row(10, 37, 37)}, 40, 200, {roughC80(), finishC80()});
    job.cutting.material = "C45";
    job.max_rpm = 2000;
    TurningInputs inputs;
    inputs.post = postNamed("fanuc_a");
    inputs.spindle = receptance::SpindleReceptance{receptance::SpindleSprings{14850, 198.3e6, 0.06}};
    TurningParameters parameters;
    parameters.setups = SetupChoice::One;
    const TurningPlan plan = planTurning(*job.shaft, job, inputs, parameters);
    ASSERT_TRUE(contains(plan.notes, notes::noStableSpeedHere));
    EXPECT_TRUE(contains(plan.notes, notes::stableDepthHere));
    const SectionSpeed& first = plan.sections[0];
    ASSERT_TRUE(first.stable_depth_mm);
    EXPECT_EQ(*first.speed_rpm, 2000);
    // No less than the depth that is stable at any speed: -1 / (2 k_c Re G).
    double least = 0;
    for (const auto& value : first.receptance->value) least = std::min(least, value.real());
    const double k_c = 2220 * std::pow(0.1 * std::sin(95 * std::acos(-1.0) / 180), -0.14);
    EXPECT_GE(*first.stable_depth_mm, -1 / (2 * k_c * least) * 0.999);
    EXPECT_LT(*first.stable_depth_mm, 100 * -1 / (2 * k_c * least));
    EXPECT_NE(plan.setups[0].text.find("THERE DEPTHS UP TO"), std::string::npos);
    job.cutting.material.clear();
    const TurningPlan unknown = planTurning(*job.shaft, job, inputs, parameters);
    EXPECT_FALSE(unknown.sections[0].stable_depth_mm);
    EXPECT_FALSE(contains(unknown.notes, notes::stableDepthHere));
}

TEST(SectionSpeeds, FacesAndTapersKeepTheirCuttingSpeed)
{
    const Job job = jobWith({row(1, 18, 20), row(30, 20, 20), row(20, 20, 30), row(30, 30, 30), row(15, 36, 36)}, 40,
                            200, {roughC80(), finishC80()});
    TurningInputs inputs;
    inputs.spindle = receptance::SpindleReceptance{receptance::SpindleSprings{14850, 198.3e6, 0.06}};
    TurningParameters parameters;
    parameters.setups = SetupChoice::One;
    for (const std::string& post : postNames()) {
        inputs.post = postNamed(post);
        const TurningPlan plan = planTurning(*job.shaft, job, inputs, parameters);
        EXPECT_FALSE(plan.is_refused) << post;
        EXPECT_LE(plan.setups[0].check.gouge_um, 1.5) << post;
        ASSERT_EQ(plan.sections.size(), 4U) << post;
        EXPECT_TRUE(plan.sections[0].speed_rpm && plan.sections[2].speed_rpm && plan.sections[3].speed_rpm) << post;
        EXPECT_FALSE(plan.sections[1].speed_rpm) << post;
        EXPECT_NEAR(plan.sections[1].z_start_mm, 31, 1e-9);
        EXPECT_NEAR(plan.sections[1].z_end_mm, 51, 1e-9);
        const std::int64_t finish =
            std::find_if(plan.setups[0].operations.begin(), plan.setups[0].operations.end(),
                         [](const PlannedOperation& each) { return each.kind == OperationKind::Finish; })
                ->first_line;
        if (!inputs.post.css) continue;
        for (const gcode::Move& move : plan.setups[0].check.path.moves) {
            if (move.line < finish || move.kind == gcode::MoveKind::Rapid || !gcode::isKnown(move.x_mm)) continue;
            if (std::abs(move.z_mm) < 1e-6 && move.x_mm < 8) {  // up the face
                EXPECT_TRUE(gcode::isKnown(move.cutting_speed_m_min)) << post;
                EXPECT_GT(move.speed_limit_rpm, 0) << post;
            }
            const auto inside = [&](double from, double to) { return -move.z_mm > from && -move.z_mm < to; };
            if (inside(1.5, 30.5) || inside(52, 80) || inside(82, 95)) {
                EXPECT_TRUE(gcode::isKnown(move.speed_rpm)) << post << ' ' << move.line;
            }
            if (inside(31.5, 49)) {
                EXPECT_TRUE(gcode::isKnown(move.cutting_speed_m_min)) << post << ' ' << move.line;
            }
        }
    }
}

TEST(SectionSpeeds, ThePassOfTheOppositeHandHasItsOwn)
{
    const Job job =
        jobWith({row(60, 30, 30), row(20, 37, 37), row(60, 30, 30)}, 40, 200, {roughC80(), finishC80(), backV35()});
    TurningInputs inputs;
    inputs.post = postNamed("fanuc_a");
    inputs.spindle = receptance::SpindleReceptance{receptance::SpindleSprings{14850, 198.3e6, 0.06}};
    TurningParameters parameters;
    parameters.setups = SetupChoice::One;
    const TurningPlan plan = planTurning(*job.shaft, job, inputs, parameters);
    EXPECT_FALSE(plan.is_refused);
    const auto note = std::find_if(plan.notes.begin(), plan.notes.end(),
                                   [](const Note& each) { return each.code == notes::backSpeed; });
    ASSERT_NE(note, plan.notes.end());
    const double speed = std::get<double>(*find(note->values, "speed_rpm"));
    EXPECT_NE(plan.setups[0].text.find("G97 S" + std::to_string(std::llround(speed)) + " M3",
                                       plan.setups[0].text.find("(FINISH BACK)")),
              std::string::npos);
}

TEST(MachinePower, MoreThanFourFifthsIsRemarked)
{
    Job job = jobWith({row(60, 30, 30), row(20, 37, 37)}, 40, 200, {roughC80(), finishC80()});
    job.cutting.material = "C45";
    const TurningPlan free = planned(job);
    EXPECT_FALSE(contains(free.notes, notes::powerNearLimit));
    double most = 0;
    for (const PlannedOperation& operation : free.setups[0].operations)
        most = std::max(most, operation.power_max_kW.value_or(0));
    ASSERT_GT(most, 0.5);
    job.setup.efficiency = 0.8;
    job.setup.power_kW = most / 0.8 / 0.79;
    EXPECT_FALSE(contains(planned(job).notes, notes::powerNearLimit));
    job.setup.power_kW = most / 0.8 / 0.81;
    const TurningPlan plan = planned(job);
    const auto note = std::find_if(plan.notes.begin(), plan.notes.end(),
                                   [](const Note& each) { return each.code == notes::powerNearLimit; });
    ASSERT_NE(note, plan.notes.end());
    EXPECT_NEAR(std::get<double>(*find(note->values, "share_percent")), 81, 1e-6);
    EXPECT_NEAR(std::get<double>(*find(note->values, "power_kW")), most / 0.8, 1e-9);
}

TEST(SectionSpeeds, StableDepthIsThatOfTheFeedOfItsRow)
{
    Job job = jobWith({row(98, 30, 30), row(10, 37, 37)}, 40, 200, {roughC80(), finishC80()});
    job.cutting.material = "C45";
    job.max_rpm = 2000;
    TurningInputs inputs;
    inputs.post = postNamed("fanuc_a");
    inputs.spindle = receptance::SpindleReceptance{receptance::SpindleSprings{14850, 198.3e6, 0.06}};
    TurningParameters parameters;
    parameters.setups = SetupChoice::One;
    const auto depth = [&] { return planTurning(*job.shaft, job, inputs, parameters).sections[0].stable_depth_mm; };
    const auto usual = depth();
    job.shaft->segments[0].Rz_um = 1;
    const auto smooth = depth();
    ASSERT_TRUE(usual && smooth);
    // k_c goes with h^-0.14, so the depth with f^0.14.
    const double feed = feedForRz(1, 0.4, 5, 0.1);
    EXPECT_LT(feed, 0.07);
    EXPECT_NEAR(*smooth / *usual, std::pow(std::floor(1000 * feed) / 100, 0.14), 1e-3);
}

TEST(SectionSpeeds, StatedSectionsStandInTheProgram)
{
    Job job = jobWith({row(98, 30, 30), row(6, 37, 37)}, 40, 130, {roughC80(), finishC80()});
    job.sections = {{98, 2154}, {104, 1750}};
    const TurningPlan plan = planned(job, "fanuc_a");
    const std::string& text = plan.setups[0].text;
    const std::size_t first = text.find("G97 S2154 M3"), second = text.find("G97 S1750", first);
    ASSERT_NE(first, std::string::npos);
    ASSERT_NE(second, std::string::npos);
    EXPECT_GT(second, text.find("(FINISH)"));
    ASSERT_EQ(plan.sections.size(), 2U);
    EXPECT_NEAR(plan.sections[0].cutting_speed_m_min, 203, 0.1);
}

TEST(CuttingData, KienzleAndRoughness)
{
    const auto* c45 = workMaterial("c 45");
    ASSERT_NE(c45, nullptr);
    // h 0.1, b 1: 3064 N/mm².
    EXPECT_NEAR(cuttingPower(c45->value, 1, 0.1, 90, 60) / 0.1 * 1000, 3064, 2);
    EXPECT_EQ(workMaterial("unobtainium"), nullptr);
    EXPECT_NEAR(idealRz_um(0.2, 0.8), 6.275, 0.001);
    EXPECT_NEAR(idealRz_um(0.1, 0.4), 3.137, 0.001);
    EXPECT_NEAR(idealRz_um(0.1, 0.4, 5) / idealRz_um(0.1, 0.4) - 1, -0.054, 0.001);
    EXPECT_NEAR(idealRz_um(0.25, 0.8, 5) / idealRz_um(0.25, 0.8) - 1, -0.126, 0.001);
    EXPECT_NEAR(idealRz_um(0.2, 0.4, 5) / idealRz_um(0.2, 0.4) - 1, -0.31, 0.005);
}

}  // namespace
}  // namespace lathelier::cam
