// The tasks over profiles and probe records: what goes before what, what is answered beside an error, what is
// computed once.
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "engine/core/core_codes.h"
#include "engine/core/profile_item.h"
#include "engine/io/file.h"
#include "engine/io/io_codes.h"
#include "engine/project/project_codes.h"
#include "engine/sample/sample_record.h"
#include "engine/task/task_codes.h"
#include "engine/trajectory/task/roundness_task.h"
#include "engine/trajectory/task/trajectory_task.h"
#include "engine/trajectory/trajectory_codes.h"
#include "tests/scratch_folder.h"

namespace lathelier::trajectory {
namespace {

Profile ovalProfile(double oval_um)
{
    Profile profile;
    for (int i = 0; i < 360; ++i) {
        const double angle = i * std::numbers::pi / 180, r = 20 + oval_um / 1000 * std::cos(2 * angle);
        profile.points_mm.emplace_back(r * std::cos(angle), r * std::sin(angle));
    }
    return profile;
}

class RecordTasks : public ::testing::Test {
protected:
    std::string profileFile(const std::string& name, double oval_um) const
    {
        std::string text = "x_mm,y_mm\n";
        for (const Eigen::Vector2d& point : ovalProfile(oval_um).points_mm)
            text += std::to_string(point.x()) + "," + std::to_string(point.y()) + "\n";
        const std::string path = folder_ / name;
        io::writeFile(path, text);
        return path;
    }

    std::string recordFile(int sections) const
    {
        sample::SpindleModel model = sample::quietSpindle();
        model.sections = sections;
        model.revolutions = 6;
        const std::string path = folder_ / "record.csv";
        io::writeFile(path, sample::toCsv(sample::makeProbeRecord(model)));
        return path;
    }

    task::Outcome run(const task::Task& task)
    {
        sources_ = {};
        return task.run(state_, {}, stores_, sources_, {});
    }

    RoundnessOutcome roundness()
    {
        sources_ = {};
        return answerRoundness(state_, stores_, sources_, {});
    }

