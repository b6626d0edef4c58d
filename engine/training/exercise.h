// Exercises with hidden parameters, repeatable by seed: the same kind and seed give the same exercise, bit by bit for
// any number of threads.
//
//   SafeSpeed         a depth is given; three cuts may be listened to; find a speed at which it is stable
//   LobeNumber        count the waves of a revolution on the surface that a chattering cut leaves: k whole waves
//   Damping           ζ from the decay after a blow, by the logarithmic decrement
//   ChatterFrequency  the frequency of a chattering cut from its sound and waveform
//   Prediction        stable or chatter at a point where the exact relation and the papers' N = 60 f/k disagree
//
// Grading is physics: the limit is that of 1 + K_r a G(iω) (1 - e^{-iωT}) = 0 with its phase (stability/lobes.h), the
// frequency that of the simulated cut, ζ that of the hidden mode.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "engine/core/fields.h"
#include "engine/core/progress.h"
#include "engine/stability/simulation/simulation.h"
#include "engine/training/decay.h"
#include "engine/training/scenario.h"

namespace lathelier::training {

enum class ExerciseKind { SafeSpeed, LobeNumber, Damping, ChatterFrequency, Prediction };

/// Key and name of every kind, in the order of the enumerators.
const std::vector<FieldChoice>& exerciseChoices();

/// A number that an exercise states, or that explains its answer.
struct NamedNumber {
    std::string key;  ///< with its unit: "speed_rpm"; the placeholder in the question or explanation
    Text label;
    double value = 0;  ///< in `unit`
    Text unit;         ///< empty: none
    int decimals = 0;
};

struct Exercise {
    ExerciseKind kind = ExerciseKind::SafeSpeed;
    std::uint32_t seed = 0;
    Scenario hidden;                  ///< the hidden machine, not shown before the answer
    Interval speed_rpm;               ///< allowed speeds of simulated cuts; one speed: from = to
    double depth_mm = 0;              ///< of the question; 0: no cut involved
    std::vector<NamedNumber> givens;  ///< numbers shown to the pupil
    int cuts = 0;                     ///< number of cuts the pupil may play
    Text answer;                      ///< quantity asked for: "Spindle speed"
    Text unit;                        ///< of the answer; empty: none
    int decimals = 0;
    double tolerance = 0;       ///< half width of the accepted interval, in the unit of the answer
    std::vector<Text> choices;  ///< the answer is an index into them; empty: it is a number
};

/// A few milliseconds.
Exercise makeExercise(ExerciseKind kind, std::uint32_t seed);

/// The question, with {keys} of the givens: fill(text(question), valuesOf(givens)).
Text questionOf(ExerciseKind kind);
Values valuesOf(const std::vector<NamedNumber>& numbers);

/// Simulates a cut on the hidden machine for three seconds. Error valueOutOfRange for a speed outside
/// exercise.speed_rpm or a depth outside 0.001 mm to hidden.greatest_depth_mm. Throws Cancelled.
stability::SimulationResult listen(const Exercise& exercise, double speed_rpm, double depth_mm,
                                   const Progress& progress = {});

/// Impulse response of the hidden machine for Damping, until its amplitude has decayed.
Decay listenToBlow(const Exercise& exercise);

struct Grade {
    double points = 0;                 ///< 0 to 10; full points within the tolerance, partial points close to it
    bool correct = false;              ///< within the tolerance
    std::vector<Interval> expected;    ///< accepted answers, ascending; in the unit of the answer
    std::vector<NamedNumber> numbers;  ///< numbers that explain the answer, including hidden ones
};

/// Answers that are not finite get no points.
Grade grade(const Exercise& exercise, double answer, const Progress& progress = {});

/// Derivation of the answer, with {keys} of Grade::numbers.
Text explanationOf(ExerciseKind kind);

}  // namespace lathelier::training
