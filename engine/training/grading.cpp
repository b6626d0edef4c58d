#include <algorithm>
#include <cmath>

#include "engine/core/units.h"
#include "engine/training/decay.h"
#include "engine/training/exercise.h"
#include "engine/training/exercise_draw.h"

namespace lathelier::training {
namespace {

constexpr double fullPoints = 10;
constexpr double fewWaves = 0.3;  ///< amplitude ratio of the decay used in the explanation

/// Full points within the tolerance, half within twice the tolerance.
void gradeNumber(Grade& grade, double expected, double tolerance, double answer)
{
    grade.expected = {{expected - tolerance, expected + tolerance}};
    const double error = std::abs(answer - expected);
    grade.correct = error <= tolerance;
    grade.points = grade.correct ? fullPoints : error <= 2 * tolerance ? fullPoints / 2 : 0;
}

/// Speed intervals of the exercise with a stable depth.
std::vector<Interval> stableSpeeds(const Exercise& exercise, const stability::LobeLimit& limit)
{
    std::vector<Interval> stable;
    const double depth = exercise.depth_mm;
    bool inside = false;
    for (std::size_t i = 0; i < limit.speed_rpm.size(); ++i) {
        const double speed = limit.speed_rpm[i], here = limit.depth_mm[i];
        const bool is_stable = here >= depth;
        if (is_stable != inside) {
            double edge = speed;
            if (i > 0 && std::isfinite(here) && std::isfinite(limit.depth_mm[i - 1])) {
                const double before = limit.depth_mm[i - 1], previous = limit.speed_rpm[i - 1];
                edge = previous + (speed - previous) * (depth - before) / (here - before);
            }
            if (is_stable)
                stable.push_back({edge, limit.speed_rpm.back()});
            else
                stable.back().to = edge;
        }
        inside = is_stable;
    }
    for (Interval& range : stable) {
        range.from = std::max(range.from, exercise.speed_rpm.from);
        range.to = std::min(range.to, exercise.speed_rpm.to);
    }
    std::erase_if(stable, [](const Interval& range) { return range.to < range.from; });
    return stable;
}

void gradeSafeSpeed(const Exercise& exercise, double answer, Grade& grade)
{
    constexpr double stablePoints = 8, closePoints = 3, close = 0.02;
    const stability::LobeLimit limit = limitOver(exercise.hidden, exercise.speed_rpm);
    const BestSpeed best = bestSpeed(limit, exercise.speed_rpm, speedShare);
    const double natural = exercise.hidden.modes.front().frequency_hz;
    grade.expected = stableSpeeds(exercise, limit);
    grade.numbers = {{"speed_rpm", LT_TEXT("Engine", "Speed answered"), answer, unit::rpm, 0},
                     {"depth_mm", LT_TEXT("Engine", "Depth of cut"), exercise.depth_mm, unit::mm, 2},
                     {"limit_mm", LT_TEXT("Engine", "Limit at this speed"), 0, unit::mm, 3},
                     {"best_rpm", LT_TEXT("Engine", "Best speed"), best.speed_rpm, unit::rpm, 0},
                     {"best_mm", LT_TEXT("Engine", "Least limit within 1 % of it"), best.limit_mm, unit::mm, 3},
                     {"natural_hz", LT_TEXT("Engine", "Natural frequency"), natural, unit::hz, 1},
                     {"best_waves", LT_TEXT("Engine", "60 f/N there"), 60 * natural / best.speed_rpm, {}, 2}};
    if (!(answer > 0) || answer > 1e6) return;
    const double here = limit_mm(exercise.hidden, answer, stability::SpeedRelation::Exact);
    grade.numbers[2].value = here;
    const bool in_range = answer >= exercise.speed_rpm.from && answer <= exercise.speed_rpm.to;
    grade.correct = in_range && here >= exercise.depth_mm;
    if (grade.correct) {
        grade.points = leastAbout(limit, answer, speedShare) >= exercise.depth_mm ? fullPoints : stablePoints;
    } else if (in_range) {
        for (const Interval& range : grade.expected)
            if (answer >= range.from * (1 - close) && answer <= range.to * (1 + close)) grade.points = closePoints;
    }
}

void gradeLobeNumber(const Exercise& exercise, double answer, Grade& grade)
{
    constexpr double besidePoints = 3;
    const double speed = exercise.speed_rpm.from;
    const double f = growthOf(exercise.hidden, speed, exercise.depth_mm).frequency_hz;
    const double waves = 60 * f / speed, k = std::floor(waves);
    grade.expected = {{k, k}};
    grade.correct = answer == k;
    grade.points = grade.correct ? fullPoints : std::abs(answer - k) <= 1 ? besidePoints : 0;
    grade.numbers = {{"speed_rpm", LT_TEXT("Engine", "Spindle speed"), speed, unit::rpm, 0},
                     {"frequency_hz", LT_TEXT("Engine", "Frequency of the chatter"), f, unit::hz, 1},
                     {"waves", LT_TEXT("Engine", "Waves in a revolution"), waves, {}, 2},
                     {"k", LT_TEXT("Engine", "Whole waves k"), k, {}, 0},
                     {"phase_deg", LT_TEXT("Engine", "Phase ε between the waves"), 360 * (waves - k), unit::deg, 0}};
}

void gradeDamping(const Exercise& exercise, double answer, Grade& grade)
{
    const std::vector<Peak> peaks = peaksOf(listenToBlow(exercise));
    const double expected = 100 * exercise.hidden.modes.front().damping_ratio;
    gradeNumber(grade, expected, exercise.tolerance, answer);
    std::size_t last = 1;
    while (last + 1 < peaks.size() && peaks[last].deflection_mm > fewWaves * peaks[0].deflection_mm) ++last;
    if (last >= peaks.size()) return;
    const double first_mm = peaks[0].deflection_mm, last_mm = peaks[last].deflection_mm;
    grade.numbers = {{"periods", LT_TEXT("Engine", "Periods"), static_cast<double>(last), {}, 0},
                     {"first_mm", LT_TEXT("Engine", "Amplitude before"), first_mm, unit::mm, 4},
                     {"last_mm", LT_TEXT("Engine", "Amplitude after"), last_mm, unit::mm, 4},
                     {"decrement",
                      LT_TEXT("Engine", "Logarithmic decrement δ"),
                      logDecrement(first_mm, last_mm, static_cast<int>(last)),
                      {},
                      3},
                     {"damping_percent", LT_TEXT("Engine", "Damping ratio ζ"), expected, unit::percent, 2},
                     {"natural_hz", LT_TEXT("Engine", "Natural frequency"), exercise.hidden.modes.front().frequency_hz,
                      unit::hz, 1}};
}

void gradeChatterFrequency(const Exercise& exercise, double answer, Grade& grade)
{
    const double f = growthOf(exercise.hidden, exercise.speed_rpm.from, exercise.depth_mm).frequency_hz;
    gradeNumber(grade, f, exercise.tolerance, answer);
    grade.numbers = {{"frequency_hz", LT_TEXT("Engine", "Frequency of the chatter"), f, unit::hz, 1},
                     {"ten_ms", LT_TEXT("Engine", "Ten swings"), 1e4 / f, LT_TEXT("Engine", "ms"), 1},
                     {"natural_hz", LT_TEXT("Engine", "Natural frequency"), exercise.hidden.modes.front().frequency_hz,
                      unit::hz, 1}};
}

void gradePrediction(const Exercise& exercise, double answer, Grade& grade)
{
    const double speed = exercise.speed_rpm.from;
    const double exact = limit_mm(exercise.hidden, speed, stability::SpeedRelation::Exact);
    const double published = limit_mm(exercise.hidden, speed, stability::SpeedRelation::Published);
    const stability::Growth growth = growthOf(exercise.hidden, speed, exercise.depth_mm);
    const double expected = exercise.depth_mm >= exact ? 1 : 0;
    grade.expected = {{expected, expected}};
    grade.correct = answer == expected;
    grade.points = grade.correct ? fullPoints : 0;
    grade.numbers = {{"depth_mm", LT_TEXT("Engine", "Depth of cut"), exercise.depth_mm, unit::mm, 2},
                     {"waves", LT_TEXT("Engine", "Waves in a revolution"), 60 * growth.frequency_hz / speed, {}, 2},
                     {"limit_mm", LT_TEXT("Engine", "Limit at this speed"), exact, unit::mm, 3},
                     {"published_mm", LT_TEXT("Engine", "Limit at this speed as published"), published, unit::mm, 3},
                     {"growth", LT_TEXT("Engine", "Growth per revolution"), growth.per_revolution, {}, 3}};
}

}  // namespace

Grade grade(const Exercise& exercise, double answer, const Progress& progress)
{
    Grade grade;
    progress.check();
    switch (exercise.kind) {
        case ExerciseKind::SafeSpeed: gradeSafeSpeed(exercise, answer, grade); break;
        case ExerciseKind::LobeNumber: gradeLobeNumber(exercise, answer, grade); break;
        case ExerciseKind::Damping: gradeDamping(exercise, answer, grade); break;
        case ExerciseKind::ChatterFrequency: gradeChatterFrequency(exercise, answer, grade); break;
        case ExerciseKind::Prediction: gradePrediction(exercise, answer, grade); break;
    }
    return grade;
}

}  // namespace lathelier::training
