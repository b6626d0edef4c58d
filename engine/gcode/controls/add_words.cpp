#include "engine/gcode/controls/add_words.h"

#include <cmath>
#include <stdexcept>

namespace lathelier::gcode {
namespace {

template <class Table, class Key>
void addWord(Table& table, const Key& key, typename Table::mapped_type meaning)
{
    if (!table.emplace(key, meaning).second) throw std::logic_error("a word of a control has two meanings");
}

}  // namespace

std::vector<std::string> numbered(const std::string& before, std::size_t most, const std::string& behind)
{
    std::vector<std::string> patterns;
    for (std::size_t digits = 1; digits <= most; ++digits)
        patterns.push_back(std::string(before).append(digits, '?').append(behind));
    return patterns;
}

void addWords(std::map<int, G>& table, G meaning, std::initializer_list<double> numbers)
{
    for (const double number : numbers) addWord(table, static_cast<int>(std::lround(number * 10)), meaning);
}

void addWords(std::map<int, M>& table, M meaning, std::initializer_list<int> numbers)
{
    for (const int number : numbers) addWord(table, number, meaning);
}

void addWords(std::map<int, M>& table, M meaning, int first, int last)
{
    for (int number = first; number <= last; ++number) table.emplace(number, meaning);
}

void addWords(std::map<char, Letter>& table, Letter meaning, std::string_view letters)
{
    for (const char letter : letters) addWord(table, letter, meaning);
}

void addWords(std::map<std::string, Name, std::less<>>& table, Name meaning, std::initializer_list<const char*> names)
{
    for (const char* name : names) addWord(table, name, meaning);
}

}  // namespace lathelier::gcode
