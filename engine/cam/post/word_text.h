// Numbers of a program's words, in whole units of their last decimal, and the templates that they fill.
#pragma once

#include <cstdint>
#include <functional>
#include <string>

namespace lathelier::cam {

/// A value in units of the last of `decimals` places.
std::int64_t unitsOf(double value, int decimals);
/// Units as text, without zeros at the end; `point`: whole numbers end with a point.
std::string numberText(std::int64_t units, int decimals, bool point);
/// A word: its letter and its number.
std::string wordText(const char* letter, std::int64_t units, int decimals, bool point);
/// The pattern with the value in the place of each name in braces.
std::string filledTemplate(const std::string& pattern, const std::function<std::string(const std::string&)>& value_of);

}  // namespace lathelier::cam
