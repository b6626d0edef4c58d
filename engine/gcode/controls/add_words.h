// Making the tables of a control.
#pragma once

#include <initializer_list>

#include "engine/gcode/control.h"

namespace lathelier::gcode {

/// Patterns of TextSign: `before`, 1 to `most` digits, `behind`.
std::vector<std::string> numbered(const std::string& before, std::size_t most, const std::string& behind = {});

/// Adds words to a table. Throws std::logic_error for one that is in the table already: a description that states two
/// meanings is wrong, and one that changes what it was copied from does so by erasing or assigning.
void addWords(std::map<int, G>& table, G meaning, std::initializer_list<double> numbers);
void addWords(std::map<int, M>& table, M meaning, std::initializer_list<int> numbers);
void addWords(std::map<int, M>& table, M meaning, int first, int last);  ///< leaves words that are there as they are
void addWords(std::map<char, Letter>& table, Letter meaning, std::string_view letters);
void addWords(std::map<std::string, Name, std::less<>>& table, Name meaning, std::initializer_list<const char*> names);

}  // namespace lathelier::gcode
