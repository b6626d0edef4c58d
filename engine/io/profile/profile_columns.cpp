#include "engine/io/profile/profile_columns.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "engine/io/io_codes.h"
#include "engine/io/probe/probe_columns.h"
#include "engine/io/table/column_names.h"
#include "engine/io/text/quantity.h"

namespace lathelier::io {
namespace {

using Shape = ProfileColumnChoice::Shape;

enum class Role { Unknown, X, Y, Z, Angle, Radius, Deviation, Other };

Role roleOf(const std::string& core)
{
    const auto isOneOf = [&core](std::initializer_list<const char*> words) {
        for (const char* word : words)
            if (core == word) return true;
        return false;
    };
    if (isOneOf({"x", "px", "posx", "positionx", "xpos", "xcoordinate", "xkoordinate"})) return Role::X;
    if (isOneOf({"y", "py", "posy", "positiony", "ypos", "ycoordinate", "ykoordinate"})) return Role::Y;
    if (isOneOf({"z", "pz", "posz", "positionz", "zpos", "zcoordinate", "height"})) return Role::Z;
    if (isOneOf(
            {"angle", "theta", "phi", "fi", "azimuth", "winkel", "kąt", "kat", "angolo", "угол", "θ", "φ", "angular"}))
        return Role::Angle;
    // A distance or a reading may be a radius or a deviation: its values tell.
    if (isOneOf({"r", "radius", "rho", "promień", "promien", "raggio", "радиус", "ρ", "distance", "dist", "abstand",
                 "reading", "readings", "messwert", "odczyt", "odległość"}))
        return Role::Radius;
    if (isOneOf({"deviation", "deviations", "dev", "dr", "deltar", "δr", "abweichung", "odchyłka", "odchylka",
                 "scostamento", "error", "form", "roundness", "displacement", "trace"}))
        return Role::Deviation;
    if (isIndexName(core) || isOneOf({"label", "quality", "weight", "t", "time", "section", "used"}))
        return Role::Other;
    return Role::Unknown;
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

[[noreturn]] void throwColumns(const TableLayout& layout, Text expected)
{
    throw Error(errors::columnsUnknown, {{"line", layout.bodyLine},
                                         {"column", std::int64_t{1}},
                                         {"found", columnNames(layout)},
                                         {"expected", expected}});
}

/// The columns by what their names say.
class Named {
public:
    explicit Named(const TableLayout& layout) : layout_(layout)
    {
        for (std::size_t k = 0; k < layout.columns.size(); ++k) {
            if (!layout.columns[k].isNumber) continue;
            const Core core = coreOf(layout.columns[k].heading);
            const Role role = roleOf(core.name);
            const Role further = roleOf(core.stem);
            if (role == Role::Unknown && !core.stem.empty() && further != Role::Unknown)
                numbered_[static_cast<std::size_t>(further)].push_back(k);
            else
                exact_[static_cast<std::size_t>(role)].push_back(k);
        }
        std::vector<std::size_t>& free = exact_[static_cast<std::size_t>(Role::Unknown)];
        // A row number in front of values with decimal marks.
        if (free.size() > 1 && layout.columns[free[0]].isCount && layout.columns[free[0]].name.empty() &&
            layout.columns[free[1]].hasMarks)
            free.erase(free.begin());
    }

    bool has(Role role) const { return !exact_[at(role)].empty() || !numbered_[at(role)].empty(); }

    /// The one column of a role. Error columnsAmbiguous when there are several.
    std::size_t one(Role role, Text meaning) const
    {
        const std::vector<std::size_t>& columns = exact_[at(role)].empty() ? numbered_[at(role)] : exact_[at(role)];
        if (columns.size() > 1) throwAmbiguous(layout_, columns, meaning);
        return columns.front();
    }

    /// Columns of numbers whose names say nothing.
    const std::vector<std::size_t>& free() const { return exact_[at(Role::Unknown)]; }

    /// The free columns are named, and no coordinates.
    bool freeSayElse() const { return saySomethingElse(layout_, free()); }

private:
    static std::size_t at(Role role) { return static_cast<std::size_t>(role); }

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

/// Angle and what belongs to it.
ProfileColumnChoice pickPolar(const TableLayout& layout, std::size_t angle, std::size_t value, bool areDeviations)
{
    ProfileColumnChoice choice = pick(Shape::Polar, {angle, value});
    choice.areDeviations = areDeviations;
    const TableColumn& column = layout.columns[angle];
    auto unit = parseQuantityHeading(column.heading).unit;
    if (!unit) unit = quantityUnit(column.unitWord);
    choice.angleStated = unit && unit->kind == QuantityUnit::Kind::Angle;
    if (choice.angleStated) choice.degreesPerUnit = unit->scale;
    return choice;
}

std::size_t xOf(const Named& named)
{
    return named.one(Role::X, LT_TEXT("Engine", "x"));
}
std::size_t yOf(const Named& named)
{
    return named.one(Role::Y, LT_TEXT("Engine", "y"));
}
std::size_t zOf(const Named& named)
{
    return named.one(Role::Z, LT_TEXT("Engine", "z"));
}
std::size_t angleOf(const Named& named)
{
    return named.one(Role::Angle, LT_TEXT("Engine", "the angle"));
}

/// The column of radii or, for want of one, of deviations.
std::size_t radiusOf(const Named& named, bool& areDeviations)
{
    areDeviations = !named.has(Role::Radius);
    return areDeviations ? named.one(Role::Deviation, LT_TEXT("Engine", "the deviation"))
                         : named.one(Role::Radius, LT_TEXT("Engine", "the radius"));
}

bool hasRadius(const Named& named)
{
    return named.has(Role::Radius) || named.has(Role::Deviation);
}

bool hasAnyRole(const Named& named)
{
    return named.has(Role::X) || named.has(Role::Y) || named.has(Role::Z) || named.has(Role::Angle) || hasRadius(named);
}

/// What the caller says of columns whose names say nothing: the first two. Names that say something leave no choice but
/// two columns.
std::pair<std::size_t, std::size_t> firstTwo(const TableLayout& layout, const Named& named, Text meaning)
{
    const std::vector<std::size_t>& free = named.free();
    if (free.size() > 2 && named.freeSayElse()) throwAmbiguous(layout, free, meaning);
    return {free[0], free[1]};
}

ProfileColumnChoice chooseXy(const TableLayout& layout, const Named& named)
{
    if (named.has(Role::X) && named.has(Role::Y)) return pick(Shape::Xy, {xOf(named), yOf(named)});
    if (named.free().size() < 2 || hasAnyRole(named)) throwColumns(layout, LT_TEXT("Engine", "columns named x and y"));
    const auto [x, y] = firstTwo(layout, named, LT_TEXT("Engine", "x or y"));
    return pick(Shape::Xy, {x, y});
}

ProfileColumnChoice choosePolar(const TableLayout& layout, const Named& named)
{
    bool areDeviations = false;
    if (named.has(Role::Angle) && hasRadius(named)) {
        const std::size_t value = radiusOf(named, areDeviations);
        return pickPolar(layout, angleOf(named), value, areDeviations);
    }
    const std::vector<std::size_t>& free = named.free();
    if (named.has(Role::Angle) && !free.empty()) {
        if (free.size() > 1) throwAmbiguous(layout, free, LT_TEXT("Engine", "the radius"));
        return pickPolar(layout, angleOf(named), free[0], false);
    }
    if (free.size() < 2 || hasAnyRole(named)) throwColumns(layout, LT_TEXT("Engine", "columns named angle and r"));
    const auto [angle, value] = firstTwo(layout, named, LT_TEXT("Engine", "the angle or the radius"));
    return pickPolar(layout, angle, value, false);
}

ProfileColumnChoice chooseAuto(const TableLayout& layout, const Named& named)
{
    const Text expected = LT_TEXT("Engine", "columns named x and y, or angle and r");
    const auto inPlane = [](std::size_t first, std::size_t second, char a, char b) {
        ProfileColumnChoice choice = pick(Shape::Xy, {first, second});
        choice.axes = {a, b};
        return choice;
    };
    const bool x = named.has(Role::X), y = named.has(Role::Y), z = named.has(Role::Z), angle = named.has(Role::Angle);
    const std::vector<std::size_t>& free = named.free();
    if (x && y && z) return pick(Shape::Xyz, {xOf(named), yOf(named), zOf(named)});
    if (x && y) return pick(Shape::Xy, {xOf(named), yOf(named)});
    if (angle && hasRadius(named)) return choosePolar(layout, named);
    if (y && z) return inPlane(yOf(named), zOf(named), 'y', 'z');
    if (x && z) return inPlane(zOf(named), xOf(named), 'z', 'x');
    if (angle && free.size() == 1 && !named.freeSayElse()) return choosePolar(layout, named);
    if (x || y || z || angle) throwColumns(layout, expected);
    if (hasRadius(named)) {
        bool areDeviations = false;
        ProfileColumnChoice choice = pick(Shape::Trace, {radiusOf(named, areDeviations)});
        choice.areDeviations = areDeviations;
        return choice;
    }
    if (free.empty() || free.size() > 3 || named.freeSayElse()) throwColumns(layout, expected);
    return pick(free.size() == 1 ? Shape::Trace : free.size() == 2 ? Shape::Undecided : Shape::Xyz, free);
}

}  // namespace

TableExpectation profileExpectation()
{
    TableExpectation expectation;
    expectation.minimumColumns = 1;
    expectation.knowsName = [](const std::string& name) {
        const Core core = coreOf(name);
        const auto isKnown = [](Role role) { return role != Role::Unknown && role != Role::Other; };
        return isKnown(roleOf(core.name)) || isKnown(roleOf(core.stem)) || isProbeName(core.name);
    };
    expectation.knowsUnit = [](std::string_view word) { return quantityUnit(word).has_value(); };
    return expectation;
}

ProfileColumnChoice chooseProfileColumns(const TableLayout& layout, ProfileColumns wanted)
{
    if (hasProbeNames(layout))
        throw Error(errors::formatUnknown, {{"line", layout.bodyLine},
                                            {"column", std::int64_t{1}},
                                            {"found", LT_TEXT("Engine", "a probe record")},
                                            {"expected", LT_TEXT("Engine", "a profile: x and y, or angle and r")}});
    const Named named(layout);
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
    std::size_t against = 0;  // steps the other way
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
    // A turn that starts somewhere else jumps back once by itself.
    if (isTurn && count >= 8 && (against == 1 || against == count - 2) && smallest >= -180 && largest <= 361)
        return true;
    if (against > 0 || count < 8) return false;
    const double step = (last - first) / static_cast<double>(count - 1);
    for (std::size_t i = 0; i < count; ++i)
        if (std::abs(rows[2 * i] - (first + static_cast<double>(i) * step)) > 0.05 * std::abs(step)) return false;
    throwColumns(layout, LT_TEXT("Engine", "names, or to be told whether they are x,y or angle,radius"));
}

}  // namespace lathelier::io
