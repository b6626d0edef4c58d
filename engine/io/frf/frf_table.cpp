#include "engine/io/frf/frf_table.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/io/frf/frf_codes.h"
#include "engine/io/frf/frf_lines.h"
#include "engine/io/io_codes.h"
#include "engine/io/table/column_names.h"
#include "engine/io/table/table_facts.h"
#include "engine/io/table/table_layout.h"
#include "engine/io/table/table_rows.h"
#include "engine/io/text/encoding.h"
#include "engine/io/text/quantity.h"
#include "engine/io/text/readable_text.h"
#include "engine/io/text/text_lines.h"
#include "engine/io/text/units.h"

namespace lathelier::io {
namespace {

constexpr Text expectedFrfTable =
    LT_TEXT("Engine", "a table of a frequency response: frequency, real and imaginary part");
constexpr Text expectedUnit = LT_TEXT("Engine", "headings such as real_mm_N and imag_mm_N, or phase_deg");

enum class FrfRole { Frequency, Real, Imaginary, Magnitude, Phase, Coherence, Other };

struct RoleWord {
    std::string_view word;
    FrfRole role;
};

constexpr RoleWord roleWords[] = {
    {"frequency", FrfRole::Frequency}, {"freq", FrfRole::Frequency},      {"f", FrfRole::Frequency},
    {"hz", FrfRole::Frequency},        {"real", FrfRole::Real},           {"re", FrfRole::Real},
    {"imag", FrfRole::Imaginary},      {"imaginary", FrfRole::Imaginary}, {"im", FrfRole::Imaginary},
    {"magnitude", FrfRole::Magnitude}, {"mag", FrfRole::Magnitude},       {"abs", FrfRole::Magnitude},
    {"amplitude", FrfRole::Magnitude}, {"phase", FrfRole::Phase},         {"angle", FrfRole::Phase},
    {"arg", FrfRole::Phase},           {"coherence", FrfRole::Coherence}, {"coh", FrfRole::Coherence},
    {"gamma", FrfRole::Coherence},     {"γ", FrfRole::Coherence}};

bool isHeadingLetter(char c)
{
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || static_cast<unsigned char>(c) >= 0x80;
}

/// A parsed heading: "real_mm_N" is Real and "mm/N", "Re(H) [m/N]" Real and "m/N".
struct FrfHeading {
    FrfRole role = FrfRole::Other;
    std::string unit;  ///< as written, with / for _; empty: none
};

FrfHeading parseFrfHeading(std::string_view heading)
{
    heading = trimmed(heading);
    std::size_t end = 0;
    while (end < heading.size() && isHeadingLetter(heading[end])) ++end;
    FrfHeading found;
    const std::string word = lowerCase(heading.substr(0, end));
    for (const RoleWord& known : roleWords)
        if (word == known.word) found.role = known.role;
    std::string_view rest = heading.substr(end);
    const std::size_t open = rest.find_last_of("[(");
    // "(m/s)/N" is a unit as a whole; "(H) [m/N]" ends with one.
    if (open != std::string_view::npos && (open > 0 || rest.back() == ')' || rest.back() == ']'))
        if (const std::size_t close = rest.find_first_of("])", open); close + 1 == rest.size())
            rest = rest.substr(open + 1, close - open - 1);
    while (!rest.empty() && std::string_view("_ ,:/-").find(rest.front()) != std::string_view::npos)
        rest.remove_prefix(1);
    found.unit = rest;
    std::replace(found.unit.begin(), found.unit.end(), '_', '/');
    return found;
}

TableExpectation frfExpectation()
{
    TableExpectation expectation;
    expectation.minimum_columns = 3;
    expectation.knows_name = [](const std::string& name) { return parseFrfHeading(name).role != FrfRole::Other; };
    expectation.knows_unit = [](std::string_view word) {
        return frfUnit(word) || (!isUnstated(word) && hzPerUnit(word)) || quantityUnit(word);
    };
    return expectation;
}

/// Roles of the columns.
struct FrfColumns {
    std::size_t frequency = 0, first = 0, second = 0;  ///< column indices
    std::optional<std::size_t> coherence;              ///< column index
    bool is_polar = false;                             ///< true: magnitude and phase
};

std::optional<std::size_t> frfColumn(const TableLayout& layout, FrfRole role)
{
    std::vector<std::size_t> found;
    for (std::size_t k = 0; k < layout.columns.size(); ++k)
        if (layout.columns[k].is_number && parseFrfHeading(layout.columns[k].heading).role == role) found.push_back(k);
    if (found.size() > 1) throwAmbiguous(layout, found, LT_TEXT("Engine", "a column of a frequency response"));
    return found.empty() ? std::nullopt : std::optional(found.front());
}

std::optional<FrfColumns> findFrfColumns(const TableLayout& layout)
{
    if (!layout.has_names) return std::nullopt;
    const auto frequency = frfColumn(layout, FrfRole::Frequency);
    if (!frequency) return std::nullopt;
    FrfColumns columns{*frequency, 0, 0, {}, false};
    auto first = frfColumn(layout, FrfRole::Real), second = frfColumn(layout, FrfRole::Imaginary);
    columns.is_polar = !(first && second);
    if (columns.is_polar) {
        first = frfColumn(layout, FrfRole::Magnitude);
        second = frfColumn(layout, FrfRole::Phase);
    }
    if (!(first && second)) return std::nullopt;
    columns.first = *first;
    columns.second = *second;
    columns.coherence = frfColumn(layout, FrfRole::Coherence);
    return columns;
}

/// The unit of a column as written, from its heading or a row of units.
std::string unitWord(const TableColumn& column)
{
    const std::string unit = parseFrfHeading(column.heading).unit;
    return unit.empty() ? std::string(trimmed(column.unit_text)) : unit;
}

Error unitMissing(const TableLayout& layout, std::size_t column)
{
    return Error(errors::frfUnitMissing, {{"line", std::max<std::int64_t>(layout.body_line - 1, 1)},
                                          {"column", static_cast<std::int64_t>(column + 1)},
                                          {"found", excerpt(layout.columns[column].heading)},
                                          {"expected", expectedUnit}});
}

/// The unit of the values: stated by one column, or consistently by both; else the given one.
FrfUnit frfUnitOf(const TableLayout& layout, const FrfColumns& columns, const FrfOptions& options, FrfFile& file)
{
    const auto given = frfUnit(options.frf_unit);
    std::optional<FrfUnit> stated;
    std::vector<std::size_t> places{columns.first};
    if (!columns.is_polar) places.push_back(columns.second);
    for (const std::size_t k : places) {
        const std::string word = unitWord(layout.columns[k]);
        if (isUnstated(word)) continue;
        const auto unit = frfUnit(word);
        const bool isOther = stated && unit && (stated->quantity != unit->quantity || stated->scale != unit->scale);
        const bool isDecibel = lowerCase(word) == "db";
        if (isOther || isDecibel || (!unit && !given)) throw unitMissing(layout, k);
        if (unit && !stated) file.facts.unit = word;
        if (unit) stated = unit;
    }
    if (!stated && !given) throw unitMissing(layout, columns.first);
    file.facts.unit_source = stated ? "stated" : "given";
    if (!stated) file.facts.unit = frfUnitKey(options.frf_unit);
    if (stated && given && (stated->quantity != given->quantity || stated->scale != given->scale))
        file.notes.push_back({notes::frfUnitNotUsed,
                              {{"unit", file.facts.unit},
                               {"given", frfUnitKey(options.frf_unit)},
                               {"count", std::int64_t{1}},
                               {"line", std::max<std::int64_t>(layout.body_line - 1, 1)}}});
    return stated ? *stated : *given;
}

double hertz(const TableLayout& layout, std::size_t column)
{
    const auto hz = hzPerUnit(unitWord(layout.columns[column]));
    if (!hz) throw unitMissing(layout, column);
    return *hz;
}

/// Radians per unit of the phase, which must be stated.
double radians(const TableLayout& layout, std::size_t column)
{
    const auto unit = quantityUnit(unitWord(layout.columns[column]));
    if (!unit || unit->kind != QuantityUnit::Kind::Angle) throw unitMissing(layout, column);
    return unit->scale * std::numbers::pi / 180;
}

Frf toFrf(const TableLayout& layout, const FrfColumns& columns, const FrfUnit& unit, const std::vector<double>& values)
{
    Frf frf;
    frf.quantity = unit.quantity;
    const double hz = hertz(layout, columns.frequency);
    const double angle = columns.is_polar ? radians(layout, columns.second) : 0;
    const std::size_t width = columns.coherence ? 4 : 3;
    for (std::size_t at = 0; at + width <= values.size(); at += width) {
        frf.frequency_hz.push_back(values[at] * hz);
        const double a = values[at + 1] * unit.scale, b = values[at + 2];
        frf.value.emplace_back(columns.is_polar ? std::complex(a * std::cos(b * angle), a * std::sin(b * angle))
                                                : std::complex(a, b * unit.scale));
        if (columns.coherence)
            frf.coherence.push_back(std::isfinite(values[at + 3]) ? std::clamp(values[at + 3], 0.0, 1.0) : 0);
    }
    return frf;
}

TableRows readFrfValues(std::string_view text, const TableLayout& layout, const FrfColumns& columns,
                        std::vector<double>& values, const Progress& progress)
{
    std::vector<WantedColumn> wanted;
    for (const std::size_t k : {columns.frequency, columns.first, columns.second}) wanted.push_back({k});
    if (columns.coherence) wanted.push_back({*columns.coherence, std::numeric_limits<double>::infinity(), true});
    TableRows rows = readRows(
        text, layout, wanted,
        [&values, &wanted](std::size_t count) {
            values.resize(count * wanted.size());
            return values.data();
        },
        progress);
    values.resize(rows.rows * wanted.size());
    return rows;
}

}  // namespace

FrfFile readFrfTable(const std::string& name, std::string_view bytes, const ImportOptions& options,
                     const FrfOptions& frf, const Progress& progress)
{
    const DecodedText text = readableTable(name, bytes, options.encoding, expectedFrfTable, progress);
    const TableLayout layout = findLayout(text.view(), frfExpectation(), options);
    const auto columns = findFrfColumns(layout);
    if (!columns)
        throw Error(errors::columnsUnknown, {{"line", std::max<std::int64_t>(layout.body_line - 1, 1)},
                                             {"column", std::int64_t{1}},
                                             {"found", columnNames(layout)},
                                             {"expected", LT_TEXT("Engine", "frequency_hz, real_mm_N, imag_mm_N")}});
    FrfFile file;
    const FrfUnit unit = frfUnitOf(layout, *columns, frf, file);
    std::vector<double> values;
    const TableRows rows = readFrfValues(text.view(), layout, *columns, values, progress);
    describeTable(layout, rows, text.encoding(), file.facts, file.notes);
    if (rows.rows == 0) throw Error(errors::noPoints, {});
    MeasuredFrf measured{toFrf(layout, *columns, unit, values)};
    measured.frf.name = name.substr(name.find_last_of('/') + 1);
    const std::int64_t dropped = dropUnusableLines(measured.frf);  // values that overflow after conversion to mm/N
    if (dropped > 0)
        file.notes.push_back(
            {notes::frfLinesDropped, {{"lines", dropped}, {"count", std::int64_t{1}}, {"line", layout.body_line}}});
    try {
        requireAscending(measured.frf);
    } catch (Error& error) {
        const Value* index = find(error.values(), "index");
        const auto row = index ? static_cast<std::size_t>(std::get<std::int64_t>(*index)) : 0;
        throw error.with("line", lineOfRow(layout, rows, row)).with("column", std::int64_t{1});
    }
    file.facts.format = "frf_csv";
    set(file.facts.details, "points", static_cast<std::int64_t>(measured.frf.frequency_hz.size()));
    set(file.facts.details, "quantity", quantityName(unit.quantity));
    set(file.facts.details, "coherence", columns->coherence.has_value());
    set(file.facts.details, "from_hz", measured.frf.frequency_hz.front());
    set(file.facts.details, "to_hz", measured.frf.frequency_hz.back());
    std::vector<std::size_t> read{columns->frequency, columns->first, columns->second};
    if (columns->coherence) read.push_back(*columns->coherence);
    noteColumns(layout, read, file.facts, file.notes);
    finishTableNotes(layout, rows, name, file.facts, file.notes);
    file.frfs.push_back(std::move(measured));
    return file;
}

bool isFrfTable(std::string_view head, const ImportOptions& options)
{
    try {
        const DecodedText text = readableTable({}, head, options.encoding, expectedFrfTable, {});
        return findFrfColumns(findLayout(text.view(), frfExpectation(), options)).has_value();
    } catch (const Error& error) {
        return false;
    }
}

}  // namespace lathelier::io
