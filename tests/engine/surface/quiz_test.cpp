// Questions: reproducible by number, solvable, and wrong answers are classified.
#include "engine/surface/quiz.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

namespace lathelier::surface {
namespace {

TEST(Quiz, QuestionsCanBeAnswered)
{
    std::set<double> frequencies;
    for (int number = 1; number <= 200; ++number) {
        const SyntheticParameters p = quizPicture(number);
        const Waves waves = wavesPerRevolution(p.frequency_hz, p.speed_rpm);
        EXPECT_GE(std::abs(waves.nu), 0.099);
        EXPECT_LE(std::abs(waves.nu), 0.401);
        EXPECT_GE(waves.m, 4);
        EXPECT_LE(waves.m, 14);
        EXPECT_GT(p.amplitude_um, 0);
        frequencies.insert(p.frequency_hz);
        EXPECT_EQ(quizPicture(number).frequency_hz, p.frequency_hz);
    }
    EXPECT_GT(frequencies.size(), 190U);
}

TEST(Quiz, WrongAnswersAreToldApart)
{
    SyntheticParameters p;
    p.speed_rpm = 2016;  // n = 33.6 Hz
    p.frequency_hz = 361;
    EXPECT_EQ(checkedAnswer(361 + 3, p).verdict, QuizVerdict::Right);
    EXPECT_EQ(checkedAnswer(33.6 * 11.256, p).verdict, QuizVerdict::OtherSign);
    const QuizAnswer waves = checkedAnswer(361 - 2 * 33.6, p);
    EXPECT_EQ(waves.verdict, QuizVerdict::OtherWaves);
    EXPECT_EQ(waves.waves, -2);
    EXPECT_EQ(checkedAnswer(722, p).verdict, QuizVerdict::Multiple);
    EXPECT_EQ(checkedAnswer(50, p).verdict, QuizVerdict::Wrong);
}

}  // namespace
}  // namespace lathelier::surface
