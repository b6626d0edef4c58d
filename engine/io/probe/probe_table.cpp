// Reading a probe record from a table: its shape, and the common part of all shapes.
#include "engine/io/probe/probe_table.h"
#include "engine/core/parallel.h"

#include <algorithm>
#include <cmath>

#include "engine/core/texts.h"
#include "engine/io/io_codes.h"
#include "engine/io/table/table_facts.h"
#include "engine/io/text/header_lines.h"
#include "engine/io/text/readable_text.h"

namespace lathelier::io {
namespace {

using Role = ProbeColumn::Role;

constexpr Text expectedRecord = LT_TEXT("Engine", "a probe record as text");

bool isAveraged(const std::vector<ProbeColumn>& columns)
{
    const auto has = [&columns](Role role) {
        return std::any_of(columns.begin(), columns.end(), [role](const ProbeColumn& c) { return c.role == role; });
    };
    return has(Role::Section) && has(Role::Angle) && !has(Role::Time);
}

/// Column names specific to clouds or profiles.
bool isForeignTable(const std::vector<ProbeColumn>& columns)
{
    std::size_t axes = 0;
    std::size_t signals = 0;
    for (const ProbeColumn& column : columns) {
        const std::string plain = plainName(column.name);
        const bool isAxis = plain == "x" || plain == "y" || plain == "z" || plain == "r" || plain == "radius" ||
                            plain == "nx" || plain == "ny" || plain == "nz";
        axes += isAxis ? 1 : 0;
        signals += !isAxis && column.role == Role::Signal ? 1 : 0;
    }
    const bool hasTime =
        std::any_of(columns.begin(), columns.end(), [](const ProbeColumn& c) { return c.role == Role::Time; });
    return axes >= 1 && signals == 0 && !hasTime;
}

[[noreturn]] void throwNoRecord(const TableLayout& layout, Text found)
{
    throw Error(
        errors::formatUnknown,
        {{"line", layout.body_line}, {"column", std::int64_t{1}}, {"found", found}, {"expected", expectedRecord}});
}

void readRecordValues(std::string_view text, bool averaged, const std::function<void(std::size_t)>& parsed,
                      const Progress& progress, ProbeTable& table)
{
    std::vector<WantedColumn> wanted;
    for (std::size_t k = 0; k < table.columns.size(); ++k) {
        const Role role = table.columns[k].role;
        if (role == Role::Text || (!averaged && role == Role::Index)) continue;
        table.read.push_back(k);
        // A missing sample becomes NaN in its channel; a row without time or section is skipped.
        const bool mayBeMissing = !averaged && role != Role::Time;
        wanted.push_back({k, std::numeric_limits<double>::infinity(), mayBeMissing});
    }
    table.values.resize(table.width());
    // Memory for all values at once, untouched until filled: growth would need twice the memory.
    const auto expect = [&table](std::size_t rows) {
        for (std::vector<double>& column : table.values) column.reserve(rows);
    };
    const auto take = [&table, width = table.width()](const double* values, std::size_t rows) {
        parallelFor(width, 1, {}, [&](std::size_t begin, std::size_t end) {
            for (std::size_t k = begin; k < end; ++k)
                for (std::size_t i = 0; i < rows; ++i) table.values[k].push_back(values[i * width + k]);
        });
    };
    table.rows = readRows(text, table.layout, wanted, RowSink{expect, take, parsed}, progress);
}

std::string channelList(const ProbeRecord& record)
{
    std::string list;
    for (const ProbeChannel& channel : record.channels) {
        if (list.size() > 500) return list + ", …";
        list += (list.empty() ? "" : ", ") + channel.name;
        switch (channel.unit) {
            case ProbeChannel::Unit::Micrometre: list += " (µm)"; break;
            case ProbeChannel::Unit::Millimetre: list += " (mm)"; break;
            case ProbeChannel::Unit::Volt: list += " (V)"; break;
            case ProbeChannel::Unit::Degree: list += " (°)"; break;
            case ProbeChannel::Unit::Unknown: break;
        }
    }
    return list;
}

ProbeFile readRecordTable(const std::string& name, const DecodedText& text, const ImportOptions& options,
                          const std::function<void(std::size_t)>& parsed, const Progress& progress)
{
    ProbeFile file;
    ProbeTable table{name, findLayout(text.view(), probeExpectation(), options), {}, {}, {}, {}, {}, options};
    table.header = readHeaderLines(text.view(), table.layout.body_offset);
    table.columns = findProbeColumns(table.layout);
    const bool averaged = isAveraged(table.columns);
    if (!hasProbeNames(table.layout) && isForeignTable(table.columns))
        throwNoRecord(table.layout, LT_TEXT("Engine", "coordinates"));
    readRecordValues(text.view(), averaged, parsed, progress.part(0, 0.8, LT_TEXT("Engine", "Reading")), table);
    if (table.rows.rows == 0) throw Error(errors::noPoints, {});
    describeTable(table.layout, table.rows, text.encoding(), file.facts, file.notes);
    const auto rows = static_cast<std::int64_t>(table.rows.rows);
    if (averaged) {
        AveragedRecord record = toAveragedRecord(table, progress);
        file.facts.format = "probe_csv_averaged";
        file.facts.unit = "um";
        const bool isStated = statedDisplacementUnit(table) ||
                              std::any_of(table.columns.begin(), table.columns.end(),
                                          [](const ProbeColumn& c) { return plainName(c.name) == "x3" && c.unit; });
        file.facts.unit_source = isStated ? "stated" : "given";
        set(file.facts.details, "sections", static_cast<std::int64_t>(record.sections.size()));
        set(file.facts.details, "angles", rows / static_cast<std::int64_t>(record.sections.size()));
        file.record = std::move(record);
    } else {
        ProbeRecord record = toRawRecord(table, file.notes, progress.part(0.8, 1));
        file.facts.format = "probe_csv_raw";
        set(file.facts.details, "channels", static_cast<std::int64_t>(record.channels.size()));
        set(file.facts.details, "channel_names", channelList(record));
        set(file.facts.details, "frames", rows);
        if (std::isfinite(record.rate_hz)) {
            set(file.facts.details, "rate_kHz", record.rate_hz / 1000);
            set(file.facts.details, "duration_s", static_cast<double>(rows) / record.rate_hz);
        }
        if (record.channel_skew_s) set(file.facts.details, "channel_skew_us", *record.channel_skew_s * 1e6);
        file.record = std::move(record);
    }
    if (const std::string* word = headerWord(table.header, "synthetic"); word && *word != "false")
        file.notes.push_back({notes::syntheticData, {}});
    noteColumns(table.layout, table.read, file.facts, file.notes);
    finishTableNotes(table.layout, table.rows, name, file.facts, file.notes);
    progress.report(1);
    return file;
}

}  // namespace

std::optional<QuantityUnit> statedDisplacementUnit(const ProbeTable& table)
{
    for (const char* key : {"unit_disp", "unit_displacement", "unit"})
        if (const std::string* word = headerWord(table.header, key))
            if (auto unit = quantityUnit(*word)) return unit;
    if (table.layout.unit)
        return QuantityUnit{QuantityUnit::Kind::Length, table.layout.unit->key, table.layout.unit->mm};
    return std::nullopt;
}

std::optional<QuantityUnit> displacementUnit(const ProbeTable& table)
{
    if (auto stated = statedDisplacementUnit(table)) return stated;
    if (const auto given = lengthScale(table.options.unit))
        return QuantityUnit{QuantityUnit::Kind::Length, given->key, given->mm};
    return std::nullopt;
}

Error malformedRow(const ProbeTable& table, std::size_t row, std::size_t k, Text expected)
{
    return Error(errors::malformed, {{"line", lineOfRow(table.layout, table.rows, row)},
                                     {"column", static_cast<std::int64_t>(table.read[k]) + 1},
                                     {"found", text(Value(table.at(row, k)))},
                                     {"expected", expected}});
}

ProbeFile readProbeTable(const std::string& name, std::string_view bytes, const ImportOptions& options,
                         const Progress& progress, const std::function<void(std::size_t)>& parsed)
{
    try {
        const DecodedText text = readableTable(name, bytes, options.encoding, expectedRecord, progress);
        // If the text is the file itself, its parsed part can be released.
        const char* const begin = text.view().data();
        const bool isFile = begin >= bytes.data() && begin < bytes.data() + bytes.size();
        const std::size_t mark = isFile ? static_cast<std::size_t>(begin - bytes.data()) : 0;
        const auto inFile = [&](std::size_t offset) { parsed(mark + offset); };
        return readRecordTable(name, text, options, parsed && isFile ? inFile : std::function<void(std::size_t)>(),
                               progress);
    } catch (Error& error) {
        error.with("path", name);
        throw;
    }
}

bool isProbeTable(std::string_view bytes, const ImportOptions& options)
{
    try {
        const DecodedText text = readableTable({}, bytes.substr(0, headForKind), options.encoding, expectedRecord, {});
        return hasProbeNames(findLayout(text.view(), probeExpectation(), options));
    } catch (const Error&) {
        return false;
    }
}

}  // namespace lathelier::io
