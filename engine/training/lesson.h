// A lesson: a guided tour as Markdown text, also written by schools. Format: resources/training/README.md; built-in
// tours: resources/training/<language>/tour.md.
//
//   # Title                                    the first heading; the text below it introduces the lesson
//   ## Heading of a step                       then its text, any Markdown
//       N = 60 f / (k + ε/2π)                  four blanks in front: a formula
//   set: scenario = slender, speed_rpm = 2800, depth_mm = 0.2
//   show: waves, lobes                         the first one is in front
//   task: What the pupil is to do.
//   hint: What helps when it does not work out.
//   check: growth > 1                          all checks of a step have to be met
//
// A line that begins with a lower-case word and a colon is a directive; unknown directives are errors, so that typing
// errors do not drop a check. Numbers have a decimal point in every language, keys are English in every language.
//
// check: QUANTITY COMPARISON VALUE, where QUANTITY is a key of LessonState, COMPARISON one of < <= > >= = !=, VALUE a
// number, another quantity or a multiple of one ("1.5 * minimum_depth_mm"), or for scenario, verdict (stable, chatter,
// undecided), relation (exact, published) and view a word.
// set: scenario (own: the shop's machine, where there is one), speed_rpm, depth_mm, relation, and exercise with seed
// (exercise.h).
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/training/exercise.h"
#include "engine/training/lesson_state.h"

namespace lathelier::training {

enum class Comparison { Less, AtMost, Greater, AtLeast, Equal, Different };

/// A condition of a task.
struct Check {
    std::string quantity;                         ///< key of LessonState's quantities
    Comparison comparison = Comparison::Greater;  ///< only Equal and Different for words
    std::string word = {};                        ///< that a word is compared with
    double number = 1;                            ///< that a number is compared with, or the factor of `other`
    std::string other = {};                       ///< quantity that a number is compared with; empty: none
    friend bool operator==(const Check&, const Check&) = default;
};

/// State set at the start of a step; absent values are unchanged.
struct Setting {
    std::string scenario = {};                              ///< key; empty: as it is
    std::optional<double> speed_rpm = {};                   ///< operating point
    std::optional<double> depth_mm = {};                    ///< operating point
    std::optional<stability::SpeedRelation> relation = {};  ///< of the displayed lobes
    std::optional<ExerciseKind> exercise = {};
    std::optional<std::uint32_t> seed = {};  ///< seed of the exercise; none: random
    friend bool operator==(const Setting&, const Setting&) = default;
};

struct Step {
    std::string heading;        ///< plain text
    std::string body;           ///< Markdown; fill(body, describedValues(state), language) replaces {keys} by numbers
    std::string task;           ///< plain text; empty: the step is read only
    std::string hint;           ///< plain text; empty: none
    Setting set;                ///< applied at the start of the step
    std::vector<View> show;     ///< views opened at its start, the first in front; empty: unchanged
    std::vector<Check> checks;  ///< all have to be met; empty: the step needs no action
};

struct Lesson {
    std::string title;         ///< plain text
    std::string introduction;  ///< Markdown
    std::vector<Step> steps;   ///< at least one
};

inline constexpr std::size_t largestLesson_bytes = 1 << 20;
inline constexpr std::size_t mostSteps = 200;
inline constexpr std::size_t mostChecks = 20;  ///< largest number per step

/// Reads a lesson (UTF-8, or any encoding of io::decodeText). `name` of the file is the `path` of its errors:
/// fileEmpty, formatUnknown, and with `line` and `column` malformed (no title, text before it, no step, unknown
/// directive, key, view or word, a directive outside a step, duplicates, a check without a task, too large) and
/// keyOutOfRange.
Lesson readLesson(std::string_view bytes, const std::string& name);

/// True if the condition is met; never for unknown numbers. Numbers are equal if they are so with the displayed
/// decimals.
bool isMet(const Check& check, const LessonState& state);

/// True if all checks of the step are met.
bool isDone(const Step& step, const LessonState& state);

/// The check as it is written, without "check: ".
std::string written(const Check& check);

}  // namespace lathelier::training
