// The hidden machines of the exercises: random by seed, redrawn until the question is well posed.
#pragma once

#include "engine/training/exercise.h"

namespace lathelier::training {

/// The exercise with its hidden machine, speeds and depth; without givens and texts.
Exercise drawExercise(ExerciseKind kind, std::uint32_t seed);

/// The limit over a range of speeds, exact.
stability::LobeLimit limitOver(const Scenario& scenario, const Interval& speed_rpm);

/// The speed that maximises the minimum limit within ±share.
struct BestSpeed {
    double speed_rpm = 0;
    double limit_mm = 0;  ///< minimum limit within ±share
};
BestSpeed bestSpeed(const stability::LobeLimit& limit, const Interval& speed_rpm, double share);

/// Relative speed interval that must be stable around a good speed.
inline constexpr double speedShare = 0.01;

}  // namespace lathelier::training
