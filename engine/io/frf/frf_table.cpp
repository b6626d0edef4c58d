#include "engine/io/frf/frf_table.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/io/frf/frf_codes.h"
#include "engine/io/frf/frf_columns.h"
#include "engine/io/frf/frf_lines.h"
#include "engine/io/frf/frf_text.h"
#include "engine/io/io_codes.h"
#include "engine/io/table/column_names.h"
#include "engine/io/table/table_facts.h"
#include "engine/io/table/table_layout.h"
#include "engine/io/table/table_rows.h"
#include "engine/io/text/encoding.h"
#include "engine/io/text/quantity.h"
#include "engine/io/text/readable_text.h"
#include "engine/io/text/text_lines.h"

namespace lathelier::io {
namespace {

constexpr Text expectedFrfTable =
    LT_TEXT("Engine", "a table of a frequency response: frequency, real and imaginary part");
constexpr Text expectedUnit =
    LT_TEXT("Engine", "headings such as real_mm_N and imag_mm_N, magnitude_dB_re_1_mm_N, phase_deg");
constexpr Text expectedColumns =
    LT_TEXT("Engine",
            "headings such as frequency_hz, real_mm_N, imag_mm_N; without them state --frf-columns and "
            "--frf-unit");

Error refused(const ErrorCode& code, const TableLayout& layout, std::size_t column, Text expected)
{
    const std::string& heading = layout.columns[column].heading;
    return Error(code, {{"line", std::max<std::int64_t>(layout.body_line - 1, 1)},
                        {"column", static_cast<std::int64_t>(column + 1)},
                        {"found", heading.empty() ? std::to_string(column + 1) : excerpt(heading)},
                        {"expected", expected}});
}

void noteNotUsed(const TableLayout& layout, const std::string& stated, const std::string& given, Notes& notes)
{
    notes.push_back({notes::frfUnitNotUsed,
                     {{"unit", stated},
                      {"given", given},
                      {"count", std::int64_t{1}},
                      {"line", std::max<std::int64_t>(layout.body_line - 1, 1)}}});
}

Error unitMissing(const TableLayout& layout, std::size_t column)
{
    return refused(errors::frfUnitMissing, layout, column, expectedUnit);
}

/// The stated unit of a column of values; none: not stated. Error frfUnitMissing for another word, unless a unit is
/// given.
std::optional<FrfUnit> unitStatedBy(const TableLayout& layout, std::size_t column, const FrfColumns& columns,
                                    bool is_given)
{
    std::string word = unitWord(layout.columns[column]);
    double reference = 1;
    const auto level = decibelUnit(word);
    if (level) word = level->unit, reference = level->reference;
    if (isUnstated(word)) return std::nullopt;
    auto unit = frfUnit(word);
    if (!unit && !is_given) throw unitMissing(layout, column);
    if (unit && columns.form == FrfColumns::Form::Level) unit->scale *= reference;
    return unit;
}

bool differs(const FrfUnit& a, const FrfUnit& b)
{
    return a.quantity != b.quantity || a.scale != b.scale;
}

/// The unit of the values: stated by one column, or consistently by both; else the given one.
FrfUnit frfUnitOf(const TableLayout& layout, const FrfColumns& columns, const FrfOptions& options, FrfFile& file)
{
    const auto given = frfUnit(options.frf_unit);
    std::optional<FrfUnit> stated;
    std::vector<std::size_t> places{columns.first};
    if (columns.form == FrfColumns::Form::Parts) places.push_back(columns.second);
    for (const std::size_t k : places) {
        const auto unit = unitStatedBy(layout, k, columns, given.has_value());
        if (unit && stated && differs(*stated, *unit)) throw unitMissing(layout, k);
        if (unit && !stated) file.facts.unit = unitWord(layout.columns[k]);
        if (unit) stated = unit;
    }
    if (!stated && !given) throw unitMissing(layout, columns.first);
    file.facts.unit_source = stated ? "stated" : "given";
    if (!stated) file.facts.unit = frfUnitKey(options.frf_unit);
    if (stated && given && differs(*stated, *given))
        noteNotUsed(layout, file.facts.unit, frfUnitKey(options.frf_unit), file.notes);
    return stated ? *stated : *given;
}

/// Hz per unit of the frequency: stated, else given; else Hz, but for what is named as an angular frequency.
double hertz(const TableLayout& layout, std::size_t column, const FrfOptions& options, Notes& notes)
{
    const std::string word = unitWord(layout.columns[column]);
    const auto given = hzPerUnit(options.frequency_unit);
    if (isUnstated(word)) {
        if (given) return *given;
        if (parseFrfHeading(layout.columns[column].heading).is_angular)
            throw refused(errors::frequencyUnitMissing, layout, column, {});
        return 1;
    }
    const auto stated = hzPerUnit(word);
    if (!stated && !given)
        throw refused(errors::frfUnitUnknown, layout, column, LT_TEXT("Engine", "a unit of frequency such as Hz"));
    if (stated && given && *stated != *given)
        noteNotUsed(layout, word, frequencyUnitKey(options.frequency_unit), notes);
    return stated ? *stated : *given;
}

/// Radians per unit of the phase, which must be stated.
double radians(const TableLayout& layout, const FrfColumns& columns)
{
    const auto unit = quantityUnit(unitWord(layout.columns[columns.second]));
    if (unit && unit->kind == QuantityUnit::Kind::Angle) return unit->scale * std::numbers::pi / 180;
    if (!columns.phase_rad) throw unitMissing(layout, columns.second);
    return *columns.phase_rad;
}

/// What turns the numbers of a row into a line of a response.
struct RowMeaning {
    FrfColumns::Form form = FrfColumns::Form::Parts;
    FrfUnit unit;
    double hz = 1;     ///< per unit of the frequency
    double angle = 1;  ///< radians per unit of the phase
    bool has_coherence = false;
};

std::complex<double> responseValue(const RowMeaning& meaning, double a, double b)
{
    if (meaning.form == FrfColumns::Form::Parts) return {a * meaning.unit.scale, b * meaning.unit.scale};
    const double size = meaning.unit.scale * (meaning.form == FrfColumns::Form::Level ? std::pow(10, a / 20) : a);
    return {size * std::cos(b * meaning.angle), size * std::sin(b * meaning.angle)};
}

Frf toFrf(const RowMeaning& meaning, const std::vector<double>& values)
{
    Frf frf;
    frf.quantity = meaning.unit.quantity;
    const std::size_t width = meaning.has_coherence ? 4 : 3;
    for (std::size_t at = 0; at + width <= values.size(); at += width) {
        frf.frequency_hz.push_back(values[at] * meaning.hz);
        frf.value.push_back(responseValue(meaning, values[at + 1], values[at + 2]));
        if (meaning.has_coherence)
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

/// Drops lines that are not finite, and requires the others to ascend.
void checkLines(Frf& frf, const TableLayout& layout, const TableRows& rows, Notes& notes)
{
    const std::int64_t dropped = dropUnusableLines(frf);  // values that overflow after conversion to mm/N
    if (dropped > 0)
        notes.push_back(
            {notes::frfLinesDropped, {{"lines", dropped}, {"count", std::int64_t{1}}, {"line", layout.body_line}}});
    try {
        requireAscending(frf);
    } catch (Error& error) {
        const Value* index = find(error.values(), "index");
        const auto row = index ? static_cast<std::size_t>(std::get<std::int64_t>(*index)) : 0;
        throw error.with("line", lineOfRow(layout, rows, row)).with("column", std::int64_t{1});
    }
}

void describe(const Frf& frf, const FrfText& text, FileFacts& facts)
{
    facts.format = text.isCutPro() ? "frf_cutpro" : "frf_csv";
    set(facts.details, "points", static_cast<std::int64_t>(frf.frequency_hz.size()));
    set(facts.details, "quantity", quantityName(frf.quantity));
    set(facts.details, "coherence", !frf.coherence.empty());
    set(facts.details, "from_hz", frf.frequency_hz.front());
    set(facts.details, "to_hz", frf.frequency_hz.back());
}

/// The layout of the rows, with the names behind the first one.
TableLayout frfLayout(const FrfText& text, const ImportOptions& options)
{
    TableLayout layout = findLayout(text.view(), frfExpectation(), options);
    text.name(layout);
    return layout;
}

}  // namespace

FrfFile readFrfTable(const std::string& name, std::string_view bytes, const ImportOptions& options,
                     const FrfOptions& frf, const Progress& progress)
{
    const DecodedText decoded = readableTable(name, bytes, options.encoding, expectedFrfTable, progress);
    const FrfText text(decoded.view(), options, progress);
    const TableLayout layout = frfLayout(text, options);
    const auto columns = findFrfColumns(layout, frf.frf_columns);
    if (!columns)
        throw Error(errors::columnsUnknown, {{"line", std::max<std::int64_t>(layout.body_line - 1, 1)},
                                             {"column", std::int64_t{1}},
                                             {"found", columnNames(layout)},
                                             {"expected", expectedColumns}});
    FrfFile file;
    RowMeaning meaning{columns->form, frfUnitOf(layout, *columns, frf, file)};
    meaning.hz = hertz(layout, columns->frequency, frf, file.notes);
    if (columns->form != FrfColumns::Form::Parts) meaning.angle = radians(layout, *columns);
    meaning.has_coherence = columns->coherence.has_value();
    std::vector<double> values;
    const TableRows rows = readFrfValues(text.view(), layout, *columns, values, progress);
    describeTable(layout, rows, decoded.encoding(), file.facts, file.notes);
    if (rows.rows == 0) throw Error(errors::noPoints, {});
    MeasuredFrf measured{toFrf(meaning, values)};
    measured.frf.name = name.substr(name.find_last_of('/') + 1);
    checkLines(measured.frf, layout, rows, file.notes);
    describe(measured.frf, text, file.facts);
    noteColumns(layout, columns->all(), file.facts, file.notes);
    finishTableNotes(layout, rows, name, file.facts, file.notes);
    file.frfs.push_back(std::move(measured));
    return file;
}

bool isFrfTable(std::string_view head, const ImportOptions& options, const FrfOptions& frf)
{
    try {
        const DecodedText decoded = readableTable({}, head, options.encoding, expectedFrfTable, {});
        const FrfText text(decoded.view(), options, {});
        const TableLayout layout = frfLayout(text, options);
        // Complex numbers are those of a response, and so is a table whose columns are stated as such.
        return text.isComplex() || !frf.frf_columns.empty() || findFrfColumns(layout, {}).has_value();
    } catch (const Error& error) {
        return false;
    }
}

}  // namespace lathelier::io
