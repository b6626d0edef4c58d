// Sections of averages out of a table.
#include <algorithm>
#include <cmath>
#include <map>

#include "engine/io/io_codes.h"
#include "engine/io/probe/probe_table.h"
#include "engine/io/table/column_names.h"

namespace lathelier::io {
namespace {

using Kind = QuantityUnit::Kind;
using Role = ProbeColumn::Role;

constexpr std::size_t mostSections = 10000;
constexpr int noColumn = -1;

/// The columns of one section's curves and how to bring them to µm or degrees.
struct Curve {
    std::vector<double> AveragedSection::*member;
    int column = noColumn;
    double scale = 1;
};

[[noreturn]] void throwRecordColumns(const ProbeTable& table, Text expected)
{
    throw Error(errors::columnsUnknown, {{"line", table.layout.body_line},
                                         {"column", std::int64_t{1}},
                                         {"found", columnNames(table.layout)},
                                         {"expected", expected}});
}

int columnOf(const ProbeTable& table, std::string_view plain)
{
    for (std::size_t k = 0; k < table.width(); ++k)
        if (plainName(table.column(k).name) == plain) return static_cast<int>(k);
    return noColumn;
}

int columnOf(const ProbeTable& table, Role role)
{
    for (std::size_t k = 0; k < table.width(); ++k)
        if (table.column(k).role == role) return static_cast<int>(k);
    return noColumn;
}

/// µm per unit of a displacement.
double micrometresPer(const ProbeTable& table, int k)
{
    std::optional<QuantityUnit> unit = table.column(static_cast<std::size_t>(k)).unit;
    if (!unit) unit = displacementUnit(table);
    if (unit && unit->kind != Kind::Length)
        throwRecordColumns(table, LT_TEXT("Engine", "displacements in units of length"));
    if (!unit) {
        double largest = 0;
        for (std::size_t i = 0; i < table.rows.rows; ++i)
            largest = std::max(largest, std::abs(table.at(i, static_cast<std::size_t>(k))));
        throw Error(errors::unitUnknown,
                    {{"line", table.layout.body_line}, {"column", std::int64_t{1}}, {"extent", largest}});
    }
    return unit->key == "um" ? 1 : unit->scale * 1000;
}

/// Degrees per unit of the angle. A word that is no unit is refused unless the angles run over a turn of degrees.
double degreesPer(const ProbeTable& table, int k)
{
    const auto column = static_cast<std::size_t>(k);
    const ProbeColumn& angle = table.column(column);
    if (angle.unit) return angle.unit->scale;
    if (angle.unit_text.empty() || table.rows.rows == 0) return 1;
    double low = table.at(0, column), high = low;
    for (std::size_t i = 1; i < table.rows.rows; ++i) {
        low = std::min(low, table.at(i, column));
        high = std::max(high, table.at(i, column));
    }
    constexpr double nearlyTurn_deg = 340, turn_deg = 361;
    if (high - low >= nearlyTurn_deg && high - low <= turn_deg) return 1;
    throw Error(errors::angleUnitUnknown,
                {{"line", table.layout.body_line},
                 {"column", static_cast<std::int64_t>(table.read[column]) + 1},
                 {"found", angle.unit_text},
                 {"expected", LT_TEXT("Engine", "deg, rad, mrad, gon, rev, arcmin or arcsec")}});
}

std::vector<Curve> findCurves(const ProbeTable& table)
{
    using S = AveragedSection;
    std::vector<Curve> curves;
    const auto add = [&](std::vector<double> S::*member, const char* name, bool isNeeded) {
        const int k = columnOf(table, name);
        if (k == noColumn && isNeeded) throwRecordColumns(table, LT_TEXT("Engine", "columns named X3, Y3, Xp and Yp"));
        if (k != noColumn) curves.push_back({member, k, micrometresPer(table, k)});
    };
    add(&S::X3_um, "x3", true);
    add(&S::Y3_um, "y3", true);
    add(&S::Xp_um, "xp", true);
    add(&S::Yp_um, "yp", true);
    add(&S::sX3_um, "sx3", false);
    add(&S::sY3_um, "sy3", false);
    add(&S::sXp_um, "sxp", false);
    add(&S::sYp_um, "syp", false);
    const int angle = columnOf(table, Role::Angle);
    curves.push_back({&S::angle_deg, angle, degreesPer(table, angle)});
    return curves;
}

/// mm per unit of z; mm by default.
double millimetresPer(const ProbeTable& table, int z)
{
    const auto& unit = table.column(static_cast<std::size_t>(z)).unit;
    return unit && unit->kind == Kind::Length ? unit->scale : 1;
}

}  // namespace

AveragedRecord toAveragedRecord(const ProbeTable& table, const Progress& progress)
{
    const std::vector<Curve> curves = findCurves(table);
    const auto sectionColumn = static_cast<std::size_t>(columnOf(table, Role::Section));
    const int z = columnOf(table, Role::Position);
    const double z_mm = z == noColumn ? 1 : millimetresPer(table, z);
    AveragedRecord record;
    record.name = table.name.substr(table.name.find_last_of('/') + 1);
    record.header = table.header;
    std::map<int, std::size_t> places;
    for (std::size_t i = 0; i < table.rows.rows; ++i) {
        if ((i & 0xFFFF) == 0) progress.check();
        const double number = table.at(i, sectionColumn);
        if (!(std::abs(number) <= 1e9) || number != std::round(number))
            throw malformedRow(table, i, sectionColumn, LT_TEXT("Engine", "the number of a section"));
        const auto [place, isNew] = places.try_emplace(static_cast<int>(number), record.sections.size());
        if (isNew) {
            if (places.size() > mostSections)
                throw malformedRow(table, i, sectionColumn, LT_TEXT("Engine", "at most 10000 sections"));
            record.sections.emplace_back().section = place->first;
        }
        AveragedSection& section = record.sections[place->second];
        if (z != noColumn) {
            const double position_mm = table.at(i, static_cast<std::size_t>(z)) * z_mm;
            if (!isNew && section.z_mm != position_mm)
                throw malformedRow(table, i, static_cast<std::size_t>(z), LT_TEXT("Engine", "one z for a section"));
            section.z_mm = position_mm;
        }
        for (const Curve& curve : curves)
            (section.*curve.member).push_back(table.at(i, static_cast<std::size_t>(curve.column)) * curve.scale);
    }
    return record;
}

}  // namespace lathelier::io
