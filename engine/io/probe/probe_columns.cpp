#include "engine/io/probe/probe_columns.h"

#include <algorithm>

#include "engine/io/text/text_lines.h"
#include "engine/io/text/units.h"

namespace lathelier::io {
namespace {

bool isTimeName(const std::string& plain)
{
    return isOneOf(plain, {"t", "time", "timestamp", "zeit", "czas", "tempo", "temps", "время", "elapsed"});
}

bool isAngleName(const std::string& plain)
{
    return isOneOf(plain, {"angle", "theta", "phi", "fi", "winkel", "kąt", "kat", "angolo", "угол", "encoder"});
}

bool isSectionName(const std::string& plain)
{
    return isOneOf(plain, {"section", "sec", "schnitt", "przekrój", "przekroj", "sezione", "сечение"});
}

bool isMarkerName(const std::string& plain)
{
    return isOneOf(plain, {"marker", "mark", "trigger", "trig", "keyphasor", "zeropulse", "znacznik", "маркер"});
}

bool isProbe(const std::string& plain)
{
    return isOneOf(plain, {"x3", "y3", "xp", "yp"});
}

/// "ch3", "channel 3", "kanał 3".
bool isChannelName(const std::string& plain)
{
    for (const std::string_view word : {"channel", "ch", "kanal", "kanał", "probe", "sensor", "канал"})
        if (plain.size() > word.size() && plain.starts_with(word) &&
            plain.find_first_not_of("0123456789", word.size()) == std::string::npos)
            return true;
    return false;
}

}  // namespace

std::string plainName(std::string_view name)
{
    std::string plain;
    for (const char c : lowerCase(name))
        if ((c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || static_cast<unsigned char>(c) >= 0x80) plain += c;
    return plain;
}

bool isIndexName(const std::string& plain)
{
    return isOneOf(plain, {"i", "index", "idx", "n", "nr", "no", "id", "lp", "number", "row", "point", "pt", "sample",
                           "frame", "probka", "próbka"});
}

bool isProbeName(std::string_view name)
{
    const std::string plain = plainName(name);
    return isProbe(plain) || isMarkerName(plain) || isChannelName(plain) || isTimeName(plain) || isSectionName(plain);
}

bool hasProbeNames(const TableLayout& layout)
{
    std::size_t probes = 0;
    std::size_t signals = 0;
    bool times = false;
    for (const TableColumn& column : layout.columns) {
        if (!column.is_number) continue;
        const QuantityHeading heading = parseQuantityHeading(column.heading);
        const std::string plain = plainName(heading.name);
        const bool isVoltage = heading.unit && heading.unit->kind == QuantityUnit::Kind::Voltage;
        probes += isProbe(plain) ? 1U : 0U;
        times = times || isTimeName(plain);
        signals += isProbe(plain) || isMarkerName(plain) || isChannelName(plain) || isVoltage ? 1U : 0U;
    }
    return probes >= 2 || signals >= 2 || (times && signals >= 1);
}

std::vector<ProbeColumn> findProbeColumns(const TableLayout& layout)
{
    std::vector<ProbeColumn> columns;
    for (const TableColumn& column : layout.columns) {
        QuantityHeading heading = parseQuantityHeading(column.heading);
        if (!heading.unit) heading.unit = quantityUnit(column.unit_text);
        if (!heading.unit && column.unit)
            heading.unit = QuantityUnit{QuantityUnit::Kind::Length, column.unit->key, column.unit->mm};
        const std::string plain = plainName(heading.name);
        const auto is = [&heading](QuantityUnit::Kind kind) { return heading.unit && heading.unit->kind == kind; };
        ProbeColumn found{ProbeColumn::Role::Signal, heading.name, heading.unit};
        if (!heading.unit) found.unit_text = heading.unit_text.empty() ? column.unit_text : heading.unit_text;
        if (!column.is_number)
            found.role = ProbeColumn::Role::Text;
        else if (is(QuantityUnit::Kind::Time) || (isTimeName(plain) && !heading.unit))
            found.role = ProbeColumn::Role::Time;
        else if (is(QuantityUnit::Kind::Angle) || (isAngleName(plain) && !heading.unit))
            found.role = ProbeColumn::Role::Angle;
        else if (isSectionName(plain))
            found.role = ProbeColumn::Role::Section;
        else if (plain == "z")
            found.role = ProbeColumn::Role::Position;
        else if (isIndexName(plain) || (plain.empty() && column.is_count))
            found.role = ProbeColumn::Role::Index;
        columns.push_back(std::move(found));
    }
    return columns;
}

TableExpectation probeExpectation()
{
    TableExpectation expectation;
    expectation.minimum_columns = 2;
    expectation.knows_name = [](const std::string& name) {
        const std::string plain = plainName(parseQuantityHeading(name).name);
        return isProbeName(plain) || isAngleName(plain);
    };
    expectation.knows_unit = [](std::string_view word) { return quantityUnit(word).has_value(); };
    return expectation;
}

}  // namespace lathelier::io
