// The hidden machines of the exercises: drawn by seed until the question is a fair one.
#pragma once

#include "engine/training/exercise.h"

namespace lathelier::training {

/// The exercise with its hidden machine, speeds and depth; without givens and texts.
Exercise drawExercise(ExerciseKind kind, std::uint32_t seed);

/// The limit over a range of speeds, exact.
stability::LobeLimit limitOver(const Scenario& scenario, const Interval& speed_rpm);

/// The speed whose worst limit within ±share is best.
struct BestSpeed {
    double speed_rpm = 0;  ///< of the spindle
    double limit_mm = 0;   ///< the worst about it
};
BestSpeed bestSpeed(const stability::LobeLimit& limit, const Interval& speed_rpm, double share);

/// Within which speeds have their neighbours to be stable for a speed to be a good one.
inline constexpr double speedShare = 0.01;

}  // namespace lathelier::training
