// A continuous recording out of a table: channels, times, rate.
#include <algorithm>
#include <cmath>

#include "engine/core/parallel.h"
#include "engine/core/statistics.h"
#include "engine/io/io_codes.h"
#include "engine/io/probe/probe_table.h"
#include "engine/io/table/table_facts.h"
#include "engine/io/text/header_lines.h"

namespace lathelier::io {
namespace {

using Kind = QuantityUnit::Kind;
using Role = ProbeColumn::Role;

constexpr std::size_t rowsPerTask = 1 << 13;  ///< rows per task, which fit into the cache
constexpr double irregularShare = 0.1;        ///< deviation of a time step, relative, that makes times uneven

/// Unit and factor of a channel. Millimetres are kept; other lengths are converted to µm.
void applyUnit(const std::optional<QuantityUnit>& unit, ProbeChannel& channel, double& scale)
{
    if (!unit) return;
    switch (unit->kind) {
        case Kind::Length:
            channel.unit = unit->key == "mm" ? ProbeChannel::Unit::Millimetre : ProbeChannel::Unit::Micrometre;
            scale = unit->key == "mm" || unit->key == "um" ? 1 : unit->scale * 1000;
            return;
        case Kind::Voltage: channel.unit = ProbeChannel::Unit::Volt; break;
        case Kind::Angle: channel.unit = ProbeChannel::Unit::Degree; break;
        case Kind::Time: return;
    }
    scale = unit->scale;
}

bool isDisplacement(const ProbeColumn& column)
{
    const std::string plain = plainName(column.name);
    return plain == "x3" || plain == "y3" || plain == "xp" || plain == "yp" || plain == "x" || plain == "y";
}

/// A column being converted to a channel.
struct InputValue {
    double scale = 1;
    ProbeChannel channel;
};

InputValue startChannel(ProbeTable& table, std::size_t k, Notes& notes)
{
    const ProbeColumn& column = table.column(k);
    InputValue taken;
    ProbeChannel& channel = taken.channel;
    channel.name = column.name.empty() ? "channel " + std::to_string(table.read[k] + 1) : column.name;
    std::optional<QuantityUnit> unit = column.unit;
    if (!unit && column.role == Role::Angle && column.unit_text.empty()) unit = QuantityUnit{Kind::Angle, "deg", 1};
    if (!unit && isDisplacement(column)) unit = displacementUnit(table);
    applyUnit(unit, channel, taken.scale);
    if (channel.unit == ProbeChannel::Unit::Unknown)
        notes.push_back({notes::channelUnitUnknown, {{"channel", channel.name}}});
    channel.values = std::move(table.values[k]);
    return taken;
}

/// Converts the channels to their units and notes missing values.
void scaleChannels(std::vector<InputValue>& channels, Notes& notes, const Progress& progress)
{
    for (InputValue& taken : channels) {
        std::vector<double>& values = taken.channel.values;
        const std::int64_t missing = parallelReduce(
            values.size(), rowsPerTask, progress, std::int64_t{0},
            [&](std::size_t begin, std::size_t end) {
                std::int64_t count = 0;
                for (std::size_t i = begin; i < end; ++i) {
                    values[i] *= taken.scale;
                    count += std::isnan(values[i]) ? 1 : 0;
                }
                return count;
            },
            [](std::int64_t sum, std::int64_t count) { return sum + count; });
        if (missing > 0)
            notes.push_back({notes::samplesMissing, {{"count", missing}, {"channel", taken.channel.name}}});
    }
}

/// Seconds per unit of the column of times: its heading's, the header's `unit_time`, else 1 with a note.
double timeScale(const ProbeTable& table, std::size_t k, Notes& notes)
{
    if (const auto& unit = table.column(k).unit; unit && unit->kind == Kind::Time) return unit->scale;
    if (const std::string* word = headerWord(table.header, "unit_time"))
        if (const auto unit = quantityUnit(*word); unit && unit->kind == Kind::Time) return unit->scale;
    notes.push_back({notes::timeUnitAssumed, {}});
    return 1;
}

/// The power of ten that the times are written in, found from the first of them.
double resolutionOf(const std::vector<double>& times)
{
    const std::size_t count = std::min<std::size_t>(times.size(), 1000);
    double resolution = 1;
    for (int digits = 0; digits < 12; ++digits, resolution /= 10) {
        bool fits = true;
        for (std::size_t i = 0; i < count && fits; ++i) {
            const double steps = times[i] / resolution;
            fits = std::abs(steps - std::round(steps)) < 1e-4 + std::abs(steps) * 1e-14;
        }
        if (fits) return resolution;
    }
    return resolution;
}

/// The median of at most a million of the steps between times.
double medianStep(const std::vector<double>& times)
{
    const std::size_t stride = (times.size() - 1) / 1'000'000 + 1;
    std::vector<double> some;
    for (std::size_t i = 1; i < times.size(); i += stride) some.push_back(times[i] - times[i - 1]);
    return upperMedianInPlace(some);
}

/// Sets times and rate from column `k`.
void takeTimes(ProbeTable& table, std::size_t k, ProbeRecord& record, Notes& notes, const Progress& progress)
{
    const std::size_t count = table.rows.rows;
    const double scale = timeScale(table, k, notes);
    if (count < 2) return;
    std::vector<double>& written = table.values[k];
    const double mean = (written.back() - written.front()) / static_cast<double>(count - 1);
    const double resolution = resolutionOf(written);
    double farthest = 0;
    const auto step = [&written](std::size_t i) { return written[i] - written[i - 1]; };
    for (std::size_t i = 1; i < count; ++i) {
        if (i % rowsPerTask == 0) progress.check();
        if (step(i) < 0) throw malformedRow(table, i, k, LT_TEXT("Engine", "a later time than in the row before"));
        farthest = std::max(farthest, std::abs(written[i] - (written.front() + static_cast<double>(i) * mean)));
    }
    const double period = medianStep(written);
    const double rounding = 1e-6 * period + 1e-15 * std::abs(written.back());
    std::size_t equal = 0;
    for (std::size_t i = 1; i < count; ++i) equal += std::abs(step(i) - period) <= rounding ? 1U : 0U;
    const bool areExact = static_cast<double>(equal) >= 0.9 * static_cast<double>(count - 1);
    // Times rounded to more than a tenth of a step are less accurate than their mean rate.
    const bool isCoarse = !areExact && resolution > irregularShare * mean && farthest <= 1.01 * resolution && mean > 0;
    if (isCoarse) {
        record.rate_hz = 1 / (mean * scale);
        notes.push_back({notes::timeCoarse, {{"rate_hz", record.rate_hz}}});
        return;
    }
    const double tolerance = irregularShare * period + (areExact ? 0 : resolution);
    std::int64_t irregular = 0;
    std::size_t first = 0;
    for (std::size_t i = 1; i < count; ++i) {
        if (step(i) == 0) throw malformedRow(table, i, k, LT_TEXT("Engine", "a later time than in the row before"));
        if (std::abs(step(i) - period) <= tolerance) continue;
        if (irregular++ == 0) first = i;
    }
    record.rate_hz = 1 / ((irregular == 0 ? mean : period) * scale);
    if (irregular > 0)
        notes.push_back(
            {notes::timeIrregular,
             {{"count", irregular}, {"step_s", period * scale}, {"line", lineOfRow(table.layout, table.rows, first)}}});
    record.time_s = std::move(written);
    for (double& time : record.time_s) time *= scale;
}

/// The rate that the header states, for a record without times.
void takeStatedRate(ProbeRecord& record, Notes& notes)
{
    struct Key {
        const char* key;
        double hz;
    };
    for (const Key known : {Key{"rate_hz", 1}, Key{"rate_kHz", 1000}, Key{"sampling_rate_hz", 1},
                            Key{"sample_rate_hz", 1}, Key{"fs_hz", 1}, Key{"fs", 1}})
        if (const auto rate = headerNumber(record.header, known.key); rate && *rate > 0) {
            record.rate_hz = *rate * known.hz;
            return;
        }
    notes.push_back({notes::rateUnknown, {}});
}

}  // namespace

ProbeRecord toRawRecord(ProbeTable& table, Notes& notes, const Progress& progress)
{
    ProbeRecord record;
    record.name = table.name.substr(table.name.find_last_of('/') + 1);
    record.header = table.header;
    bool hasTimes = false;
    std::vector<InputValue> channels;
    for (std::size_t k = 0; k < table.width(); ++k) {
        progress.check();
        if (table.column(k).role == Role::Time && !hasTimes) {
            takeTimes(table, k, record, notes, progress);
            hasTimes = true;
        } else {
            channels.push_back(startChannel(table, k, notes));
        }
    }
    if (channels.empty())
        throw Error(errors::columnsUnknown, {{"line", table.layout.body_line},
                                             {"column", std::int64_t{1}},
                                             {"found", LT_TEXT("Engine", "no column of signals")},
                                             {"expected", LT_TEXT("Engine", "channels such as marker_V, X3_um")}});
    scaleChannels(channels, notes, progress);
    for (InputValue& taken : channels) record.channels.push_back(std::move(taken.channel));
    if (!hasTimes) takeStatedRate(record, notes);
    if (const auto skew = headerNumber(record.header, "channel_skew_s"); skew && *skew >= 0)
        record.channel_skew_s = *skew;
    for (const char* key : {"recorded", "date"})
        if (const std::string* word = headerWord(record.header, key); word && record.recorded.empty())
            record.recorded = *word;
    if (const std::string* word = headerWord(record.header, "device")) record.device = *word;
    return record;
}

}  // namespace lathelier::io
