#include <algorithm>
#include <cmath>

#include "engine/io/file.h"
#include "engine/io/frf/frf_unit.h"
#include "engine/io/io_codes.h"
#include "engine/io/table/table_facts.h"
#include "engine/io/table/table_layout.h"
#include "engine/io/table/table_rows.h"
#include "engine/io/text/header_lines.h"
#include "engine/io/text/quantity.h"
#include "engine/io/text/readable_text.h"
#include "engine/io/text/text_lines.h"
#include "engine/io/text/units.h"
#include "engine/io/time_record/even_times.h"
#include "engine/io/time_record/time_record_codes.h"
#include "engine/io/time_record/time_record_formats.h"

namespace lathelier::io {
namespace {

constexpr Text expectedTimeTable =
    LT_TEXT("Engine", "a table of signals over time: a force and a motion, with times or a rate");

/// Letters and digits in lower case.
std::string plainWord(std::string_view name)
{
    std::string plain;
    for (const char c : lowerCase(name))
        if ((c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || static_cast<unsigned char>(c) >= 0x80) plain += c;
    return plain;
}

bool isTimeWord(const std::string& plain)
{
    return isOneOf(plain, {"t", "time", "timestamp", "zeit", "czas", "tempo", "temps", "время", "elapsed"});
}

bool isForceWord(const std::string& plain)
{
    for (const std::string_view word : {"hammer", "force", "impact", "kraft", "siła", "sila", "młotek", "mlotek"})
        if (plain.starts_with(word)) return true;
    return plain == "f";
}

bool isMotionWord(const std::string& plain)
{
    for (const std::string_view word : {"acc", "vel", "disp", "response", "sensor", "beschl", "przysp", "weg"})
        if (plain.starts_with(word)) return true;
    return plain == "a" || plain == "v";
}

std::optional<QuantityUnit> timeUnitOf(const TableColumn& column)
{
    const QuantityHeading heading = parseQuantityHeading(column.heading);
    for (const auto& unit : {heading.unit, quantityUnit(column.unit_text)})
        if (unit && unit->kind == QuantityUnit::Kind::Time) return unit;
    return std::nullopt;
}

bool isTimeColumn(const TableColumn& column)
{
    if (!column.is_number) return false;
    return timeUnitOf(column) || isTimeWord(plainWord(parseSignalHeading(column.heading).name));
}

bool isRowNumber(const TableColumn& column)
{
    const std::string plain = plainWord(column.name);
    return column.is_count && (plain.empty() || isOneOf(plain, {"i", "index", "n", "nr", "no", "sample", "row", "lp"}));
}

TableExpectation timeExpectation()
{
    TableExpectation expectation;
    expectation.minimum_columns = 2;
    expectation.knows_name = [](const std::string& name) {
        const std::string plain = plainWord(parseSignalHeading(name).name);
        return isTimeWord(plain) || isForceWord(plain) || isMotionWord(plain);
    };
    expectation.knows_unit = [](std::string_view word) { return signalUnit(word) || quantityUnit(word); };
    return expectation;
}

TimeChannel timeChannelOf(const TableLayout& layout, std::size_t k)
{
    const TableColumn& column = layout.columns[k];
    SignalHeading heading = parseSignalHeading(column.heading);
    if (!heading.unit && !trimmed(column.unit_text).empty()) {
        heading.unit = signalUnit(column.unit_text);
        heading.unit_text = trimmed(column.unit_text);
    }
    TimeChannel channel;
    channel.number = static_cast<std::int64_t>(k) + 1;
    channel.heading = column.heading;
    channel.name = heading.name;
    channel.unit = heading.unit;
    channel.unit_text = heading.unit_text;
    channel.role = roleOf(heading.name, heading.unit);
    channel.line = layout.body_line;
    return channel;
}

/// Columns of a table: that of the times, and those of signals.
struct TimeColumns {
    std::optional<std::size_t> time;
    std::vector<std::size_t> read;  ///< those of signals, and that of the times
};

TimeColumns findTimeColumns(const TableLayout& layout)
{
    TimeColumns columns;
    for (std::size_t k = 0; k < layout.columns.size(); ++k) {
        const TableColumn& column = layout.columns[k];
        if (!column.is_number) continue;
        if (!columns.time && isTimeColumn(column))
            columns.time = k;
        else if (isRowNumber(column))
            continue;
        columns.read.push_back(k);
    }
    return columns;
}

double secondsOfColumn(const TableColumn& column, const Values& header, Notes& notes)
{
    if (const auto unit = timeUnitOf(column)) return unit->scale;
    if (const std::string* word = headerWord(header, "unit_time"))
        if (const auto unit = quantityUnit(*word); unit && unit->kind == QuantityUnit::Kind::Time) return unit->scale;
    notes.push_back({notes::timeUnitAssumed, {}});
    return 1;
}

std::optional<double> rateOfHeader(const Values& header)
{
    constexpr double perKilo = 1000;
    struct Key {
        const char* key;
        double hz;
    };
    for (const Key known : {Key{"rate_hz", 1}, Key{"rate_kHz", perKilo}, Key{"sampling_rate_hz", 1},
                            Key{"sample_rate_hz", 1}, Key{"fs_hz", 1}, Key{"fs", 1}})
        if (const auto rate = headerNumber(header, known.key); rate && *rate > 0) return *rate * known.hz;
    return std::nullopt;
}

/// Rate and start of all channels, from the times. Error timeUneven.
void takeTimesOf(const std::vector<double>& times, double scale, const TableLayout& layout, const TableRows& rows,
                 std::size_t column, TimeRecord& record, const Progress& progress)
{
    const EvenTimes judged = judgeTimes(times, progress);
    if (judged.uneven)
        throw Error(errors::timeUneven, {{"line", lineOfRow(layout, rows, judged.uneven->sample)},
                                         {"column", static_cast<std::int64_t>(column) + 1},
                                         {"found_s", judged.uneven->found * scale},
                                         {"expected_s", judged.uneven->expected * scale}});
    for (TimeChannel& channel : record.channels) {
        channel.start_s = times.front() * scale;
        if (judged.step > 0) channel.rate_hz = 1 / (judged.step * scale);
    }
}

/// Reads the rows into one list for each column.
TableRows readTimeRows(std::string_view text, const TableLayout& layout, const TimeColumns& columns,
                       std::vector<std::vector<double>>& values, const Progress& progress)
{
    std::vector<WantedColumn> wanted;
    for (const std::size_t k : columns.read)
        wanted.push_back({k, std::numeric_limits<double>::infinity(), k != columns.time});
    values.resize(wanted.size());
    const auto expect = [&values](std::size_t rows) {
        for (std::vector<double>& column : values) column.reserve(rows);
    };
    const auto take = [&values](const double* row, std::size_t rows) {
        for (std::size_t i = 0; i < rows; ++i)
            for (std::vector<double>& column : values) column.push_back(*row++);
    };
    return readRows(text, layout, wanted, RowSink{expect, take, {}}, progress);
}

}  // namespace

TimeChannel::Role roleOf(const std::string& name, const std::optional<SignalUnit>& unit)
{
    if (unit && unit->kind == SignalUnit::Kind::Force) return TimeChannel::Role::Force;
    if (unit && unit->isMotion()) return TimeChannel::Role::Motion;
    const std::string plain = plainWord(name);
    if (isForceWord(plain)) return TimeChannel::Role::Force;
    return isMotionWord(plain) ? TimeChannel::Role::Motion : TimeChannel::Role::Unknown;
}

bool isTimeTable(std::string_view head, const ImportOptions& options)
{
    try {
        const DecodedText text =
            readableTable({}, head.substr(0, headForKind), options.encoding, expectedTimeTable, {});
        const TableLayout layout = findLayout(text.view(), timeExpectation(), options);
        bool has_time = false, has_force = false, has_motion = false;
        for (std::size_t k = 0; k < layout.columns.size(); ++k) {
            const TableColumn& column = layout.columns[k];
            if (!column.is_number || column.heading.empty()) continue;
            if (isTimeColumn(column)) {
                has_time = true;
                continue;
            }
            const TimeChannel channel = timeChannelOf(layout, k);
            const bool is_measured = channel.unit.has_value();
            has_force = has_force || (channel.role == TimeChannel::Role::Force &&
                                      (is_measured || plainWord(channel.name).size() > 1));
            has_motion = has_motion || (channel.role == TimeChannel::Role::Motion && is_measured);
        }
        return has_force && (has_time || has_motion);
    } catch (const Error&) {
        return false;
    }
}

TimeRecordFile readTimeTable(const std::string& name, std::string_view bytes, const ImportOptions& options,
                             const Progress& progress)
{
    const DecodedText text = readableTable(name, bytes, options.encoding, expectedTimeTable, progress);
    const TableLayout layout = findLayout(text.view(), timeExpectation(), options);
    const Values header = readHeaderLines(text.view(), layout.body_offset);
    const TimeColumns columns = findTimeColumns(layout);
    TimeRecordFile file;
    std::vector<std::vector<double>> values;
    const TableRows rows = readTimeRows(text.view(), layout, columns, values, progress);
    if (rows.rows == 0) throw Error(errors::noPoints, {});
    if (columns.read.size() < (columns.time ? 2U : 1U))
        throw Error(errors::columnsUnknown, {{"line", layout.body_line},
                                             {"column", std::int64_t{1}},
                                             {"found", LT_TEXT("Engine", "no column of signals")},
                                             {"expected", LT_TEXT("Engine", "columns such as force_N, acc_m_s2")}});
    std::size_t times = values.size();
    for (std::size_t k = 0; k < values.size(); ++k) {
        if (columns.read[k] == columns.time) {
            times = k;
            continue;
        }
        TimeChannel& channel = file.record.channels.emplace_back(timeChannelOf(layout, columns.read[k]));
        channel.values = std::move(values[k]);
        const auto missing = std::find_if_not(channel.values.begin(), channel.values.end(),
                                              [](double value) { return std::isfinite(value); });
        if (missing != channel.values.end())
            channel.missing_line = lineOfRow(layout, rows, static_cast<std::size_t>(missing - channel.values.begin()));
        channel.rate_hz = rateOfHeader(header);
    }
    describeTable(layout, rows, text.encoding(), file.facts, file.notes);
    if (columns.time) {
        const double scale = secondsOfColumn(layout.columns[*columns.time], header, file.notes);
        takeTimesOf(values[times], scale, layout, rows, *columns.time, file.record, progress);
    }
    file.facts.format = "time_csv";
    if (const std::string* word = headerWord(header, "synthetic"); word && *word != "false")
        file.notes.push_back({notes::syntheticData, {}});
    noteColumns(layout, columns.read, file.facts, file.notes);
    finishTableNotes(layout, rows, name, file.facts, file.notes);
    return file;
}

}  // namespace lathelier::io
