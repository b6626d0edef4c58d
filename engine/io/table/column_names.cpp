#include "engine/io/table/column_names.h"

#include <algorithm>

#include "engine/io/io_codes.h"
#include "engine/io/probe/probe_columns.h"
#include "engine/io/text/encoding.h"
#include "engine/io/text/quantity.h"
#include "engine/io/text/text_lines.h"

namespace lathelier::io {
namespace {

/// "col 2", "field3", "var_1", "B", "unnamed: 0".
bool isGeneric(const std::string& plain)
{
    const std::string stem = plain.substr(0, plain.find_last_not_of("0123456789") + 1);
    return stem.size() <= 1 ||
           isOneOf(stem, {"col",        "column",  "field",    "var",       "value",   "val",     "data",
                          "unnamed",    "spalte",  "feld",     "wert",      "kolumna", "pole",    "coord",
                          "coordinate", "easting", "northing", "elevation", "height",  "altitude"});
}

}  // namespace

bool isOtherQuantity(std::string_view name)
{
    const std::string plain = plainName(name);
    return isProbeName(plain) ||
           isOneOf(plain,
                   {"force",        "fx",         "fy",        "fz",         "torque",  "moment",    "temp",
                    "temperature",  "frequency",  "freq",      "hz",         "real",    "imag",      "imaginary",
                    "re",           "im",         "magnitude", "amplitude",  "phase",   "coherence", "speed",
                    "rpm",          "feed",       "voltage",   "volt",       "current", "power",     "pressure",
                    "acceleration", "velocity",   "strain",    "stress",     "load",    "humidity",  "signal",
                    "kraft",        "temperatur", "frequenz",  "drehmoment", "siła",    "sila",      "temperatura",
                    "сила",         "частота"});
}

bool haveNamesOfOtherQuantities(const TableLayout& layout, std::span<const std::size_t> columns)
{
    std::size_t known = 0, unknown = 0;
    for (const std::size_t k : columns) {
        const TableColumn& column = layout.columns[k];
        const std::string& written = column.heading.empty() ? column.name : column.heading;
        const std::string plain = plainName(parseQuantityHeading(written).name);
        const std::string first = written.substr(0, written.find_first_of("_(["));
        if (plain.empty()) continue;
        if (isOtherQuantity(plain) || isOtherQuantity(first))
            ++known;
        else if (!isGeneric(plain))
            ++unknown;
    }
    if (layout.columns.size() == 1) return known > 0;
    return layout.style.delimiter == ' ' ? known > 1 : known + unknown > 0;
}

std::string namesOf(const TableLayout& layout, std::span<const std::size_t> columns)
{
    std::string names;
    for (const std::size_t k : columns) {
        const TableColumn& column = layout.columns[k];
        const std::string& written = column.heading.empty() ? column.name : column.heading;
        names += (names.empty() ? "" : ", ") + (written.empty() ? std::to_string(k + 1) : excerpt(written));
        if (names.size() > 500) return names + ", …";
    }
    return names;
}

void throwAmbiguous(const TableLayout& layout, std::span<const std::size_t> candidates, Text meaning)
{
    throw Error(errors::columnsAmbiguous, {{"line", layout.body_line},
                                           {"column", std::int64_t{1}},
                                           {"found", columnNames(layout)},
                                           {"candidates", namesOf(layout, candidates)},
                                           {"meaning", meaning}});
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

}  // namespace lathelier::io
