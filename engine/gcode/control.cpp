#include "engine/gcode/control.h"

#include <algorithm>

#include "engine/gcode/flow_text.h"

namespace lathelier::gcode {
namespace {

template <class Table, class Key>
auto meaningIn(const Table& table, const Key& key)
{
    const auto found = table.find(key);
    return found == table.end() ? typename Table::mapped_type{} : found->second;
}

}  // namespace

G meaningOfG(const Control& control, int code10)
{
    return meaningIn(control.g, code10);
}

M meaningOfM(const Control& control, int number)
{
    return meaningIn(control.m, number);
}

Letter meaningOfLetter(const Control& control, char letter)
{
    return meaningIn(control.letters, letter);
}

Name meaningOfName(const Control& control, std::string_view name)
{
    return meaningIn(control.names, capitals(name.substr(0, name.find_first_of("=([: \t"))));
}

bool hasWord(const Control& control, G meaning)
{
    return std::any_of(control.g.begin(), control.g.end(), [&](const auto& word) { return word.second == meaning; });
}

}  // namespace lathelier::gcode
