// The task surface without a window: one object for the pictures of the command line and of a window, pictures that
// cannot be read, regions of pictures that were taken away, what is evaluated once.
#include "engine/surface/task/surface_task.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "engine/core/core_codes.h"
#include "engine/core/texts.h"
#include "engine/io/file.h"
#include "engine/surface/synthetic.h"
#include "tests/scratch_folder.h"

namespace lathelier::surface {
namespace {

class SurfaceTask : public ::testing::Test {
protected:
    SurfaceTask()
    {
        SyntheticParameters picture;
        picture.width = 420;
        picture.height = 300;
        picture.amplitude_um = 9;
        io::writeFile(path("before.png"), syntheticPng(syntheticPicture(picture)));
        picture.amplitude_um = 0;
        picture.seed = 2;
        io::writeFile(path("after.png"), syntheticPng(syntheticPicture(picture)));
        state_.inputs[beforeRole].path = path("before.png");
        state_.inputs[afterRole].path = path("after.png");
        state_.parameters = {{"feed_mm_rev", 0.1}, {"diameter_mm", 30.0}, {"mm_per_px", 0.006}};
    }
    std::string path(const char* name) const { return (folder_ / name).string(); }
    SurfaceOutcome answerOf(const project::PanelState& state)
    {
        task::Sources sources;
        return answerSurface(state, stores_, sources, {});
    }
    static std::string objectOf(const SurfaceOutcome& outcome)
    {
        const auto shared = std::make_shared<const SurfaceOutcome>(outcome);
        return task::resultOf(surfaceTask(), outcome.asked, outcome.sources, outcomeOf(shared)).dump();
    }
    ScratchFolder folder_;
    project::PanelState state_;
    Stores stores_;
};

TEST_F(SurfaceTask, SaysTheSameOfAPictureAfterAndOfASecondOne)
{
    project::PanelState window = state_;
    set(window.parameters, speedBeforeKey, 2016.0);
    set(window.parameters, speedAfterKey, 2154.0);
    set(window.parameters, spareRegionsKey, true);
    project::PanelState line = state_;
    line.inputs[project::keyOf(beforeRole, 2)] = line.inputs.at(afterRole);
    line.inputs.erase(afterRole);
    SurfaceQuestion question;
    question.surface.speed_rpm = {{2016}, {2154}};
    set(line.parameters, "speed_rpm", *find(toValues(question), "speed_rpm"));
    const SurfaceOutcome of_window = answerOf(window);
    ASSERT_TRUE(of_window.result && of_window.result->comparison);
    EXPECT_EQ(objectOf(of_window), objectOf(answerOf(line)));
}

TEST_F(SurfaceTask, ReportsTogetherWhatCannotBeRead)
{
    io::writeFile(path("broken.png"), "no picture");
    project::PanelState state = state_;
    state.inputs[beforeRole].path = path("broken.png");
    state.inputs[project::keyOf(beforeRole, 2)].path = path("missing.png");
    const SurfaceOutcome outcome = answerOf(state);
    ASSERT_EQ(outcome.unread.size(), 2u);
    EXPECT_NE(text(outcome.unread[0]).find("broken.png"), std::string::npos);
    EXPECT_NE(text(outcome.unread[1]).find("missing.png"), std::string::npos);
    EXPECT_FALSE(outcome.result);
    const auto all = outcomeOf(std::make_shared<const SurfaceOutcome>(outcome));
    EXPECT_EQ(all.errors.size(), 2u);
    EXPECT_FALSE(all.json || all.report);
}

TEST_F(SurfaceTask, KeepsTheRegionOfAPictureThatWasTakenAwayInAWindowOnly)
{
    SurfaceQuestion question;
    question.surface.roi = {{0, 0, 300, 300}, {0, 0, 200, 200}};
    set(state_.parameters, "roi", *find(toValues(question), "roi"));
    state_.inputs.erase(afterRole);
    const SurfaceOutcome refused = answerOf(state_);
    ASSERT_TRUE(refused.refused);
    EXPECT_EQ(refused.refused->code(), errors::valueNotUnderstood);
    set(state_.parameters, spareRegionsKey, true);
    const SurfaceOutcome outcome = answerOf(state_);
    ASSERT_TRUE(outcome.result);
    EXPECT_EQ(outcome.result->parameters.roi.size(), 1u);
    EXPECT_EQ(outcome.question.surface.roi.size(), 2u);
}

TEST_F(SurfaceTask, EvaluatesOnceWhatAnotherLightDoesNotChange)
{
    const SurfaceOutcome before = answerOf(state_);
    set(state_.parameters, "lighting", std::string("from the left"));
    EXPECT_EQ(answerOf(state_).result, before.result);
    set(state_.parameters, "alpha", 1e-4);
    EXPECT_NE(answerOf(state_).result, before.result);
}

TEST_F(SurfaceTask, AnOpenQuestionTellsNothing)
{
    state_ = {};
    state_.parameters = {{makeKey, true}, {quizKey, true}};
    const SurfaceOutcome outcome = answerOf(state_);
    ASSERT_TRUE(outcome.asks() && outcome.result);
    const auto all = outcomeOf(std::make_shared<const SurfaceOutcome>(outcome));
    EXPECT_TRUE(all.notes.empty());
    EXPECT_FALSE(all.json || all.summary || all.products);
    EXPECT_FALSE(all.answer({}).value);
    EXPECT_TRUE(task::documentOf(surfaceTask(), state_, outcome.sources, all).results.empty());
}

}  // namespace
}  // namespace lathelier::surface
