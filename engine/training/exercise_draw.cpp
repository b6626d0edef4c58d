#include "engine/training/exercise_draw.h"

#include <algorithm>
#include <cmath>

#include "engine/core/random.h"
#include "engine/training/lesson_state.h"

namespace lathelier::training {
namespace {

constexpr int limitPoints = 1501;  ///< points of the limit over a range
constexpr int mostTries = 200;     ///< after which the last draw is accepted
constexpr double highestSpeed_rpm = 4200;

/// Sequence of random numbers.
class Draw {
public:
    Draw(ExerciseKind kind, std::uint32_t seed) : seed_(seed), stream_(static_cast<std::uint64_t>(kind) + 1) {}

    double between(double from, double to) { return from + (to - from) * randomUniform(seed_, stream_, next_++); }
    int whole(int from, int to) { return from + static_cast<int>(between(0, to - from + 1)); }

private:
    std::uint64_t seed_, stream_, next_ = 0;
};

double rounded(double value, double step)
{
    return std::round(value / step) * step;
}

/// One mode; its limit at all speeds is between a few tenths of a millimetre and slightly above one: a_min = 2 k ζ (1 +
/// ζ)/K_r.
Scenario machineOf(Draw& draw, const Interval& frequency_hz, const Interval& damping_percent)
{
    Scenario machine;
    machine.key = "exercise";
    machine.name = LT_TEXT("Engine", "Hidden machine");
    machine.description = LT_TEXT("Engine", "A machine of an exercise: one mode, which is to be found out.");
    stability::Mode mode;
    mode.frequency_hz = rounded(draw.between(frequency_hz.from, frequency_hz.to), 1);
    mode.damping_ratio = rounded(draw.between(damping_percent.from, damping_percent.to), 0.05) / 100;
    machine.cutting_coefficient_N_mm2 = rounded(draw.between(1600, 2600), 50);
    const double least_mm = draw.between(0.3, 1.2);
    mode.stiffness_N_mm = rounded(
        least_mm * machine.cutting_coefficient_N_mm2 / (2 * mode.damping_ratio * (1 + mode.damping_ratio)), 100);
    machine.modes = {mode};
    machine.diameter_mm = rounded(draw.between(25, 60), 1);
    machine.feed_mm_rev = rounded(draw.between(0.08, 0.15), 0.01);
    machine.greatest_depth_mm = rounded(5 * least_mm, 0.1);
    return machine;
}

/// The frequency of the minimum real part, at which the lobes have their minima.
double bottomFrequency(const Scenario& machine)
{
    const stability::Mode& mode = machine.modes.front();
    return mode.frequency_hz * std::sqrt(1 + 2 * mode.damping_ratio);
}

void showOneSpeed(Exercise& exercise, double speed_rpm)
{
    exercise.speed_rpm = {speed_rpm, speed_rpm};
    exercise.hidden.speed_rpm = {rounded(speed_rpm * 0.7, 10), rounded(speed_rpm * 1.4, 10)};
    exercise.hidden.start_speed_rpm = speed_rpm;
    exercise.hidden.start_depth_mm = exercise.depth_mm;
}

/// Pockets j and j - 1 lie within the range; the depth halfway between the least limit and the best robust one.
bool drawSafeSpeed(Draw& draw, Exercise& exercise)
{
    Scenario& machine = exercise.hidden;
    machine = machineOf(draw, {160, 300}, {2, 4});
    const double f = machine.modes.front().frequency_hz;
    const int j = static_cast<int>(std::ceil(60 * f / highestSpeed_rpm + 1.1)) + draw.whole(0, 1);
    // Avoids that the best speed always lies at the upper end.
    exercise.speed_rpm.from = rounded(60 * f / (j + draw.between(0.5, 0.9)), 10);
    exercise.speed_rpm.to = rounded(60 * f / (j - draw.between(1.1, 1.6)), 10);
    machine.speed_rpm = exercise.speed_rpm;
    const stability::LobeLimit limit = limitOver(machine, exercise.speed_rpm);
    const double least = *std::min_element(limit.depth_mm.begin(), limit.depth_mm.end());
    const double best = bestSpeed(limit, exercise.speed_rpm, 2 * speedShare).limit_mm;
    exercise.depth_mm = rounded(least + 0.5 * (best - least), 0.01);
    machine.start_speed_rpm = rounded(draw.between(exercise.speed_rpm.from, exercise.speed_rpm.to), 10);
    machine.start_depth_mm = exercise.depth_mm;
    return exercise.depth_mm > 1.12 * least && exercise.depth_mm < 0.9 * best;
}

/// A chattering cut near the minimum of lobe k, `share` times as deep as the limit.
bool drawChatter(Draw& draw, Exercise& exercise, const Interval& frequency_hz, const Interval& share)
{
    Scenario& machine = exercise.hidden;
    machine = machineOf(draw, frequency_hz, {2, 4});
    const double f = bottomFrequency(machine);
    const int first = std::max(2, static_cast<int>(std::ceil(60 * f / highestSpeed_rpm - 0.75)));
    const int k = first + draw.whole(0, 3);
    const double speed = rounded(60 * f / (k + 0.75 + draw.between(-0.1, 0.12)), 10);
    const double limit = limit_mm(machine, speed, stability::SpeedRelation::Exact);
    exercise.depth_mm = rounded(draw.between(share.from, share.to) * limit, 0.01);
    showOneSpeed(exercise, speed);
    return exercise.depth_mm > (1 + share.from) / 2 * limit && exercise.depth_mm < machine.greatest_depth_mm;
}

bool drawDamping(Draw& draw, Exercise& exercise)
{
    exercise.hidden = machineOf(draw, {80, 400}, {1, 6});
    exercise.hidden.speed_rpm = {1000, 4000};
    return true;
}

/// At the minimum of an exact lobe the published limit is high, and vice versa.
bool drawPrediction(Draw& draw, Exercise& exercise)
{
    Scenario& machine = exercise.hidden;
    machine = machineOf(draw, {160, 300}, {2, 4});
    const double f = bottomFrequency(machine);
    const int k = std::max(3, static_cast<int>(std::ceil(60 * f / highestSpeed_rpm))) + draw.whole(0, 1);
    const double waves = draw.whole(0, 1) == 0 ? k + draw.between(-0.04, 0.04) : k - 0.25 + draw.between(-0.06, 0.06);
    const double speed = rounded(60 * f / waves, 10);
    const double exact = limit_mm(machine, speed, stability::SpeedRelation::Exact);
    const double published = limit_mm(machine, speed, stability::SpeedRelation::Published);
    exercise.depth_mm = rounded(std::sqrt(exact * published), 0.01);
    showOneSpeed(exercise, speed);
    return std::max(exact, published) > 1.3 * std::min(exact, published) &&
           exercise.depth_mm > 1.08 * std::min(exact, published) &&
           exercise.depth_mm < 0.93 * std::max(exact, published) && exercise.depth_mm < machine.greatest_depth_mm;
}

/// True if the fraction of the wave count is clearly between 0 and 1.
bool isClearlyBetween(const Exercise& exercise)
{
    const double waves = growthOf(exercise.hidden, exercise.speed_rpm.from, exercise.depth_mm).frequency_hz * 60 /
                         exercise.speed_rpm.from;
    const double part = waves - std::floor(waves);
    return part > 0.55 && part < 0.95;
}

bool drawn(Draw& draw, Exercise& exercise)
{
    switch (exercise.kind) {
        case ExerciseKind::SafeSpeed: return drawSafeSpeed(draw, exercise);
        case ExerciseKind::LobeNumber:
            return drawChatter(draw, exercise, {160, 400}, {1.3, 1.6}) && isClearlyBetween(exercise);
        case ExerciseKind::Damping: return drawDamping(draw, exercise);
        case ExerciseKind::ChatterFrequency: return drawChatter(draw, exercise, {160, 600}, {1.2, 1.35});
        case ExerciseKind::Prediction: break;
    }
    return drawPrediction(draw, exercise);
}

}  // namespace

Exercise drawExercise(ExerciseKind kind, std::uint32_t seed)
{
    Exercise exercise;
    exercise.kind = kind;
    exercise.seed = seed;
    Draw draw(kind, seed);
    for (int i = 0; i < mostTries; ++i)
        if (drawn(draw, exercise)) break;
    return exercise;
}

stability::LobeLimit limitOver(const Scenario& scenario, const Interval& speed_rpm)
{
    stability::LobeParameters parameters = lobesOf(scenario, stability::SpeedRelation::Exact);
    parameters.speed_rpm = {{speed_rpm.from * (1 - 2 * speedShare), speed_rpm.to * (1 + 2 * speedShare)}};
    parameters.points = limitPoints;
    stability::LobeLimit limit = stability::limitOf(stability::frfOf(scenario.modes, 2 * speed_rpm.to), parameters);
    for (double& depth : limit.depth_mm)
        if (std::isnan(depth)) depth = HUGE_VAL;
    return limit;
}

BestSpeed bestSpeed(const stability::LobeLimit& limit, const Interval& speed_rpm, double share)
{
    BestSpeed best;
    for (const double speed : limit.speed_rpm) {
        if (speed < speed_rpm.from || speed > speed_rpm.to) continue;
        if (const double least = leastAbout(limit, speed, share); least > best.limit_mm) best = {speed, least};
    }
    return best;
}

}  // namespace lathelier::training
