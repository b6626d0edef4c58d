// Questions for a class: a synthetic picture whose vibration frequency is to be determined with ruler and formula,
//     f_c = n (m + ν), |ν| = f / (period along the axis), m = πD / (pitch round the part).
#pragma once

#include "engine/surface/synthetic.h"

namespace lathelier::surface {

/// The picture of question `number`: feed, diameter, speed, waves and light from one side, all drawn from the number.
/// The vibration can be determined from it: 4 to 14 waves in a revolution, |ν| between 0.1 and 0.4, feed to the right,
/// cut downward. Size and scale as they are in `frame`.
SyntheticParameters quizPicture(int number, const SyntheticParameters& frame = {});

/// Classification of an answer.
enum class QuizVerdict {
    Right,       ///< within a tenth of n
    OtherSign,   ///< n (m - ν): wrong sign of ν
    OtherWaves,  ///< f_c + k n: m is wrong by k
    Multiple,    ///< twice, three times, a half or a third of f_c
    Wrong        ///< none of these
};

struct QuizAnswer {
    QuizVerdict verdict = QuizVerdict::Wrong;
    int waves = 0;  ///< OtherWaves: k
};

/// The answer `frequency_hz` against the vibration of the picture. Tolerance: a tenth of n = N/60, achievable with a
/// ruler.
QuizAnswer checkedAnswer(double frequency_hz, const SyntheticParameters& picture);

}  // namespace lathelier::surface
