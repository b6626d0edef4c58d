// Words and quantities available in the conditions of a lesson.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "engine/training/lesson_state.h"

namespace lathelier::training {

/// The quantity of LessonState of this key, or nullptr.
const QuantityOf<LessonState>* findQuantity(std::string_view key);

/// The possible words of a quantity; empty for a number.
std::vector<std::string> wordsOf(std::string_view quantity);

/// "<", "<=", ">", ">=", "=", "!=", in the order of Comparison.
const std::vector<std::string>& comparisonSigns();

}  // namespace lathelier::training
