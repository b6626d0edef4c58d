#include "engine/io/profile/profile_columns.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "engine/io/io_codes.h"
#include "engine/io/probe/probe_columns.h"
#include "engine/io/table/column_names.h"
#include "engine/io/text/quantity.h"
#include "engine/io/text/text_lines.h"

namespace lathelier::io {
namespace {

using Shape = ProfileColumnChoice::Shape;

enum class ProfileRole { Unknown, X, Y, Z, Angle, Radius, Deviation, Other };

ProfileRole profileRoleOf(const std::string& core)
{
    if (isOneOf(core, {"x", "px", "posx", "positionx", "xpos", "xcoordinate", "xkoordinate"})) return ProfileRole::X;
    if (isOneOf(core, {"y", "py", "posy", "positiony", "ypos", "ycoordinate", "ykoordinate"})) return ProfileRole::Y;
    if (isOneOf(core, {"z", "pz", "posz", "positionz", "zpos", "zcoordinate", "height"})) return ProfileRole::Z;
    if (isOneOf(core, {"angle", "theta", "phi", "fi", "azimuth", "winkel", "kąt", "kat", "angolo", "угол", "θ", "φ",
                       "angular"}))
        return ProfileRole::Angle;
    // A distance or a reading may be a radius or a deviation, which its values decide.
    if (isOneOf(core, {"r", "radius", "rho", "promień", "promien", "raggio", "радиус", "ρ", "distance", "dist",
                       "abstand", "reading", "readings", "messwert", "odczyt", "odległość"}))
        return ProfileRole::Radius;
    if (isOneOf(core, {"deviation", "deviations", "dev", "dr", "deltar", "δr", "abweichung", "odchyłka", "odchylka",
                       "scostamento", "error", "form", "roundness", "displacement", "trace"}))
        return ProfileRole::Deviation;
    if (isIndexName(core) || isOneOf(core, {"label", "quality", "weight", "t", "time", "section", "used"}))
        return ProfileRole::Other;
    return ProfileRole::Unknown;
}

/// The name of a heading, and the same without a number at its end: "angle2" is a further "angle".
struct Core {
    std::string name;
    std::string stem;
};

Core coreOf(const std::string& heading)
{
    const std::string name = plainName(parseQuantityHeading(heading).name);
    return {name, name.substr(0, name.find_last_not_of("0123456789") + 1)};
}

[[noreturn]] void throwProfileColumns(const TableLayout& layout, Text expected)
{
    throw Error(errors::columnsUnknown, {{"line", layout.body_line},
                                         {"column", std::int64_t{1}},
                                         {"found", columnNames(layout)},
                                         {"expected", expected}});
}

/// Columns by the roles of their names.
class NamedColumns {
public:
    explicit NamedColumns(const TableLayout& layout) : layout_(layout)
    {
        for (std::size_t k = 0; k < layout.columns.size(); ++k) {
            if (!layout.columns[k].is_number) continue;
            const Core core = coreOf(layout.columns[k].heading);
            const ProfileRole role = profileRoleOf(core.name);
            const ProfileRole further = profileRoleOf(core.stem);
            if (role == ProfileRole::Unknown && !core.stem.empty() && further != ProfileRole::Unknown)
                numbered_[static_cast<std::size_t>(further)].push_back(k);
            else
                exact_[static_cast<std::size_t>(role)].push_back(k);
        }
        std::vector<std::size_t>& free = exact_[static_cast<std::size_t>(ProfileRole::Unknown)];
        // A row number before values with decimal marks.
        if (free.size() > 1 && layout.columns[free[0]].is_count && layout.columns[free[0]].name.empty() &&
            layout.columns[free[1]].has_decimal_marks)
            free.erase(free.begin());
    }

    bool has(ProfileRole role) const { return !exact_[at(role)].empty() || !numbered_[at(role)].empty(); }

    /// The one column of a role. Error columnsAmbiguous when there are several.
    std::size_t one(ProfileRole role, Text meaning) const
    {
        const std::vector<std::size_t>& columns = exact_[at(role)].empty() ? numbered_[at(role)] : exact_[at(role)];
        if (columns.size() > 1) throwAmbiguous(layout_, columns, meaning);
        return columns.front();
    }

    /// Columns of numbers without a role.
    const std::vector<std::size_t>& free() const { return exact_[at(ProfileRole::Unknown)]; }

    /// Whether the free columns have names of quantities other than coordinates.
    bool freeColumnsNameOtherQuantities() const { return haveNamesOfOtherQuantities(layout_, free()); }

private:
    static std::size_t at(ProfileRole role) { return static_cast<std::size_t>(role); }

