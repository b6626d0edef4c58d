// The tours of the program: one in every language, the same steps in each, and every task can be done.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "engine/training/lesson.h"

namespace lathelier::training {
namespace {

std::string contentOf(const std::string& name)
{
    std::ifstream file(std::filesystem::path(LATHELIER_SOURCE_DIR) / "resources/training" / name, std::ios::binary);
    std::ostringstream bytes;
    bytes << file.rdbuf();
    return bytes.str();
}

Lesson tour(const std::string& language)
{
    return readLesson(contentOf(language + "/tour.md"), "tour.md");
}

int wordsIn(const std::string& text)
{
    std::istringstream words(text);
    std::string word;
    int count = 0;
    while (words >> word) ++count;
    return count;
}

struct Done {
    const char* scenario;
    double speed_rpm, depth_mm;
};

/// A solution of each step.
const std::vector<Done> solutions{{"slender", 2885, 0.4},   {"slender", 2880, 0.33}, {"slender", 2885, 0.31},
                                  {"slender", 2650, 0.585}, {"slender", 2400, 0.4},  {"slender", 3300, 0.55},
                                  {"slender", 3150, 0.6},   {"slender", 2885, 0.8},  {"tailstock", 2700, 0.92},
                                  {"slender", 3700, 0.4},   {"slender", 2885, 0.4},  {"slender", 3300, 0.6}};

LessonState stateAfter(const Step& step, const char* scenario, double speed_rpm, double depth_mm)
{
    const Scenario& machine = *findScenario(scenario);
    return stateOf(machine, limitsOf(machine), step.set.relation.value_or(stability::SpeedRelation::Exact),
                   stability::simulate(machine.modes, cutOf(machine, speed_rpm, depth_mm)));
}

TEST(Tour, LanguagesHaveTheSameSteps)
{
    const Lesson english = tour("en"), polish = tour("pl");
    ASSERT_EQ(english.steps.size(), 12U);
    ASSERT_EQ(polish.steps.size(), english.steps.size());
    EXPECT_NE(english.title, polish.title);
    for (std::size_t i = 0; i < english.steps.size(); ++i) {
        SCOPED_TRACE(english.steps[i].heading);
        const Step &a = english.steps[i], &b = polish.steps[i];
        EXPECT_EQ(a.set, b.set);
        EXPECT_EQ(a.show, b.show);
        EXPECT_EQ(a.checks, b.checks);
        for (const Step& step : {a, b}) {
            EXPECT_FALSE(step.hint.empty());
            EXPECT_FALSE(step.checks.empty());
            EXPECT_FALSE(step.show.empty());
            const int words = wordsIn(step.body + " " + step.task);
            EXPECT_GE(words, 40);
            EXPECT_LE(words, 90);
        }
    }
}

TEST(Tour, EveryTaskCanBeDoneAndIsNotDoneAtFirst)
{
    const Lesson lesson = tour("en");
    ASSERT_EQ(lesson.steps.size(), solutions.size());
    for (std::size_t i = 0; i < solutions.size(); ++i) {
        const Step& step = lesson.steps[i];
        SCOPED_TRACE(step.heading);
        ASSERT_NE(findScenario(step.set.scenario), nullptr);
        LessonState before = stateAfter(step, step.set.scenario.c_str(), *step.set.speed_rpm, *step.set.depth_mm);
        before.view = step.show.front();
        EXPECT_FALSE(isDone(step, before));
        before.heard_s = 60;  // listening alone never completes a step
        EXPECT_FALSE(isDone(step, before));
        LessonState after = stateAfter(step, solutions[i].scenario, solutions[i].speed_rpm, solutions[i].depth_mm);
        after.view = step.show.front();
        after.heard_s = 2;
        for (const Check& check : step.checks) EXPECT_TRUE(isMet(check, after)) << written(check);
        const Scenario& machine = *findScenario(solutions[i].scenario);
        EXPECT_LE(solutions[i].depth_mm, machine.greatest_depth_mm);  // the point can be dragged there
    }
}

/// Following the hint completes the task.
TEST(Tour, TheHintsAreTrue)
{
    const Lesson lesson = tour("en");
    EXPECT_TRUE(isDone(lesson.steps[2], stateAfter(lesson.steps[2], "slender", 2885, 0.31)));
    EXPECT_TRUE(isDone(lesson.steps[7], stateAfter(lesson.steps[7], "slender", 2885, 0.8)));
    EXPECT_TRUE(isDone(lesson.steps[9], stateAfter(lesson.steps[9], "slender", 3700, 0.35)));
    // The worn bearing does not satisfy the question for a better machine.
    EXPECT_FALSE(isDone(lesson.steps[8], stateAfter(lesson.steps[8], "worn_bearing", 2700, 0.92)));
    EXPECT_TRUE(isDone(lesson.steps[8], stateAfter(lesson.steps[8], "rigid", 2700, 0.92)));
}

/// The guide for schools: its example is valid, and all keys are documented.
TEST(Tour, TheGuideForSchoolsIsTrue)
{
    const std::string guide = contentOf("README.md");
    const std::size_t begin = guide.find("```\n") + 4, end = guide.find("```\n", begin);
    const Lesson example = readLesson(guide.substr(begin, end - begin), "README.md");
    ASSERT_EQ(example.steps.size(), 1U);
    EXPECT_TRUE(isDone(example.steps[0], stateAfter(example.steps[0], "slender", 2800, 0.4)));
    std::vector<std::string> keys;
    for (const QuantityOf<LessonState>& quantity : quantities<LessonState>()) keys.push_back(quantity.info.key);
    for (const auto* choices : {&viewChoices(), &relationChoices(), &exerciseChoices()})
        for (const FieldChoice& choice : *choices) keys.push_back(choice.key);
    for (const Scenario& scenario : scenarios()) keys.push_back(scenario.key);
    for (const std::string& key : keys) EXPECT_NE(guide.find("`" + key + "`"), std::string::npos) << key;
}

}  // namespace
}  // namespace lathelier::training
