#include "engine/training/exercise.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/core/core_codes.h"
#include "engine/core/units.h"
#include "engine/training/exercise_draw.h"

namespace lathelier::training {
namespace {

constexpr double cut_s = 3;
constexpr double leastDepth_mm = 1e-3;
constexpr double shownDecayShare = 0.02;  ///< share of the first amplitude down to which a decay is shown
constexpr int safeSpeedCuts = 3;
constexpr double dampingShare = 0.1;     ///< tolerance, of the damping ratio
constexpr double frequencyShare = 0.03;  ///< tolerance, of the frequency

NamedNumber speedGiven(const Exercise& exercise)
{
    return {"speed_rpm", LT_TEXT("Engine", "Spindle speed"), exercise.speed_rpm.from, unit::rpm, 0};
}

NamedNumber depthGiven(const Exercise& exercise)
{
    return {"depth_mm", LT_TEXT("Engine", "Depth of cut"), exercise.depth_mm, unit::mm, 2};
}

void describeSafeSpeed(Exercise& exercise)
{
    exercise.givens = {
        depthGiven(exercise),
        {"from_rpm", LT_TEXT("Engine", "Lowest speed"), exercise.speed_rpm.from, unit::rpm, 0},
        {"to_rpm", LT_TEXT("Engine", "Highest speed"), exercise.speed_rpm.to, unit::rpm, 0},
        {"cuts", LT_TEXT("Engine", "Cuts that may be listened to"), static_cast<double>(safeSpeedCuts), {}, 0}};
    exercise.cuts = safeSpeedCuts;
    exercise.answer = LT_TEXT("Engine", "Spindle speed");
    exercise.unit = unit::rpm;
}

void describeLobeNumber(Exercise& exercise)
{
    exercise.givens = {speedGiven(exercise), depthGiven(exercise)};
    exercise.cuts = 1;
    exercise.answer = LT_TEXT("Engine", "Whole waves k");
}

void describeDamping(Exercise& exercise)
{
    exercise.answer = LT_TEXT("Engine", "Damping ratio ζ");
    exercise.unit = unit::percent;
    exercise.decimals = 1;
    exercise.tolerance = dampingShare * 100 * exercise.hidden.modes.front().damping_ratio;
}

void describeChatterFrequency(Exercise& exercise)
{
    exercise.givens = {speedGiven(exercise), depthGiven(exercise)};
    exercise.cuts = 1;
    exercise.answer = LT_TEXT("Engine", "Frequency of the chatter");
    exercise.unit = unit::hz;
    exercise.tolerance =
        frequencyShare * growthOf(exercise.hidden, exercise.speed_rpm.from, exercise.depth_mm).frequency_hz;
}

void describePrediction(Exercise& exercise)
{
    const stability::Mode& mode = exercise.hidden.modes.front();
    const double least = 2 * mode.stiffness_N_mm * mode.damping_ratio * (1 + mode.damping_ratio) /
                         exercise.hidden.cutting_coefficient_N_mm2;
    exercise.givens = {speedGiven(exercise),
                       depthGiven(exercise),
                       {"bottom_hz", LT_TEXT("Engine", "Frequency of the chatter at the least limit"),
                        mode.frequency_hz * std::sqrt(1 + 2 * mode.damping_ratio), unit::hz, 1},
                       {"least_mm", LT_TEXT("Engine", "Limit at every speed"), least, unit::mm, 2}};
    exercise.answer = LT_TEXT("Engine", "The cut is");
    exercise.choices = {LT_TEXT("Engine", "stable"), LT_TEXT("Engine", "chatter")};
}

void refuseOutside(const char* parameter, double found, const Interval& range)
{
    if (found >= range.from && found <= range.to) return;
    throw Error(errors::valueOutOfRange, {{"parameter", parameter},
                                          {"found", found},
                                          {"expected", LT_TEXT("Engine", "a number")},
                                          {"minimum", range.from},
                                          {"maximum", range.to}});
}

}  // namespace

const std::vector<FieldChoice>& exerciseChoices()
{
    static const std::vector<FieldChoice> all{{"safe_speed", LT_TEXT("Engine", "A safe speed")},
                                              {"lobe_number", LT_TEXT("Engine", "Counting waves")},
                                              {"damping", LT_TEXT("Engine", "Damping from a decay")},
                                              {"chatter_frequency", LT_TEXT("Engine", "Frequency of the chatter")},
                                              {"prediction", LT_TEXT("Engine", "Stable or chatter?")}};
    return all;
}

Exercise makeExercise(ExerciseKind kind, std::uint32_t seed)
{
    Exercise exercise = drawExercise(kind, seed);
    switch (kind) {
        case ExerciseKind::SafeSpeed: describeSafeSpeed(exercise); break;
        case ExerciseKind::LobeNumber: describeLobeNumber(exercise); break;
        case ExerciseKind::Damping: describeDamping(exercise); break;
        case ExerciseKind::ChatterFrequency: describeChatterFrequency(exercise); break;
        case ExerciseKind::Prediction: describePrediction(exercise); break;
    }
    return exercise;
}

Text questionOf(ExerciseKind kind)
{
    switch (kind) {
        case ExerciseKind::SafeSpeed:
            return LT_TEXT("Engine",
                           "The cut is to be {depth_mm:2} mm deep. Find a spindle speed between {from_rpm:0} and "
                           "{to_rpm:0} 1/min at which it does not chatter. You may listen to {cuts:0} cuts first.");
        case ExerciseKind::LobeNumber:
            return LT_TEXT(
                "Engine",
                "This cut at {speed_rpm:0} 1/min chatters. Count the waves on the surface over one revolution: "
                "how many whole waves are there?");
        case ExerciseKind::Damping:
            return LT_TEXT("Engine",
                           "The tool was hit once with a hammer and rings out. Read two amplitudes some periods apart: "
                           "how large is the damping ratio in per cent?");
        case ExerciseKind::ChatterFrequency:
            return LT_TEXT(
                "Engine",
                "Listen to this cut at {speed_rpm:0} 1/min and look at its waveform: how many times a second "
                "does the tool swing?");
        case ExerciseKind::Prediction: break;
    }
    return LT_TEXT("Engine",
                   "Every cut of less than {least_mm:2} mm is stable; at the least limit the chatter has "
                   "{bottom_hz:1} Hz. Predict: is a cut of {depth_mm:2} mm at {speed_rpm:0} 1/min stable, or does it "
                   "chatter? The exact relation and the shortcut of the papers disagree here.");
}

Text explanationOf(ExerciseKind kind)
{
    switch (kind) {
        case ExerciseKind::SafeSpeed:
            return LT_TEXT(
                "Engine",
                "At {speed_rpm:0} 1/min the limit is {limit_mm:2} mm, {depth_mm:2} mm were to be cut. The best "
                "speed is {best_rpm:0} 1/min with at least {best_mm:2} mm even if the speed is 1 % off: there "
                "60 f/N with the natural frequency f = {natural_hz:0} Hz is {best_waves:2}, close to a whole "
                "number, and the wave is met almost in step.");
        case ExerciseKind::LobeNumber:
            return LT_TEXT(
                "Engine",
                "60 f/N = 60 · {frequency_hz:1} Hz / {speed_rpm:0} 1/min = {waves:2} waves: {k:0} whole waves "
                "and a phase ε of {phase_deg:0}°.");
        case ExerciseKind::Damping:
            return LT_TEXT("Engine",
                           "Over {periods:0} periods the amplitude falls from {first_mm:4} mm to {last_mm:4} mm: "
                           "δ = ln({first_mm:4}/{last_mm:4})/{periods:0} = {decrement:3}, and "
                           "ζ = δ/√(4π² + δ²) = {damping_percent:2} %.");
        case ExerciseKind::ChatterFrequency:
            return LT_TEXT("Engine",
                           "Ten swings last {ten_ms:1} ms: f = {frequency_hz:1} Hz. The natural frequency is "
                           "{natural_hz:1} Hz; chatter lies a little above it.");
        case ExerciseKind::Prediction: break;
    }
    return LT_TEXT("Engine",
                   "60 f/N = {waves:2} waves. The exact limit at this speed is {limit_mm:2} mm, that of the shortcut "
                   "N = 60 f/k {published_mm:2} mm, the depth {depth_mm:2} mm. The simulation decides: from revolution "
                   "to revolution the vibration changes by the factor {growth:3}.");
}

Values valuesOf(const std::vector<NamedNumber>& numbers)
{
    Values values;
    values.reserve(numbers.size());
    for (const NamedNumber& number : numbers) values.emplace_back(number.key, number.value);
    return values;
}

stability::SimulationResult listen(const Exercise& exercise, double speed_rpm, double depth_mm,
                                   const Progress& progress)
{
    refuseOutside("speed_rpm", speed_rpm, exercise.speed_rpm);
    refuseOutside("depth_mm", depth_mm, {leastDepth_mm, exercise.hidden.greatest_depth_mm});
    return stability::simulate(exercise.hidden.modes, cutOf(exercise.hidden, speed_rpm, depth_mm, cut_s), progress);
}

Decay listenToBlow(const Exercise& exercise)
{
    double slowest = HUGE_VAL;
    for (const stability::Mode& mode : exercise.hidden.modes)
        slowest = std::min(slowest, 2 * std::numbers::pi * mode.frequency_hz * mode.damping_ratio);
    return ringDown(exercise.hidden.modes, -std::log(shownDecayShare) / slowest);
}

}  // namespace lathelier::training
