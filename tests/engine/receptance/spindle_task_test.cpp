// The verb and panel Spindle: what its object says of each response, and what is not written.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "../../scratch_folder.h"
#include "../core/code_of_error.h"
#include "engine/core/core_codes.h"
#include "engine/io/file.h"
#include "engine/io/frf/frf_writer.h"
#include "engine/io/input_files.h"
#include "engine/receptance/receptance_codes.h"
#include "engine/receptance/spindle/spindle_file.h"
#include "engine/receptance/spindle/spindle_plots.h"
#include "engine/receptance/task/spindle_task.h"
#include "tapped_rods.h"

namespace lathelier::receptance {
namespace {

class SpindleTask : public testing::Test {
protected:
    /// Writes responses and MEASUREMENTS.json.
    void write(const SpindleMeasurements& made)
    {
        std::vector<io::MeasuredFrf> responses;
        for (const RodFrf& one : made.frfs) {
            const MeasuredRod& rod = made.rods[one.rod];
            responses.push_back(
                {one.frf, static_cast<int>(rod.nodeOf(one.point_a)), 1, static_cast<int>(rod.nodeOf(one.point_b)), 1});
        }
        io::writeFile((folder_ / "taps.uff").string(), io::toUff(responses));
        Json file{{"frf", "taps.uff"}, {"rods", Json::array()}};
        for (const MeasuredRod& rod : made.rods) {
            Json points = Json::array();
            for (std::size_t k = 0; k < rod.distance_from_chuck_mm.size(); ++k)
                points.push_back({{"node", rod.nodeOf(k)}, {"distance_from_chuck_mm", rod.distance_from_chuck_mm[k]}});
            file["rods"].push_back(
                {{"length_mm", rod.shaft.length_mm()}, {"diameter_mm", 40}, {"points", std::move(points)}});
        }
        io::writeFile((folder_ / "taps.json").string(), file.dump());
    }
    std::shared_ptr<const SpindleOutcome> answered()
    {
        state_.inputs[measurementsRole].path = (folder_ / "taps.json").string();
        task::Sources sources;
        return std::make_shared<const SpindleOutcome>(answerSpindle(state_, stores_, sources, {}));
    }

    ScratchFolder folder_;
    project::PanelState state_;
    Stores stores_;
    const SpindleMeasurements made_ =
        withProportionalNoise(tapTests(softMachine(), threeTappedRods, 0, 1500, 10), 0.01, 4);
};

TEST_F(SpindleTask, SaysWhatEachResponseLeaves)
{
    write(made_);
    const auto outcome = answered();
    const task::Outcome all = outcomeOf(outcome);
    const Json json = all.json();
    EXPECT_FALSE(all.verdict);
    EXPECT_TRUE(json["verdict"].is_null());
    EXPECT_TRUE(json["remedy"].is_null());
    // Without a limit the answer is the stiffness that the machine was made with.
    const report::Answer answer = all.answer({});
    const double made_N_um = 1 / (1000 * std::abs(softMachine()(75)(0, 0)));  // in the middle of the lowest tenth
    ASSERT_TRUE(answer.value && answer.expanded_uncertainty);
    EXPECT_NEAR(*answer.value, made_N_um, *answer.expanded_uncertainty);
    EXPECT_NEAR(*answer.expanded_uncertainty / *answer.value, 0.02, 0.01);  // noise of 1 %, k = 2
    EXPECT_EQ(json["noise_from"], "scatter");
    EXPECT_NEAR(json["chi2_per_dof"].get<double>(), 1, 0.3);
    EXPECT_NEAR(json["expected_rms_percent"].get<double>(), json["residual_rms_percent"].get<double>(), 0.3);
    ASSERT_EQ(json["responses"].size(), 18U);
    EXPECT_EQ(json["responses"][1]["rod"], 1);
    EXPECT_EQ(json["responses"][1]["respond"], 101);
    EXPECT_EQ(json["responses"][1]["excite"], 102);
    EXPECT_NEAR(json["responses"][1]["rms_percent"].get<double>(), 1, 0.4);
    EXPECT_TRUE(json["responses"][1]["chi2_per_dof"].is_number());
    EXPECT_EQ(residualPlot(*outcome->check).curves.size(), 19U);
    const std::string path = (folder_ / "spindle.json").string();
    all.writers.at(spindleExport)(path, {}, {});
    EXPECT_GT(std::filesystem::file_size(path), 1000U);
}

TEST_F(SpindleTask, AMistakeIsNamedAndNothingIsWritten)
{
    SpindleMeasurements wrong = made_;
    for (Complex& value : wrong.frfs[7].frf.value) value = -value;
    write(wrong);
    const auto outcome = answered();
    const task::Outcome all = outcomeOf(outcome);
    const Json json = all.json();
    EXPECT_EQ(all.verdict, Verdict::Undecided);
    EXPECT_EQ(json["verdict"], "undecided");
    EXPECT_EQ(json["remedy"]["kind"], "sign");
    EXPECT_EQ(json["remedy"]["rod"], 2);
    EXPECT_EQ(json["remedy"]["respond"], 201);
    EXPECT_EQ(json["remedy"]["excite"], 202);
    EXPECT_GT(json["remedy"]["before_percent"].get<double>(), 10);
    EXPECT_LT(json["remedy"]["after_percent"].get<double>(), 1.5);
    EXPECT_TRUE(contains(all.notes, notes::spindleSignTurned));
    EXPECT_TRUE(contains(all.notes, notes::notModelled));
    const std::string path = (folder_ / "spindle.json").string();
    EXPECT_EQ(codeOfError([&] { all.writers.at(spindleExport)(path, {}, {}); }), errors::notModelled);
    EXPECT_FALSE(std::filesystem::exists(path));
}

TEST_F(SpindleTask, ATableThatGivesPowerAwayIsNamed)
{
    SpindleReceptance table{SpindleTable{{50, 100, 200},
                                         {{6e-5, -4e-6}, {6e-5, 4e-6}, {6e-5, 4e-6}},
                                         {0, 0, 0},
                                         {{5e-9, -3e-10}, {5e-9, -3e-10}, {5e-9, -3e-10}}}};
    const auto notesOf = [&] {
        const std::string text = spindleText(table);
        const Values reading;
        const Progress progress;
        io::InputFiles inputs;
        return loadSpindle({"table.json", text, reading, inputs, progress}).notes;
    };
    const Notes found = notesOf();
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found.front().code, notes::spindleTableNotPassive);
    EXPECT_EQ(*find(found.front().values, "lines"), Value(std::int64_t{2}));
    EXPECT_EQ(*find(found.front().values, "frequency_hz"), Value(100.0));
    for (Complex& value : std::get<SpindleTable>(table.source).H_mm_N) value.imag(-4e-6);
    EXPECT_TRUE(notesOf().empty());
}

}  // namespace
}  // namespace lathelier::receptance
