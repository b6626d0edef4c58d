// Exercises: the same bits for the same seed, solvable from displayed and audible data, wrong answers fail.
#include "engine/training/exercise.h"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>

#include "engine/core/core_codes.h"
#include "engine/core/texts.h"
#include "tests/engine/core/code_of_error.h"

namespace lathelier::training {
namespace {

using stability::CutVerdict;
using stability::SpeedRelation;

constexpr std::uint32_t seeds = 50;

/// Oscillations per second over the last second of a cut, by its crossings of the steady deflection.
double heardFrequency(const stability::SimulationResult& cut)
{
    const std::vector<double>& x = cut.deflection_mm;
    const auto from = x.size() - std::min(x.size(), static_cast<std::size_t>(std::lround(1 / cut.step_s)));
    double mean = 0;
    for (std::size_t i = from; i < x.size(); ++i) mean += x[i] / static_cast<double>(x.size() - from);
    std::optional<double> first, last;
    int swings = -1;
    for (std::size_t i = from + 1; i < x.size(); ++i) {
        if (!(x[i - 1] < mean && x[i] >= mean)) continue;
        last = static_cast<double>(i) - (x[i] - mean) / (x[i] - x[i - 1]);
        if (!first) first = last;
        ++swings;
    }
    return swings / ((*last - *first) * cut.step_s);
}

double given(const Exercise& exercise, const std::string& key)
{
    for (const NamedNumber& number : exercise.givens)
        if (number.key == key) return number.value;
    ADD_FAILURE() << key;
    return 0;
}

/// The questions and explanations name only numbers that are there.
void expectFilled(Text pattern, const std::vector<NamedNumber>& numbers)
{
    EXPECT_EQ(fill(text(pattern), valuesOf(numbers)).find('{'), std::string::npos)
        << fill(text(pattern), valuesOf(numbers));
}

void expectFailed(const Exercise& exercise, double answer)
{
    const Grade failed = grade(exercise, answer);
    EXPECT_FALSE(failed.correct) << exercise.seed << " " << answer;
    EXPECT_LT(failed.points, 10) << exercise.seed << " " << answer;
}

TEST(Exercise, SameSeedGivesTheSameBits)
{
    for (std::size_t kind = 0; kind < exerciseChoices().size(); ++kind)
        for (std::uint32_t seed = 0; seed < seeds; ++seed) {
            const Exercise a = makeExercise(static_cast<ExerciseKind>(kind), seed);
            const Exercise b = makeExercise(static_cast<ExerciseKind>(kind), seed);
            EXPECT_EQ(a.hidden.modes, b.hidden.modes);
            EXPECT_EQ(a.hidden.cutting_coefficient_N_mm2, b.hidden.cutting_coefficient_N_mm2);
            EXPECT_EQ(a.speed_rpm, b.speed_rpm);
            EXPECT_EQ(a.depth_mm, b.depth_mm);
            EXPECT_EQ(a.tolerance, b.tolerance);
            const Exercise other = makeExercise(static_cast<ExerciseKind>(kind), seed + 1);
            EXPECT_FALSE(a.hidden.modes == other.hidden.modes && a.speed_rpm == other.speed_rpm);
            expectFilled(questionOf(a.kind), a.givens);
            expectFilled(explanationOf(a.kind), grade(a, 1).numbers);
        }
}

TEST(Exercise, AnswersThatAreNoNumbersHaveNoPoints)
{
    for (std::size_t kind = 0; kind < exerciseChoices().size(); ++kind) {
        const Exercise exercise = makeExercise(static_cast<ExerciseKind>(kind), 5);
        for (const double answer : {std::nan(""), HUGE_VAL, -HUGE_VAL, -1e300, 1e300, -1.0}) {
            EXPECT_EQ(grade(exercise, answer).points, 0) << kind << " " << answer;
            EXPECT_FALSE(grade(exercise, answer).correct);
        }
    }
}

/// From the frequency f of a first cut the nearest 60 f/j is answered; two further cuts correct it.
TEST(Exercise, ASafeSpeedIsFoundByThreeCuts)
{
    int first_time = 0;
    double stable_share = 0;
    for (std::uint32_t seed = 0; seed < seeds; ++seed) {
        const Exercise exercise = makeExercise(ExerciseKind::SafeSpeed, seed);
        const auto& [from, to] = exercise.speed_rpm;
        double speed = exercise.hidden.start_speed_rpm;
        stability::SimulationResult cut = listen(exercise, speed, exercise.depth_mm);
        for (int more = 1; more < exercise.cuts && cut.cut != CutVerdict::Stable; ++more) {
            const double f = cut.frequency_hz;
            double best = from;
            for (int j = 1; j < 40; ++j)
                if (const double n = 60 * f / j; n > from && n < to) best = std::max(best, n * (more == 1 ? 1 : 0.98));
            speed = best;
            cut = listen(exercise, speed, exercise.depth_mm);
            first_time += more == 1 && cut.cut == CutVerdict::Stable;
        }
        const Grade right = grade(exercise, speed);
        EXPECT_TRUE(right.correct) << seed << " " << speed << " limit " << right.numbers[2].value << " depth "
                                   << exercise.depth_mm << " best " << right.numbers[3].value;
        EXPECT_GE(right.points, 8);
        EXPECT_EQ(right.correct, cut.cut == CutVerdict::Stable) << seed;
        ASSERT_FALSE(right.expected.empty());
        double wide = 0;
        for (const Interval& range : right.expected) {
            EXPECT_LT(range.from, range.to);
            wide += range.to - range.from;
            EXPECT_TRUE(grade(exercise, (range.from + range.to) / 2).correct) << seed;
            if (range.from > from) expectFailed(exercise, range.from - 0.01 * from);
            if (range.to < to) expectFailed(exercise, range.to + 0.01 * from);
        }
        stable_share += wide / (to - from) / seeds;
        EXPECT_EQ(grade(exercise, given(exercise, "depth_mm")).points, 0);
        const double best = right.numbers[3].value;
        const double best_waves = right.numbers.back().value;
        EXPECT_LT(std::abs(best_waves - std::round(best_waves)), 0.2) << seed;  // "close to a whole number"
        EXPECT_EQ(grade(exercise, best).points, 10) << seed;
        expectFailed(exercise, from * 0.9);
        expectFailed(exercise, to * 1.1);
    }
    RecordProperty("solved_by_the_second_cut", first_time);
    EXPECT_LT(stable_share, 0.5);  // guessing is not sufficient
}

TEST(Exercise, WavesAreCountedOnTheSurface)
{
    for (std::uint32_t seed = 0; seed < seeds; ++seed) {
        const Exercise exercise = makeExercise(ExerciseKind::LobeNumber, seed);
        const double speed = exercise.speed_rpm.from;
        const stability::SimulationResult cut = listen(exercise, speed, exercise.depth_mm);
        EXPECT_EQ(cut.cut, CutVerdict::Chatter) << seed;
        const double k = std::floor(heardFrequency(cut) * 60 / speed);
        EXPECT_TRUE(grade(exercise, k).correct) << seed << " " << k;
        EXPECT_EQ(grade(exercise, k).points, 10);
        for (const double wrong : {k - 2, k - 1, k + 1, k + 2, k + 0.75}) expectFailed(exercise, wrong);
    }
}

TEST(Exercise, DampingIsReadFromTheDecay)
{
    for (std::uint32_t seed = 0; seed < seeds; ++seed) {
        const Exercise exercise = makeExercise(ExerciseKind::Damping, seed);
        const std::vector<Peak> peaks = peaksOf(listenToBlow(exercise));
        ASSERT_GT(peaks.size(), 4U) << seed;
        const double damping = 100 * dampingRatio(logDecrement(peaks[0].deflection_mm, peaks[3].deflection_mm, 3));
        EXPECT_NEAR(damping, 100 * exercise.hidden.modes.front().damping_ratio, 0.01 * damping) << seed;
        EXPECT_EQ(grade(exercise, damping).points, 10) << seed;
        EXPECT_TRUE(grade(exercise, std::round(10 * damping) / 10).correct) << seed;
        for (const double wrong : {damping / 2, damping * 2, damping * 1.15, damping * 0.85, damping / 100})
            expectFailed(exercise, wrong);
    }
}

TEST(Exercise, TheFrequencyIsHeard)
{
    for (std::uint32_t seed = 0; seed < seeds; ++seed) {
        const Exercise exercise = makeExercise(ExerciseKind::ChatterFrequency, seed);
        const stability::SimulationResult cut = listen(exercise, exercise.speed_rpm.from, exercise.depth_mm);
        EXPECT_EQ(cut.cut, CutVerdict::Chatter) << seed;
        const double heard = heardFrequency(cut);
        EXPECT_EQ(grade(exercise, heard).points, 10) << seed << " " << heard << " " << cut.frequency_hz;
        for (const double wrong : {heard / 2, heard * 2, heard * 1.07, heard * 0.93}) expectFailed(exercise, wrong);
    }
}

/// The exact relation agrees with the simulation; N = 60 f/k of the papers predicts the opposite.
TEST(Exercise, ThePredictionIsThatOfTheExactRelation)
{
    int chatter = 0;
    for (std::uint32_t seed = 0; seed < seeds; ++seed) {
        const Exercise exercise = makeExercise(ExerciseKind::Prediction, seed);
        const double speed = exercise.speed_rpm.from;
        // By hand: about three quarters of a wave more than a whole number is the bottom of a lobe.
        const double waves = 60 * given(exercise, "bottom_hz") / speed, part = waves - std::floor(waves);
        const double by_hand = std::abs(part - 0.75) < 0.125 ? 1 : 0;
        EXPECT_GT(exercise.depth_mm, given(exercise, "least_mm"));
        EXPECT_EQ(grade(exercise, by_hand).points, 10) << seed << " " << part;
        expectFailed(exercise, 1 - by_hand);
        expectFailed(exercise, 0.5);
        const stability::SimulationResult cut = listen(exercise, speed, exercise.depth_mm);
        EXPECT_EQ(cut.cut, by_hand == 1 ? CutVerdict::Chatter : CutVerdict::Stable) << seed;
        const bool published = exercise.depth_mm > limit_mm(exercise.hidden, speed, SpeedRelation::Published);
        EXPECT_NE(published, by_hand == 1) << seed;
        chatter += by_hand == 1;
    }
    EXPECT_GT(chatter, 10);
    EXPECT_LT(chatter, 40);
}

TEST(Exercise, CutsOutsideTheirRangeAreRefused)
{
    const Exercise exercise = makeExercise(ExerciseKind::SafeSpeed, 1);
    const double speed = exercise.speed_rpm.from;
    for (const double wrong : {speed - 1, exercise.speed_rpm.to + 1, std::nan(""), 0.0, HUGE_VAL})
        EXPECT_EQ(codeOfError([&] { listen(exercise, wrong, exercise.depth_mm); }), errors::valueOutOfRange);
    for (const double wrong : {0.0, -1.0, std::nan(""), exercise.hidden.greatest_depth_mm * 1.01})
        EXPECT_EQ(codeOfError([&] { listen(exercise, speed, wrong); }), errors::valueOutOfRange);
}

}  // namespace
}  // namespace lathelier::training
