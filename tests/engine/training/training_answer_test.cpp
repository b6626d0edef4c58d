// What the class is told of a cut: how fast it grows or dies, and how far its depth is from the limit.
#include <gtest/gtest.h>

#include <cmath>

#include "engine/training/task/training_task.h"

namespace lathelier::training {
namespace {

TrainingOutcome cutAt(double share_of_limit)
{
    project::PanelState state;
    Stores stores;
    task::Sources sources;
    const TrainingOutcome first = answerTraining(state, stores, sources, {});
    set(state.parameters, "operating_speed_rpm", first.point.speed_rpm);
    set(state.parameters, "operating_depth", share_of_limit * first.state.limit_mm);
    return answerTraining(state, stores, sources, {});
}

TEST(TrainingAnswer, SaysHowFastItGrowsAndHowMuchTooDeepItIs)
{
    const TrainingOutcome outcome = cutAt(1.5);
    const report::Answer told = answer(outcome);
    EXPECT_EQ(told.verdict, Verdict::Fail);
    const std::string sentence = report::sentenceText(told);
    EXPECT_NE(sentence.find("Grows"), std::string::npos) << sentence;
    EXPECT_NE(sentence.find("too deep"), std::string::npos) << sentence;
    EXPECT_GT(outcome.cut->growth_per_revolution, 1);
    EXPECT_LT(*told.upper_limit, *told.value);
}

TEST(TrainingAnswer, SaysHowFastItDiesAndHowFarTheLimitIs)
{
    const TrainingOutcome outcome = cutAt(0.5);
    const report::Answer told = answer(outcome);
    EXPECT_EQ(told.verdict, Verdict::Pass);
    const std::string sentence = report::sentenceText(told);
    EXPECT_NE(sentence.find("Dies away"), std::string::npos) << sentence;
    EXPECT_NE(sentence.find("to the limit"), std::string::npos) << sentence;
    EXPECT_LT(outcome.cut->growth_per_revolution, 1);
}

TEST(TrainingAnswer, TellsNothingToAClassThatIsToListen)
{
    project::PanelState state;
    set(state.parameters, "hide_chart", true);
    Stores stores;
    task::Sources sources;
    const report::Answer told = answer(answerTraining(state, stores, sources, {}));
    EXPECT_FALSE(told.verdict);
    EXPECT_FALSE(told.value);
}

}  // namespace
}  // namespace lathelier::training
