// What the fuzzers of profiles and probe records check.
#pragma once

#include "engine/io/io_codes.h"
#include "engine/io/probe/probe_reader.h"
#include "tests/fuzz/check_reader.h"

namespace lathelier::fuzz {

inline void checkFacts(const io::FileFacts& facts, const Notes& notes)
{
    require(facts.skipped.size() <= 100);
    require(!toJson(facts).dump().empty());  // throws when a text is no UTF-8
    for (const Note& note : notes) require(!text(note).empty());
}

inline void checkRecord(const io::ProbeFile& file)
{
    checkFacts(file.facts, file.notes);
    if (const auto* raw = std::get_if<io::ProbeRecord>(&file.record)) {
        require(!raw->channels.empty() && raw->frames() > 0);
        for (const io::ProbeChannel& channel : raw->channels) require(channel.values.size() == raw->frames());
        require(raw->time_s.empty() || raw->time_s.size() == raw->frames());
        for (std::size_t i = 1; i < raw->time_s.size(); ++i) require(raw->time_s[i] >= raw->time_s[i - 1]);
        require(!toJson(raw->header).dump().empty());
    } else {
        const auto& averaged = std::get<io::AveragedRecord>(file.record);
        require(!averaged.sections.empty());
        for (const io::AveragedSection& section : averaged.sections)
            require(!section.angle_deg.empty() && section.X3_um.size() == section.angle_deg.size() &&
                    section.Yp_um.size() == section.angle_deg.size());
    }
}

/// Runs `read`; an Error is a good answer as long as it can be shown and names a place.
template <class Read>
void checkAnswer(Read read)
{
    try {
        read();
    } catch (const Error& error) {
        require(!toJson(error).dump().empty() && !text(error).empty());
        const Values& values = error.values();
        const bool placed = find(values, "line") || find(values, "byte");
        const bool wholeFile = error.code() == errors::fileEmpty || error.code() == errors::noPoints ||
                               error.code() == errors::unitUnknown;
        require(placed || wholeFile);
        require(find(values, "path"));
    }
}

}  // namespace lathelier::fuzz
