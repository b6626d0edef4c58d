// Lists of numbers in the values of an item of the project.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "engine/core/value.h"

namespace lathelier {

/// A project file holds lists of at most so many numbers.
inline constexpr std::size_t mostItemNumbers = 10000;

/// The list under `name`, all of it finite; nothing when there is none. Whole numbers count as numbers.
std::optional<std::vector<double>> numbersIn(const Values& values, std::string_view name);

/// Error linesTooMany (`lines`, `maximum`) for more lines than a project file holds.
void requireKeepable(std::size_t lines);

}  // namespace lathelier
