#include "engine/receptance/spindle/spindle_kind.h"

#include <algorithm>
#include <filesystem>

#include "engine/io/frf/frf_reader.h"
#include "engine/io/json/json_head.h"
#include "engine/receptance/eirc/spindle_measurements.h"
#include "engine/receptance/receptance_codes.h"
#include "engine/receptance/spindle/spindle_file.h"

namespace lathelier::receptance {
namespace {

/// Result files of the command line contain the same keys.
bool isResult(const std::vector<std::string>& keys)
{
    return io::hasKey(keys, "command");
}

io::Likeness likeSpindle(const std::string&, std::string_view head, const Values&)
{
    const std::vector<std::string> keys = io::keysOfHead(head);
    if (isResult(keys)) return io::Likeness::No;
    if (io::hasKey(keys, "springs") || io::hasKey(keys, "H_mm_N")) return io::Likeness::Certain;
    // long table: the head of the file is truncated
    return io::hasKey(keys, "frequency_hz") ? io::Likeness::Likely : io::Likeness::No;
}

io::Likeness likeMeasurements(const std::string&, std::string_view head, const Values&)
{
    const std::vector<std::string> keys = io::keysOfHead(head);
    return io::hasKey(keys, "rods") && !isResult(keys) ? io::Likeness::Certain : io::Likeness::No;
}

/// Calls `read` and adds the path to its errors and notes.
template <class Read>
auto named(const io::FileToRead& file, Notes& notes, Read read)
{
    try {
        auto value = read(std::string(file.bytes), notes);
        for (Note& note : notes) set(note.values, "path", file.path);
        return value;
    } catch (Error& error) {
        throw error.with("path", file.path);
    }
}

/// Im H > 0: a table that was identified may hold that within its noise, which a file does not state.
void notePassivity(const SpindleTable& table, const std::string& path, Notes& notes)
{
    const auto active = [](const Complex& H) { return H.imag() > 0; };
    const auto first = std::find_if(table.H_mm_N.begin(), table.H_mm_N.end(), active);
    if (first == table.H_mm_N.end()) return;
    notes.push_back({notes::spindleTableNotPassive,
                     {{"path", path},
                      {"lines", std::int64_t{std::count_if(first, table.H_mm_N.end(), active)}},
                      {"all", static_cast<std::int64_t>(table.H_mm_N.size())},
                      {"frequency_hz", table.frequency_hz[static_cast<std::size_t>(first - table.H_mm_N.begin())]}}});
}

io::FileFacts factsOf(const io::FileToRead& file, const char* format)
{
    io::FileFacts facts;
    facts.path = file.path;
    facts.format = format;
    return facts;
}

io::FileFacts measurementFacts(const io::FileToRead& file, const MeasurementFile& measured)
{
    io::FileFacts facts = factsOf(file, "measurements_json");
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

SpindleFile loadSpindle(const io::FileToRead& file)
{
    SpindleFile loaded;
    loaded.spindle = named(file, loaded.notes, readSpindle);
    io::FileFacts& facts = loaded.facts = factsOf(file, "spindle_json");
    if (const SpindleSprings* springs = loaded.spindle.springs()) {
        set(facts.details, "source", std::string("springs"));
        for (const auto& [key, value] : lathelier::toValues(*springs)) set(facts.details, key, value);
    } else {
        const auto& table = std::get<SpindleTable>(loaded.spindle.source);
        const std::vector<double>& lines = table.frequency_hz;
        notePassivity(table, file.path, loaded.notes);
        set(facts.details, "source", std::string("table"));
        set(facts.details, "lines", static_cast<std::int64_t>(lines.size()));
        set(facts.details, "from_hz", lines.front());
        set(facts.details, "to_hz", lines.back());
    }
    return loaded;
}

TapTests loadTapTests(const io::FileToRead& file)
{
    TapTests loaded;
    const MeasurementFile measured = named(file, loaded.notes, readMeasurements);
    loaded.facts = measurementFacts(file, measured);
    const std::string beside = (std::filesystem::path(file.path).parent_path() / measured.frf).string();
    const io::FrfFile responses =
        io::readFrf(beside, file.inputs.open(beside, file.progress), fromValues<io::ImportOptions>(file.reading),
                    fromValues<io::FrfOptions>(file.reading), file.progress);
    loaded.notes.insert(loaded.notes.end(), responses.notes.begin(), responses.notes.end());
    std::vector<NodeFrf> frfs;
    frfs.reserve(responses.frfs.size());
    for (const io::MeasuredFrf& one : responses.frfs) frfs.push_back({one.response_node, one.reference_node, one.frf});
    loaded.measurements = measurementsOf(measured, frfs);
    return loaded;
}

const io::FileKind& spindleFiles()
{
    static const io::FileKind kind{"spindle",
                                   LT_TEXT("Engine", "Spindles"),
                                   "*.json",
                                   {},
                                   {},
                                   likeSpindle,
                                   [](const io::FileToRead& file, Notes& notes) {
                                       SpindleFile loaded = loadSpindle(file);
                                       notes.insert(notes.end(), loaded.notes.begin(), loaded.notes.end());
                                       return std::move(loaded.facts);
                                   }};
    return kind;
}

const io::FileKind& measurementFiles()
{
    static const io::FileKind kind{"measurements",
                                   LT_TEXT("Engine", "Tap tests"),
                                   "*.json",
                                   {},
                                   {},
                                   likeMeasurements,
                                   [](const io::FileToRead& file, Notes& notes) {
                                       Notes found;
                                       const MeasurementFile measured = named(file, found, readMeasurements);
                                       notes.insert(notes.end(), found.begin(), found.end());
                                       return measurementFacts(file, measured);
                                   }};
    return kind;
}

}  // namespace lathelier::receptance
