#include "engine/io/text/quantity.h"

#include "engine/core/units.h"
#include "engine/io/text/text_lines.h"
#include "engine/io/text/units.h"

namespace lathelier::io {
namespace {

using Kind = QuantityUnit::Kind;

struct QuantityWord {
    std::string_view word;  ///< ASCII letters in lower case
    Kind kind;
    std::string_view key;
    double scale;
};

constexpr QuantityWord quantityWords[] = {
    {"deg", Kind::Angle, "deg", 1},
    {"degree", Kind::Angle, "deg", 1},
    {"degrees", Kind::Angle, "deg", 1},
    {"°", Kind::Angle, "deg", 1},
    {"stopnie", Kind::Angle, "deg", 1},
    {"stopni", Kind::Angle, "deg", 1},
    {"град", Kind::Angle, "deg", 1},
    {"rad", Kind::Angle, "rad", deg_per_rad},
    {"radian", Kind::Angle, "rad", deg_per_rad},
    {"radians", Kind::Angle, "rad", deg_per_rad},
    {"рад", Kind::Angle, "rad", deg_per_rad},
    {"mrad", Kind::Angle, "mrad", deg_per_rad * 1e-3},
    {"s", Kind::Time, "s", 1},
    {"sec", Kind::Time, "s", 1},
    {"second", Kind::Time, "s", 1},
    {"seconds", Kind::Time, "s", 1},
    {"с", Kind::Time, "s", 1},
    {"ms", Kind::Time, "ms", 1e-3},
    {"msec", Kind::Time, "ms", 1e-3},
    {"мс", Kind::Time, "ms", 1e-3},
    {"us", Kind::Time, "us", 1e-6},
    {"µs", Kind::Time, "us", 1e-6},
    {"μs", Kind::Time, "us", 1e-6},
    {"v", Kind::Voltage, "V", 1},
    {"volt", Kind::Voltage, "V", 1},
    {"volts", Kind::Voltage, "V", 1},
    {"в", Kind::Voltage, "V", 1},
    {"В", Kind::Voltage, "V", 1},
    {"mv", Kind::Voltage, "mV", 1e-3},
    {"мв", Kind::Voltage, "mV", 1e-3},
    {"мВ", Kind::Voltage, "mV", 1e-3},
};

}  // namespace

std::optional<QuantityUnit> quantityUnit(std::string_view word)
{
    if (const auto length = lengthUnit(word)) return QuantityUnit{Kind::Length, length->key, length->mm};
    word = trimmed(word);
    if (word.size() > 2 && std::string_view("([{<").find(word.front()) != std::string_view::npos &&
        std::string_view(")]}>").find(word.back()) != std::string_view::npos)
        word = trimmed(word.substr(1, word.size() - 2));
    const std::string lower = lowerCase(word);
    for (const QuantityWord& known : quantityWords)
        if (lower == known.word) return QuantityUnit{known.kind, std::string(known.key), known.scale};
    return std::nullopt;
}

QuantityHeading parseQuantityHeading(std::string_view cell)
{
    cell = trimmed(cell);
    const std::size_t open = cell.find_first_of("([{<");
    if (open != std::string_view::npos && open > 0) {
        const std::size_t close = cell.find_first_of(")]}>", open);
        const std::string_view inside =
            cell.substr(open + 1, close == std::string_view::npos ? close : close - open - 1);
        return {std::string(trimmed(cell.substr(0, open))), quantityUnit(inside)};
    }
    const std::size_t mark = cell.find_last_of("_/ ,-.:");
    if (mark != std::string_view::npos && mark > 0)
        if (auto unit = quantityUnit(cell.substr(mark + 1))) {
            std::string_view name = trimmed(cell.substr(0, mark));
            if (lowerCase(name).ends_with(" in")) name.remove_suffix(3);
            return {std::string(trimmed(name)), std::move(unit)};
        }
    return {std::string(cell), std::nullopt};
}

}  // namespace lathelier::io