    const TableLayout& layout_;
    std::array<std::vector<std::size_t>, 8> exact_;
    std::array<std::vector<std::size_t>, 8> numbered_;
};

ProfileColumnChoice pick(Shape shape, std::vector<std::size_t> columns)
{
    ProfileColumnChoice choice;
    choice.shape = shape;
    choice.columns = std::move(columns);
    return choice;
}

/// Angle with radius or deviation.
ProfileColumnChoice pickPolar(const TableLayout& layout, std::size_t angle, std::size_t value, bool areDeviations)
{
    ProfileColumnChoice choice = pick(Shape::Polar, {angle, value});
    choice.are_deviations = areDeviations;
    const TableColumn& column = layout.columns[angle];
    const QuantityHeading heading = parseQuantityHeading(column.heading);
    auto unit = heading.unit;
    if (!unit) unit = quantityUnit(column.unit_text);
    choice.is_angle_unit_stated = unit && unit->kind == QuantityUnit::Kind::Angle;
    choice.angle_name = plainName(heading.name);
    if (choice.is_angle_unit_stated)
        choice.degrees_per_unit = unit->scale;
    else
        choice.angle_unit_text = heading.unit_text.empty() ? column.unit_text : heading.unit_text;
    return choice;
}

std::size_t xOf(const NamedColumns& named)
{
    return named.one(ProfileRole::X, LT_TEXT("Engine", "x"));
}
std::size_t yOf(const NamedColumns& named)
{
    return named.one(ProfileRole::Y, LT_TEXT("Engine", "y"));
}
std::size_t zOf(const NamedColumns& named)
{
    return named.one(ProfileRole::Z, LT_TEXT("Engine", "z"));
}
std::size_t angleOf(const NamedColumns& named)
{
    return named.one(ProfileRole::Angle, LT_TEXT("Engine", "the angle"));
}

/// The column of radii, or of deviations if there is none.
std::size_t radiusOf(const NamedColumns& named, bool& areDeviations)
{
    areDeviations = !named.has(ProfileRole::Radius);
    return areDeviations ? named.one(ProfileRole::Deviation, LT_TEXT("Engine", "the deviation"))
                         : named.one(ProfileRole::Radius, LT_TEXT("Engine", "the radius"));
}

bool hasRadius(const NamedColumns& named)
{
    return named.has(ProfileRole::Radius) || named.has(ProfileRole::Deviation);
}

bool hasAnyRole(const NamedColumns& named)
{
    return named.has(ProfileRole::X) || named.has(ProfileRole::Y) || named.has(ProfileRole::Z) ||
           named.has(ProfileRole::Angle) || hasRadius(named);
}

/// Roles given by the caller for unnamed columns: the first two. Named columns leave a choice only if there are two.
std::pair<std::size_t, std::size_t> firstTwo(const TableLayout& layout, const NamedColumns& named, Text meaning)
{
    const std::vector<std::size_t>& free = named.free();
    if (free.size() > 2 && named.freeColumnsNameOtherQuantities()) throwAmbiguous(layout, free, meaning);
    return {free[0], free[1]};
}

ProfileColumnChoice chooseXy(const TableLayout& layout, const NamedColumns& named)
{
    if (named.has(ProfileRole::X) && named.has(ProfileRole::Y)) return pick(Shape::Xy, {xOf(named), yOf(named)});
    if (named.free().size() < 2 || hasAnyRole(named))
        throwProfileColumns(layout, LT_TEXT("Engine", "columns named x and y"));
    const auto [x, y] = firstTwo(layout, named, LT_TEXT("Engine", "x or y"));
    return pick(Shape::Xy, {x, y});
}

ProfileColumnChoice choosePolar(const TableLayout& layout, const NamedColumns& named)
{
    bool areDeviations = false;
    if (named.has(ProfileRole::Angle) && hasRadius(named)) {
        const std::size_t value = radiusOf(named, areDeviations);
        return pickPolar(layout, angleOf(named), value, areDeviations);
    }
    const std::vector<std::size_t>& free = named.free();
    if (named.has(ProfileRole::Angle) && !free.empty()) {
        if (free.size() > 1) throwAmbiguous(layout, free, LT_TEXT("Engine", "the radius"));
        return pickPolar(layout, angleOf(named), free[0], false);
    }
    if (free.size() < 2 || hasAnyRole(named))
        throwProfileColumns(layout, LT_TEXT("Engine", "columns named angle and r"));
    const auto [angle, value] = firstTwo(layout, named, LT_TEXT("Engine", "the angle or the radius"));
    return pickPolar(layout, angle, value, false);
}

ProfileColumnChoice chooseAuto(const TableLayout& layout, const NamedColumns& named)
{
    const Text expected = LT_TEXT("Engine", "columns named x and y, or angle and r");
    const auto inPlane = [](std::size_t first, std::size_t second, char a, char b) {
        ProfileColumnChoice choice = pick(Shape::Xy, {first, second});
        choice.axes = {a, b};
        return choice;
    };
    const bool x = named.has(ProfileRole::X), y = named.has(ProfileRole::Y), z = named.has(ProfileRole::Z),
               angle = named.has(ProfileRole::Angle);
    const std::vector<std::size_t>& free = named.free();
    if (x && y && z) return pick(Shape::Xyz, {xOf(named), yOf(named), zOf(named)});
    if (x && y) return pick(Shape::Xy, {xOf(named), yOf(named)});
    if (angle && hasRadius(named)) return choosePolar(layout, named);
    if (y && z) return inPlane(yOf(named), zOf(named), 'y', 'z');
    if (x && z) return inPlane(zOf(named), xOf(named), 'z', 'x');
    if (angle && free.size() == 1 && !named.freeColumnsNameOtherQuantities()) return choosePolar(layout, named);
    if (x || y || z || angle) throwProfileColumns(layout, expected);
    if (hasRadius(named)) {
        bool areDeviations = false;
        ProfileColumnChoice choice = pick(Shape::Trace, {radiusOf(named, areDeviations)});
        choice.are_deviations = areDeviations;
        return choice;
    }
    if (free.empty() || free.size() > 3 || named.freeColumnsNameOtherQuantities())
        throwProfileColumns(layout, expected);
    return pick(free.size() == 1 ? Shape::Trace : free.size() == 2 ? Shape::Undecided : Shape::Xyz, free);
}

}  // namespace

TableExpectation profileExpectation()
{
    TableExpectation expectation;
    expectation.minimum_columns = 1;
    expectation.knows_name = [](const std::string& name) {
        const Core core = coreOf(name);
        const auto isKnown = [](ProfileRole role) {
            return role != ProfileRole::Unknown && role != ProfileRole::Other;
        };
        return isKnown(profileRoleOf(core.name)) || isKnown(profileRoleOf(core.stem)) || isProbeName(core.name);
    };
    expectation.knows_unit = [](std::string_view word) { return quantityUnit(word).has_value(); };
    return expectation;
}

ProfileColumnChoice chooseProfileColumns(const TableLayout& layout, ProfileColumns wanted)
{
    if (hasProbeNames(layout))
        throw Error(errors::formatUnknown, {{"line", layout.body_line},
                                            {"column", std::int64_t{1}},
                                            {"found", LT_TEXT("Engine", "a probe record")},
                                            {"expected", LT_TEXT("Engine", "a profile: x and y, or angle and r")}});
    const NamedColumns named(layout);
    switch (wanted) {
        case ProfileColumns::Auto: break;
        case ProfileColumns::Xy: return chooseXy(layout, named);
        case ProfileColumns::AngleRadius: return choosePolar(layout, named);
    }
    return chooseAuto(layout, named);
}

bool holdsAngles(std::span<const double> rows, const TableLayout& layout)
{
    const std::size_t count = rows.size() / 2;
    if (count < 4) return false;
    const double first = rows[0];
    const double last = rows[2 * (count - 1)];
    const double turn = last > first ? 1 : -1;
    std::size_t against = 0;  // steps in the opposite direction
    double smallest = first;
    double largest = first;
    for (std::size_t i = 1; i < count; ++i) {
        against += (rows[2 * i] - rows[2 * (i - 1)]) * turn > 0 ? 0U : 1U;
        smallest = std::min(smallest, rows[2 * i]);
        largest = std::max(largest, rows[2 * i]);
    }
    const double span = largest - smallest;
    const bool isTurn = span >= 340 && span <= 361;
    if (against == 0 && isTurn) return true;
    // A revolution that does not start at 0 contains one jump.
    if (isTurn && count >= 8 && (against == 1 || against == count - 2) && smallest >= -180 && largest <= 361)
        return true;
    if (against > 0 || count < 8) return false;
    const double step = (last - first) / static_cast<double>(count - 1);
    for (std::size_t i = 0; i < count; ++i)
        if (std::abs(rows[2 * i] - (first + static_cast<double>(i) * step)) > 0.05 * std::abs(step)) return false;
    throwProfileColumns(layout, LT_TEXT("Engine", "names, or to be told whether they are x,y or angle,radius"));
}

}  // namespace lathelier::io
