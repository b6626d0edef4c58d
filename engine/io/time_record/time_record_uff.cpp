#include <cmath>

#include "engine/io/frf/frf_unit.h"
#include "engine/io/frf/uff.h"
#include "engine/io/frf/uff_frf.h"
#include "engine/io/io_codes.h"
#include "engine/io/text/number.h"
#include "engine/io/text/text_lines.h"
#include "engine/io/time_record/even_times.h"
#include "engine/io/time_record/time_record_codes.h"
#include "engine/io/time_record/time_record_formats.h"

namespace lathelier::io {
namespace {

constexpr std::int64_t timeFunction = 1;
constexpr double mm_per_m = 1000;

std::optional<SignalUnit::Kind> kindOfOrdinate(std::int64_t type)
{
    using Of = SignalUnit::Kind;
    switch (type) {
        case 8: return Of::Displacement;
        case 9:
        case 13: return Of::Force;
        case 11: return Of::Velocity;
        case 12: return Of::Acceleration;
        default: return std::nullopt;
    }
}

/// The unit stated, else that of a set 164 and the kind of ordinate.
std::optional<SignalUnit> unitOfOrdinate(const UffFunction& function)
{
    if (!isUnstated(function.ordinate.unit)) return signalUnit(function.ordinate.unit);
    const auto kind = kindOfOrdinate(function.ordinate.type);
    if (!function.units || !kind) return std::nullopt;
    if (*kind == SignalUnit::Kind::Force) return SignalUnit{*kind, 1 / function.units->force_per_newton};
    return SignalUnit{*kind, mm_per_m / function.units->length_per_metre};
}

bool isTimeResponse(const UffSet& set)
{
    return set.function && set.function->function == timeFunction && !set.function->isComplex() &&
           set.function->x.size() > 1;
}

/// The times in seconds: "s" or no unit, "ms".
double secondsPerUnit(const UffSet& set)
{
    const std::string& unit = set.function->abscissa.unit;
    const auto known = physicalUnit(unit);
    if (known && known->time == 1 && known->length == 0 && known->force == 0) return known->scale;
    if (isUnstated(unit)) return 1;
    throw Error(errors::malformed, {{"line", set.line},
                                    {"column", std::int64_t{1}},
                                    {"found", unit},
                                    {"expected", LT_TEXT("Engine", "a unit of time: s or ms")}});
}

TimeChannel uffChannelOf(const UffSet& set, std::int64_t number, const Progress& progress)
{
    const UffFunction& function = *set.function;
    TimeChannel channel;
    channel.number = number;
    channel.line = set.line;
    channel.name = isUnstated(function.ordinate.label) ? std::string() : function.ordinate.label;
    if (channel.name.empty() && !isUnstated(function.id[0])) channel.name = function.id[0];
    channel.unit = unitOfOrdinate(function);
    channel.unit_text = isUnstated(function.ordinate.unit) ? std::string() : function.ordinate.unit;
    channel.role = roleOf(channel.name, channel.unit);
    if (const auto kind = kindOfOrdinate(function.ordinate.type); channel.role == TimeChannel::Role::Unknown && kind)
        channel.role = *kind == SignalUnit::Kind::Force ? TimeChannel::Role::Force : TimeChannel::Role::Motion;
    channel.node = static_cast<int>(function.response_node);
    channel.direction = static_cast<int>(std::min<std::int64_t>(std::abs(function.response_direction), 6));
    const double scale = secondsPerUnit(set);
    const EvenTimes times = judgeTimes(function.x, progress);
    if (times.uneven)
        throw Error(errors::timeUneven, {{"line", set.line},
                                         {"column", std::int64_t{1}},
                                         {"sample", static_cast<std::int64_t>(times.uneven->sample) + 1},
                                         {"found_s", times.uneven->found * scale},
                                         {"expected_s", times.uneven->expected * scale}});
    channel.rate_hz = 1 / (times.step * scale);
    channel.start_s = function.x.front() * scale;
    const double sign = function.response_direction < 0 ? -1 : 1;
    channel.values.reserve(function.y.size());
    for (const std::complex<double>& y : function.y) {
        if (!std::isfinite(y.real()) && channel.missing_line == 0) channel.missing_line = set.line;
        channel.values.push_back(sign * y.real());
    }
    return channel;
}

std::string typesOf(const UffFile& file)
{
    constexpr std::size_t longest = 60;
    std::string found;
    for (const UffSet& set : file.sets) {
        if (found.size() > longest) return found + " …";
        found += (found.empty() ? "" : ", ") + set.type;
        if (set.function) found += ":" + std::to_string(set.function->function);
    }
    return found;
}

}  // namespace

bool isTimeUff(std::string_view head)
{
    if (!isUff(head)) return false;
    Lines lines(head);
    try {
        while (lines.next()) {
            const std::string_view type =
                trimmed(lines.line().substr(0, std::min<std::size_t>(lines.line().size(), 7)));
            if (type != "58" && type != "58b") continue;
            constexpr int linesToFunction = 6;
            for (int k = 0; k < linesToFunction; ++k)
                if (!lines.next()) return false;
            const std::string_view number =
                trimmed(lines.line().substr(0, std::min<std::size_t>(lines.line().size(), 5)));
            return wholeInteger(number) == timeFunction;
        }
    } catch (const Error&) {
        return false;
    }
    return false;
}

TimeRecordFile readTimeUff(std::string_view bytes, const Progress& progress)
{
    UffFile uff = readUff(bytes, progress.part(0, 0.8));
    TimeRecordFile file;
    file.notes = std::move(uff.notes);
    file.facts.format = "UFF";
    if (uff.units) {
        file.facts.unit = uff.units->description;
        file.facts.unit_source = "stated";
    }
    Rows sets;
    std::int64_t skipped = 0, first_skipped = 0;
    for (const UffSet& set : uff.sets) {
        sets.rows.push_back(uffFacts(set));
        if (isTimeResponse(set))
            file.record.channels.push_back(
                uffChannelOf(set, static_cast<std::int64_t>(file.record.channels.size()) + 1, progress));
        else if (set.function && skipped++ == 0)
            first_skipped = set.line;
    }
    if (file.record.channels.empty())
        throw Error(errors::timeRecordNone, {{"line", uff.sets.front().line},
                                             {"column", std::int64_t{1}},
                                             {"found", typesOf(uff)},
                                             {"expected", LT_TEXT("Engine", "data sets 58 of function 1")}});
    if (skipped > 0) file.notes.push_back({notes::timeSetsSkipped, {{"count", skipped}, {"line", first_skipped}}});
    set(file.facts.details, "datasets", std::move(sets));
    if (!uff.nodes.empty()) set(file.facts.details, "nodes", static_cast<std::int64_t>(uff.nodes.size()));
    return file;
}

}  // namespace lathelier::io
