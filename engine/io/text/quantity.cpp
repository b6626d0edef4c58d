#include "engine/io/text/quantity.h"

#include "engine/core/units.h"
#include "engine/io/text/text_lines.h"
#include "engine/io/text/units.h"

namespace lathelier::io {
namespace {

using Kind = QuantityUnit::Kind;

constexpr double degPerGon = 0.9;
constexpr double degPerTurn = 360;

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
    {"stopień", Kind::Angle, "deg", 1},
    {"gradi", Kind::Angle, "deg", 1},
    {"grados", Kind::Angle, "deg", 1},
    {"град", Kind::Angle, "deg", 1},
    {"градусы", Kind::Angle, "deg", 1},
    {"rad", Kind::Angle, "rad", deg_per_rad},
    {"radian", Kind::Angle, "rad", deg_per_rad},
    {"radians", Kind::Angle, "rad", deg_per_rad},
    {"рад", Kind::Angle, "rad", deg_per_rad},
    {"mrad", Kind::Angle, "mrad", deg_per_rad * 1e-3},
    {"milliradian", Kind::Angle, "mrad", deg_per_rad * 1e-3},
    {"milliradians", Kind::Angle, "mrad", deg_per_rad * 1e-3},
    {"мрад", Kind::Angle, "mrad", deg_per_rad * 1e-3},
    {"urad", Kind::Angle, "urad", deg_per_rad * 1e-6},
    {"µrad", Kind::Angle, "urad", deg_per_rad * 1e-6},
    {"μrad", Kind::Angle, "urad", deg_per_rad * 1e-6},
    {"gon", Kind::Angle, "gon", degPerGon},
    {"gons", Kind::Angle, "gon", degPerGon},
    {"gradian", Kind::Angle, "gon", degPerGon},
    {"gradians", Kind::Angle, "gon", degPerGon},
    {"neugrad", Kind::Angle, "gon", degPerGon},
    {"гон", Kind::Angle, "gon", degPerGon},
    {"mgon", Kind::Angle, "mgon", degPerGon * 1e-3},
    {"rev", Kind::Angle, "rev", degPerTurn},
    {"revs", Kind::Angle, "rev", degPerTurn},
    {"revolution", Kind::Angle, "rev", degPerTurn},
    {"revolutions", Kind::Angle, "rev", degPerTurn},
    {"turn", Kind::Angle, "rev", degPerTurn},
    {"turns", Kind::Angle, "rev", degPerTurn},
    {"cycle", Kind::Angle, "rev", degPerTurn},
    {"cycles", Kind::Angle, "rev", degPerTurn},
    {"umdrehung", Kind::Angle, "rev", degPerTurn},
    {"umdrehungen", Kind::Angle, "rev", degPerTurn},
    {"obr", Kind::Angle, "rev", degPerTurn},
    {"obrót", Kind::Angle, "rev", degPerTurn},
    {"obroty", Kind::Angle, "rev", degPerTurn},
    {"giri", Kind::Angle, "rev", degPerTurn},
    {"об", Kind::Angle, "rev", degPerTurn},
    {"mdeg", Kind::Angle, "mdeg", 1e-3},
    {"arcmin", Kind::Angle, "arcmin", 1.0 / 60},
    {"arcmins", Kind::Angle, "arcmin", 1.0 / 60},
    {"arcminute", Kind::Angle, "arcmin", 1.0 / 60},
    {"arcminutes", Kind::Angle, "arcmin", 1.0 / 60},
    {"bogenminuten", Kind::Angle, "arcmin", 1.0 / 60},
    {"′", Kind::Angle, "arcmin", 1.0 / 60},
    {"arcsec", Kind::Angle, "arcsec", 1.0 / 3600},
    {"arcsecs", Kind::Angle, "arcsec", 1.0 / 3600},
    {"arcsecond", Kind::Angle, "arcsec", 1.0 / 3600},
    {"arcseconds", Kind::Angle, "arcsec", 1.0 / 3600},
    {"bogensekunden", Kind::Angle, "arcsec", 1.0 / 3600},
    {"″", Kind::Angle, "arcsec", 1.0 / 3600},
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

/// "angle", "spindle angle", "Winkel", "position": what may be counted in revolutions.
bool endsWithAngle(std::string_view name)
{
    const std::string lower = lowerCase(trimmed(name));
    for (const std::string_view word : {"angle", "theta", "phi", "fi", "azimuth", "rotation", "position", "winkel",
                                        "kąt", "kat", "angolo", "угол", "θ", "φ", "encoder"})
        if (lower.ends_with(word)) return true;
    return false;
}

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
        auto unit = quantityUnit(inside);
        return {std::string(trimmed(cell.substr(0, open))), std::move(unit), std::string(trimmed(inside))};
    }
    const std::size_t mark = cell.find_last_of("_/ ,-.:");
    if (mark != std::string_view::npos && mark > 0)
        if (auto unit = quantityUnit(cell.substr(mark + 1))) {
            std::string_view name = trimmed(cell.substr(0, mark));
            if (lowerCase(name).ends_with(" in")) name.remove_suffix(3);
            // "marker_1/rev" is a pulse a revolution, "angle_rev" an angle.
            if (unit->key == "rev" && !endsWithAngle(name)) return {std::string(cell), std::nullopt, {}};
            return {std::string(trimmed(name)), std::move(unit), std::string(trimmed(cell.substr(mark + 1)))};
        }
    return {std::string(cell), std::nullopt, {}};
}

}  // namespace lathelier::io