    ScratchFolder folder_;
    project::PanelState state_;
    Stores stores_;
    task::Sources sources_;
};

TEST_F(RecordTasks, SeveralProfilesAreAnsweredBesideTheErrorOfOne)
{
    state_.inputs["profile"].path = profileFile("a.csv", 4);
    state_.inputs["profile.2"].path = folder_ / "missing.csv";
    state_.inputs["profile.3"].path = profileFile("c.csv", 2);
    state_.parameters = {{"tolerance_um", 3.0}};
    const task::Outcome outcome = run(roundnessTask());
    const Json json = outcome.json();
    ASSERT_EQ(json["profiles"].size(), 2u);
    EXPECT_EQ(json["profiles"][0]["path"], state_.inputs["profile"].path);
    EXPECT_NEAR(json["profiles"][1]["circles"]["MZCI"]["RONt_um"].get<double>(), 4, 0.01);
    ASSERT_EQ(outcome.errors.size(), 1u);
    EXPECT_EQ(outcome.errors.front().code(), errors::fileNotFound);
    EXPECT_FALSE(outcome.report);
    EXPECT_FALSE(outcome.writers.count(qdasExport));  // a table that lacks a profile would pass for whole
    EXPECT_EQ(outcome.verdict, Verdict::Fail);
    EXPECT_THROW(roundness(), Error);
}

TEST_F(RecordTasks, TheNotesOfAProfileAreThoseOfItsFileAndItsResult)
{
    state_.inputs["profile"].path = profileFile("a.csv", 4);
    state_.inputs["profile.2"].path = profileFile("b.csv", 2);
    state_.parameters = {{"cutoff_upr", 500.0}};
    const task::Outcome outcome = run(roundnessTask());
    const Json json = outcome.json();
    const std::size_t of_first = json["profiles"][0]["notes"].size(), of_second = json["profiles"][1]["notes"].size();
    ASSERT_GT(of_first, 0u);
    ASSERT_EQ(outcome.notes.size(), of_first + of_second);
    const Json all = toJson(outcome.notes);
    for (std::size_t i = 0; i < of_first; ++i) EXPECT_EQ(all[i], json["profiles"][0]["notes"][i]);
    for (std::size_t i = 0; i < of_second; ++i) EXPECT_EQ(all[of_first + i], json["profiles"][1]["notes"][i]);
}

TEST_F(RecordTasks, AFilterExcludesNoFilter)
{
    state_.inputs["profile"].path = profileFile("a.csv", 4);
    state_.inputs["record"].path = recordFile(3);
    state_.parameters = {{"no_filter", true}};
    EXPECT_NO_THROW(roundness());
    set(state_.parameters, "cutoff_upr", 50.0);
    for (const task::Task* task : {&roundnessTask(), &trajectoryTask(), &motionTask()}) {
        try {
            run(*task);
            ADD_FAILURE() << task->title.english;
        } catch (const Error& error) {
            EXPECT_EQ(error.code(), errors::valueNotUnderstood);
            EXPECT_EQ(*find(error.values(), "parameter"), Value(std::string("--no-filter")));
        }
    }
}

TEST_F(RecordTasks, AnItemOfTheProjectIsAProfile)
{
    state_.inputs["profile"].item = "section at 60 mm";
    EXPECT_THROW(roundness(), Error);
    state_.items["profile"] = {profileItem, toValues(ovalProfile(5)), {}};
    const RoundnessOutcome outcome = roundness();
    EXPECT_NEAR(outcome.results.front().circles.MZCI.RONt_um, 10, 0.01);
    EXPECT_EQ(outcome.paths.front(), "section at 60 mm");
    ASSERT_EQ(sources_.inputs.size(), 1u);
    EXPECT_EQ(sources_.inputs.front().sha256.size(), 64u);
}

TEST_F(RecordTasks, AProfileGoesBeforeARecord)
{
    EXPECT_THROW(roundness(), Error);
    state_.inputs["record"].path = recordFile(3);
    const RoundnessOutcome of_record = roundness();
    ASSERT_TRUE(of_record.chosenSection());
    EXPECT_EQ(of_record.section, of_record.trajectory->worstSection());
    EXPECT_EQ(of_record.results.front().circles.MZCI.RONt_um,
              of_record.chosenSection()->roundness.circles.MZCI.RONt_um);
    state_.inputs["profile"].path = profileFile("a.csv", 4);
    const RoundnessOutcome of_profile = roundness();
    EXPECT_FALSE(of_profile.chosenSection());
    EXPECT_NEAR(of_profile.results.front().circles.MZCI.RONt_um, 8, 0.01);
}

TEST_F(RecordTasks, ASectionIsChosenByItsNumber)
{
    state_.inputs["record"].path = recordFile(3);
    const int worst = roundness().chosenSection()->section;
    for (const int number : {1, 2, 3}) {
        set(state_.parameters, sectionKey, std::int64_t{number});
        const RoundnessOutcome outcome = roundness();
        EXPECT_EQ(outcome.chosenSection()->section, number);
        EXPECT_FALSE(contains(outcome.notes, notes::sectionNotThere));
    }
    set(state_.parameters, sectionKey, std::int64_t{7});
    const RoundnessOutcome outcome = roundness();
    EXPECT_EQ(outcome.chosenSection()->section, worst);
    EXPECT_TRUE(contains(outcome.notes, notes::sectionNotThere));
}

TEST_F(RecordTasks, ATraceIsLaidOnTheProfileOrOnTheSection)
{
    state_.inputs["trace"].path = profileFile("trace.csv", 5);
    state_.inputs["profile"].path = profileFile("a.csv", 4);
    EXPECT_NEAR(roundness().superimposed->largest_difference_um, 1, 0.01);
    state_.inputs["profile.2"].path = profileFile("b.csv", 4);
    EXPECT_THROW(run(roundnessTask()), Error);
    state_.inputs.erase("profile");
    state_.inputs.erase("profile.2");
    state_.inputs["record"].path = recordFile(3);
    const RoundnessOutcome of_record = roundness();
    ASSERT_TRUE(of_record.superimposed);
    EXPECT_EQ(sources_.inputs.size(), 2u);
    EXPECT_TRUE(run(roundnessTask()).json().contains("superimposed"));
}

TEST_F(RecordTasks, ARecordIsEvaluatedOnceForAllTasks)
{
    state_.inputs["record"].path = recordFile(3);
    const auto evaluated = roundness().trajectory;
    set(state_.parameters, sectionKey, std::int64_t{2});
    EXPECT_EQ(answerTrajectory(state_, stores_, sources_, {}).trajectory, evaluated);
    EXPECT_EQ(answerMotion(state_, stores_, sources_, {}).trajectory, evaluated);
}

TEST_F(RecordTasks, TheNumbersOfTheMotionAreThoseOfTheTrajectory)
{
    state_.inputs["record"].path = recordFile(3);
    const task::Outcome whole = run(trajectoryTask());
    const Json json = resultOf(trajectoryTask(), state_, sources_, whole);
    set(state_.parameters, sectionKey, std::int64_t{2});
    const task::Outcome motion = run(motionTask());
    EXPECT_EQ(resultOf(motionTask(), state_, sources_, motion), json);
}

TEST_F(RecordTasks, TheMotionIsJudgedByItsOwnLimit)
{
    state_.inputs["record"].path = recordFile(3);
    set(state_.parameters, "tolerance_um", 0.001);  // of the roundness
    const task::Outcome free = run(motionTask());
    EXPECT_FALSE(free.verdict);
    const report::Answer told = free.answer({});
    ASSERT_TRUE(told.value && told.expanded_uncertainty);
    const double total_um = *told.value;
    for (const auto& [limit_um, expected] : {std::pair{2 * total_um, Verdict::Pass}, {total_um / 2, Verdict::Fail}}) {
        set(state_.parameters, "error_motion_limit_um", limit_um);
        const task::Outcome judged = run(motionTask());
        EXPECT_EQ(judged.verdict, expected);
        EXPECT_EQ(judged.answer({}).verdict, expected);
        EXPECT_EQ(judged.answer({}).upper_limit, limit_um);
    }
    // The verb says it as well: the worst of all sections, beside the roundness.
    set(state_.parameters, "tolerance_um", 1000.0);
    const task::Outcome whole = run(trajectoryTask());
    EXPECT_EQ(whole.verdict, Verdict::Fail);
    const Json json = resultOf(trajectoryTask(), state_, sources_, whole);
    EXPECT_EQ(json["verdict"], "pass");
    EXPECT_EQ(json["error_motion_verdict"], "fail");
    EXPECT_EQ(whole.answer({}).findings.back().verdict, Verdict::Fail);
    set(state_.parameters, "error_motion_limit_um", total_um + *told.expanded_uncertainty / 2);
    set(state_.parameters, "decision", std::string("guarded"));
    EXPECT_EQ(run(motionTask()).verdict, Verdict::Undecided);
}

TEST_F(RecordTasks, ARecordWithoutAResultStillHasItsSignals)
{
    state_.inputs["record"].path = recordFile(3);
    state_.parameters = {{"channels", std::string("marker=1,X3=0,Y3=2,Xp=3,Yp=4")}};
    const MotionOutcome motion = answerMotion(state_, stores_, sources_, {});
    ASSERT_TRUE(motion.problem);
    ASSERT_TRUE(motion.time_signals);
    EXPECT_EQ(motion.time_signals->size(), 5u);
    const task::Outcome outcome = run(motionTask());
    EXPECT_EQ(outcome.errors.size(), 1u);
    EXPECT_FALSE(outcome.report);
    EXPECT_TRUE(outcome.writers.empty());
    EXPECT_THROW(run(trajectoryTask()), Error);
}

}  // namespace
}  // namespace lathelier::trajectory
