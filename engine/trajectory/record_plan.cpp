#include "engine/trajectory/record_plan.h"

#include <algorithm>
#include <cmath>

#include "engine/io/text/header_lines.h"
#include "engine/trajectory/trajectory_codes.h"

namespace lathelier::trajectory {
namespace {

/// Note where the stated speed differs from that of the marks: two marks per revolution, or a wrong time base.
void noteSpeed(const PreparedRecord& prepared, const std::string& path, Notes& notes)
{
    constexpr double tolerance = 0.1;
    const auto stated = io::headerNumber(prepared.record->header, "rpm_nominal");
    const auto speed = stated ? stated : io::headerNumber(prepared.record->header, "speed_rpm");
    if (!speed || !prepared.clock.isKnown()) return;
    const double found_rpm = 60 / prepared.revolutions.period_s;
    if (std::abs(found_rpm - *speed) > tolerance * *speed)
        notes.push_back({notes::speedDiffers, {{"path", path}, {"found_rpm", found_rpm}, {"stated_rpm", *speed}}});
}

}  // namespace

PreparedRecord prepare(const io::ProbeRecord& record, const std::string& path, const TrajectoryParameters& parameters,
                       Notes& notes)
{
    try {
        PreparedRecord prepared{&record, path, FrameClock(record), {}, 0, {}, {}};
        Notes found;
        prepared.map = mapChannels(record, parameters, found);
        prepared.used = prepared.map.used;
        const bool timed = prepared.clock.isKnown();
        prepared.channel_skew_s = resolve<TrajectoryParameters>(prepared.used, "channel_skew_s",
                                                                timed ? parameters.channel_skew_s : std::nullopt,
                                                                timed ? record.channel_skew_s : std::nullopt, 0.0);
        if (!timed || !(parameters.channel_skew_s || record.channel_skew_s)) found.push_back({notes::skewUnknown, {}});
        prepared.revolutions =
            findRevolutions(record, prepared.clock, prepared.map, parameters, prepared.channel_skew_s);
        for (Note& note : found) {
            note.values.insert(note.values.begin(), {"path", path});
            notes.push_back(std::move(note));
        }
        if (prepared.revolutions.irregular > 0)
            notes.push_back({notes::revolutionsRejected,
                             {{"path", path}, {"count", std::int64_t{prepared.revolutions.irregular}}}});
        noteSpeed(prepared, path, notes);
        return prepared;
    } catch (Error& error) {
        throw error.with("path", path);
    }
}

/// A parameter that was not given and that the record states.
void takeFromRecord(const std::string& key, const Value& value, Notes& notes, UsedValues& used)
{
    for (const FieldInfo& info : infos<TrajectoryParameters>())
        if (info.key == key) {
            addUsed(used, info, value, ValueOrigin::File);
            notes.push_back({notes::valueAssumed,
                             {{"parameter", key},
                              {"label", info.label},
                              {"value", value},
                              {"unit", info.unit},
                              {"source", LT_TEXT("Engine", "the record")}}});
        }
}

std::optional<Segmentation> segmentationOf(const io::ProbeRecord& record, const TrajectoryParameters& parameters,
                                           Notes& notes, UsedValues& used)
{
    if (parameters.feed_mm_rev) return Segmentation{*parameters.feed_mm_rev, parameters.sections};
    if (!parameters.z_mm.empty()) return std::nullopt;
    const auto feed = io::headerNumber(record.header, "feed_mm_rev");
    const auto sections = io::headerNumber(record.header, "sections");
    if (!feed || !sections || !(*feed > 0) || !(*sections >= 2 && *sections <= 10000)) return std::nullopt;
    takeFromRecord("feed_mm_rev", *feed, notes, used);
    takeFromRecord("sections", *sections, notes, used);
    return Segmentation{*feed, static_cast<int>(std::lround(*sections))};
}

RecordSegment wholeRecord(const PreparedRecord& prepared, const TrajectoryParameters& parameters)
{
    RecordSegment segment;
    for (const Revolution& revolution : prepared.revolutions.all) {
        if (!revolution.regular) continue;
        ++segment.found;
        if (segment.found <= parameters.revolutions) segment.chosen.push_back(revolution);
    }
    return segment;
}

std::vector<RecordSegment> segmentRecord(const PreparedRecord& prepared, const TrajectoryParameters& parameters,
                                         const Segmentation& segmentation)
{
    const std::vector<Revolution>& all = prepared.revolutions.all;
    const std::int64_t turns = all.back().number + 1;
    const std::int64_t each = std::min<std::int64_t>(parameters.revolutions, turns / segmentation.sections);
    if (each < fewestRevolutions)
        throw Error(errors::recordTooShort, {{"path", prepared.path},
                                             {"found", turns},
                                             {"sections", std::int64_t{segmentation.sections}},
                                             {"minimum", fewestRevolutions * segmentation.sections}});
    std::vector<RecordSegment> segments(static_cast<std::size_t>(segmentation.sections));
    for (std::int64_t i = 0; i < segmentation.sections; ++i) {
        RecordSegment& segment = segments[static_cast<std::size_t>(i)];
        const std::int64_t first = i * turns / segmentation.sections;
        const std::int64_t end = (i + 1) * turns / segmentation.sections;
        for (const Revolution& revolution : all) {
            if (!revolution.regular || revolution.number < first || revolution.number >= end) continue;
            ++segment.found;
            if (revolution.number < first + each) segment.chosen.push_back(revolution);
        }
        segment.z_mm = segmentation.feed_mm_rev * (static_cast<double>(first) + static_cast<double>(each) / 2);
    }
    return segments;
}

}  // namespace lathelier::trajectory
