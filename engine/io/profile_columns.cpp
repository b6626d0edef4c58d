#include "engine/io/profile_columns.h"

#include <cmath>

#include "engine/io/encoding.h"
#include "engine/io/io_codes.h"
#include "engine/io/probe_columns.h"
#include "engine/io/quantity.h"

namespace lathelier {
namespace {

using Shape = ProfileColumnChoice::Shape;

enum class Role { Unknown, X, Y, Z, Angle, Radius, Deviation, Other };

Role roleOf(const std::string& name)
{
    const std::string core = plainName(name);
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
    if (isOneOf({"r", "radius", "rho", "promień", "promien", "raggio", "радиус", "ρ"})) return Role::Radius;
    if (isOneOf({"deviation", "dev", "dr", "deltar", "δr", "abweichung", "odchyłka", "odchylka", "scostamento", "error",
                 "form", "roundness", "displacement", "trace"}))
        return Role::Deviation;
    if (isIndexName(core) || isOneOf({"label", "quality", "weight", "t", "time", "section", "used"}))
        return Role::Other;
    return Role::Unknown;
}

[[noreturn]] void throwColumns(const TableLayout& layout, Text expected)
{
    throw Error(errors::columnsUnknown, {{"line", layout.bodyLine},
                                         {"column", std::int64_t{1}},
                                         {"found", columnNames(layout)},
                                         {"expected", expected}});
}

/// First column with each role; -1 without it.
struct Named {
    int x = -1, y = -1, z = -1, angle = -1, radius = -1, deviation = -1;
    std::vector<std::size_t> free;  ///< columns of numbers whose names say nothing
};

Named findNamed(const TableLayout& layout)
{
    Named named;
    const auto take = [](int& place, std::size_t k) {
        if (place < 0) place = static_cast<int>(k);
    };
    for (std::size_t k = 0; k < layout.columns.size(); ++k) {
        if (!layout.columns[k].isNumber) continue;
        switch (roleOf(parseQuantityHeading(layout.columns[k].heading).name)) {
            case Role::X: take(named.x, k); break;
            case Role::Y: take(named.y, k); break;
            case Role::Z: take(named.z, k); break;
            case Role::Angle: take(named.angle, k); break;
            case Role::Radius: take(named.radius, k); break;
            case Role::Deviation: take(named.deviation, k); break;
            case Role::Unknown: named.free.push_back(k); break;
            case Role::Other: break;
        }
    }
    // A row number in front of values with decimal marks.
    if (named.free.size() > 1 && layout.columns[named.free[0]].isCount && layout.columns[named.free[0]].name.empty() &&
        layout.columns[named.free[1]].hasMarks)
        named.free.erase(named.free.begin());
    return named;
}

ProfileColumnChoice pick(Shape shape, std::initializer_list<int> columns)
{
    ProfileColumnChoice choice;
    choice.shape = shape;
    for (const int k : columns) choice.columns.push_back(static_cast<std::size_t>(k));
    return choice;
}

/// Angle and what belongs to it.
ProfileColumnChoice pickPolar(const TableLayout& layout, int angle, int value, bool areDeviations)
{
    ProfileColumnChoice choice = pick(Shape::Polar, {angle, value});
    choice.areDeviations = areDeviations;
    const TableColumn& column = layout.columns[static_cast<std::size_t>(angle)];
    auto unit = parseQuantityHeading(column.heading).unit;
    if (!unit) unit = quantityUnit(column.unitWord);
    choice.angleStated = unit && unit->kind == QuantityUnit::Kind::Angle;
    if (choice.angleStated) choice.degreesPerUnit = unit->scale;
    return choice;
}

ProfileColumnChoice chooseXy(const TableLayout& layout, const Named& named)
{
    if (named.x >= 0 && named.y >= 0) return pick(Shape::Xy, {named.x, named.y});
    if (named.free.size() >= 2)
        return pick(Shape::Xy, {static_cast<int>(named.free[0]), static_cast<int>(named.free[1])});
    throwColumns(layout, LT_TEXT("Engine", "columns named x and y"));
}

ProfileColumnChoice choosePolar(const TableLayout& layout, const Named& named)
{
    const int value = named.radius >= 0 ? named.radius : named.deviation;
    const bool areDeviations = named.radius < 0 && value >= 0;
    if (named.angle >= 0 && value >= 0) return pickPolar(layout, named.angle, value, areDeviations);
    if (named.angle >= 0 && !named.free.empty())
        return pickPolar(layout, named.angle, static_cast<int>(named.free[0]), false);
    if (named.free.size() >= 2)
        return pickPolar(layout, static_cast<int>(named.free[0]), static_cast<int>(named.free[1]), false);
    throwColumns(layout, LT_TEXT("Engine", "columns named angle and r"));
}

ProfileColumnChoice chooseAuto(const TableLayout& layout, const Named& named)
{
    const auto inPlane = [&](int first, int second, char a, char b) {
        ProfileColumnChoice choice = pick(Shape::Xy, {first, second});
        choice.axes = {a, b};
        return choice;
    };
    if (named.x >= 0 && named.y >= 0 && named.z >= 0) return pick(Shape::Xyz, {named.x, named.y, named.z});
    if (named.x >= 0 && named.y >= 0) return pick(Shape::Xy, {named.x, named.y});
    if (named.angle >= 0 && (named.radius >= 0 || named.deviation >= 0)) return choosePolar(layout, named);
    if (named.y >= 0 && named.z >= 0) return inPlane(named.y, named.z, 'y', 'z');
    if (named.x >= 0 && named.z >= 0) return inPlane(named.z, named.x, 'z', 'x');
    if (named.angle >= 0 && named.free.size() == 1) return choosePolar(layout, named);
    if (named.x >= 0 || named.y >= 0 || named.z >= 0 || named.angle >= 0)
        throwColumns(layout, LT_TEXT("Engine", "columns named x and y, or angle and r"));
    if (named.radius >= 0 || named.deviation >= 0) {
        const bool areDeviations = named.radius < 0;
        ProfileColumnChoice choice = pick(Shape::Trace, {areDeviations ? named.deviation : named.radius});
        choice.areDeviations = areDeviations;
        return choice;
    }
    const std::vector<std::size_t>& free = named.free;
    if (free.size() == 1) return pick(Shape::Trace, {static_cast<int>(free[0])});
    if (free.size() == 2) return pick(Shape::Undecided, {static_cast<int>(free[0]), static_cast<int>(free[1])});
    if (free.size() == 3)
        return pick(Shape::Xyz, {static_cast<int>(free[0]), static_cast<int>(free[1]), static_cast<int>(free[2])});
    throwColumns(layout, LT_TEXT("Engine", "columns named x and y, or angle and r"));
}

}  // namespace

TableExpectation profileExpectation()
{
    TableExpectation expectation;
    expectation.minimumColumns = 1;
    expectation.knowsName = [](const std::string& name) {
        const Role role = roleOf(parseQuantityHeading(name).name);
        return (role != Role::Unknown && role != Role::Other) || isProbeName(parseQuantityHeading(name).name);
    };
    expectation.knowsUnit = [](std::string_view word) { return quantityUnit(word).has_value(); };
    return expectation;
}

std::string columnNames(const TableLayout& layout)
{
    std::string names;
    for (const TableColumn& column : layout.columns) {
        const std::string& name = column.heading.empty() ? column.name : column.heading;
        names += (names.empty() ? "" : " ") + (name.empty() ? std::string("?") : name);
        if (names.size() > 1000) break;
    }
    return excerpt(names);
}

ProfileColumnChoice chooseProfileColumns(const TableLayout& layout, ProfileColumns wanted)
{
    if (hasProbeNames(layout))
        throw Error(errors::formatUnknown, {{"line", layout.bodyLine},
                                            {"column", std::int64_t{1}},
                                            {"found", LT_TEXT("Engine", "a probe record")},
                                            {"expected", LT_TEXT("Engine", "a profile: x and y, or angle and r")}});
    const Named named = findNamed(layout);
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
        against += (rows[2 * i] - rows[2 * (i - 1)]) * turn > 0 ? 0 : 1;
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

}  // namespace lathelier
