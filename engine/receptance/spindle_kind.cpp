#include "engine/receptance/spindle_kind.h"

#include "engine/io/json/json_head.h"
#include "engine/receptance/eirc/spindle_measurements.h"
#include "engine/receptance/spindle_file.h"

namespace lathelier::receptance {
namespace {

/// Results of the command line have keys of the same names.
bool isResult(const std::vector<std::string>& keys)
{
    return io::hasKey(keys, "command");
}

io::Likeness likeSpindle(const std::string&, std::string_view head, const Values&)
{
    const std::vector<std::string> keys = io::keysOfHead(head);
    if (isResult(keys)) return io::Likeness::No;
    if (io::hasKey(keys, "springs") || io::hasKey(keys, "H_mm_N")) return io::Likeness::Certain;
    return io::hasKey(keys, "frequency_hz") ? io::Likeness::Likely : io::Likeness::No;  // long: the rest is cut off
}

io::Likeness likeMeasurements(const std::string&, std::string_view head, const Values&)
{
    const std::vector<std::string> keys = io::keysOfHead(head);
    return io::hasKey(keys, "rods") && !isResult(keys) ? io::Likeness::Certain : io::Likeness::No;
}

io::FileFacts factsOf(const io::FileToRead& file, const char* format, Notes& notes, Notes found)
{
    for (Note& note : found) set(note.values, "path", file.path);
    notes.insert(notes.end(), found.begin(), found.end());
    io::FileFacts facts;
    facts.path = file.path;
    facts.format = format;
    return facts;
}

io::FileFacts spindleFacts(const io::FileToRead& file, Notes& notes)
{
    Notes found;
    const SpindleReceptance spindle = readSpindle(std::string(file.bytes), found);
    io::FileFacts facts = factsOf(file, "spindle_json", notes, std::move(found));
    if (const SpindleSprings* springs = spindle.springs()) {
        set(facts.details, "source", std::string("springs"));
        for (const auto& [key, value] : toValues(*springs)) set(facts.details, key, value);
    } else {
        const std::vector<double>& lines = std::get<SpindleTable>(spindle.source).frequency_hz;
        set(facts.details, "source", std::string("table"));
        set(facts.details, "lines", static_cast<std::int64_t>(lines.size()));
        set(facts.details, "from_hz", lines.front());
        set(facts.details, "to_hz", lines.back());
    }
    return facts;
}

io::FileFacts measurementFacts(const io::FileToRead& file, Notes& notes)
{
    Notes found;
    const MeasurementFile measured = readMeasurements(std::string(file.bytes), found);
    io::FileFacts facts = factsOf(file, "measurements_json", notes, std::move(found));
    set(facts.details, "frf", measured.frf);
    Rows rods;
    rods.rows.reserve(measured.rods.size());
    for (const RodEntry& rod : measured.rods)
        rods.rows.push_back({{{"length_mm", rod.length_mm},
                              {"diameter_mm", rod.diameter_mm},
                              {"material", rod.material ? Value(rod.material->name) : Value()},
                              {"points", static_cast<std::int64_t>(rod.points.size())}}});
    set(facts.details, "rods", std::move(rods));
    return facts;
}

}  // namespace

const io::FileKind& spindleFiles()
{
    static const io::FileKind kind{"spindle",   LT_TEXT("Engine", "Spindles"), "*.json", {}, {}, likeSpindle,
                                   spindleFacts};
    return kind;
}

const io::FileKind& measurementFiles()
{
    static const io::FileKind kind{"measurements",  LT_TEXT("Engine", "Tap tests"), "*.json", {}, {}, likeMeasurements,
                                   measurementFacts};
    return kind;
}

}  // namespace lathelier::receptance
