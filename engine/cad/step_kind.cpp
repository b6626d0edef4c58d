#include "engine/cad/step_kind.h"

#include <algorithm>

namespace lathelier::cad {

StepFile loadStep(const io::FileToRead& file)
{
    StepFile loaded;
    try {
        loaded.part = readStep(file.bytes, loaded.notes, file.progress);
    } catch (Error& error) {
        throw error.with("path", file.path);
    }
    for (Note& note : loaded.notes) set(note.values, "path", file.path);
    const Shaft& shaft = loaded.part.shaft;
    io::FileFacts& facts = loaded.facts;
    facts.path = file.path;
    facts.format = "STEP";
    facts.unit = "mm";
    facts.unit_source = "stated";
    double largest_mm = 0;
    for (const ShaftSegment& row : shaft.segments)
        largest_mm = std::max({largest_mm, row.start_diameter_mm, row.end_diameter_mm});
    if (!shaft.name.empty()) set(facts.details, "name", shaft.name);
    set(facts.details, "segments", static_cast<std::int64_t>(shaft.segments.size()));
    set(facts.details, "bores", static_cast<std::int64_t>(shaft.bores.size()));
    set(facts.details, "length_mm", shaft.length_mm());
    set(facts.details, "largest_diameter_mm", largest_mm);
    set(facts.details, "volume_mm3", loaded.part.volume_mm3);
    set(facts.details, "other_faces", static_cast<std::int64_t>(loaded.part.other_faces.size()));
    return loaded;
}

const io::FileKind& stepFiles()
{
    static const io::FileKind kind{"step",
                                   LT_TEXT("Engine", "STEP files"),
                                   "*.step *.stp *.p21",
                                   {},
                                   {},
                                   [](const std::string&, std::string_view head, const Values&) {
                                       return looksLikeStep(head) ? io::Likeness::Certain : io::Likeness::No;
                                   },
                                   [](const io::FileToRead& file, Notes& notes) {
                                       StepFile loaded = loadStep(file);
                                       notes.insert(notes.end(), loaded.notes.begin(), loaded.notes.end());
                                       return std::move(loaded.facts);
                                   }};
    return kind;
}

}  // namespace lathelier::cad
