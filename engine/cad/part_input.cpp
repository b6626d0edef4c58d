#include "engine/cad/part_input.h"

#include "engine/cad/shaft_csv.h"
#include "engine/cad/step_kind.h"
#include "engine/io/shaft/shaft_file.h"
#include "engine/io/shaft/shaft_kind.h"
#include "engine/io/text/encoding.h"

namespace lathelier::cad {
namespace {

/// The bores as stated in a SHAFT.json; loadShaft() merges them into the rows.
PartFile withStatedBores(io::ShaftFile loaded, const io::FileToRead& file)
{
    PartFile part{std::move(loaded.shaft), std::move(loaded.facts), std::move(loaded.notes), {}};
    if (part.facts.format != "shaft_json") return part;
    Notes again;  // the same notes are in `part`
    const io::DecodedText text = io::decodeText(file.bytes, io::Encoding::Auto, file.progress);
    part.shaft = io::readShaft(std::string(text.view()), again);
    set(part.facts.details, "segments", static_cast<std::int64_t>(part.shaft.segments.size()));
    return part;
}

}  // namespace

PartFile PartInput::read(const io::FileToRead& file)
{
    const std::string_view head = file.bytes.substr(0, io::headForKind);
    if (looksLikeStep(head)) {
        StepFile step = loadStep(file);
        return {step.part.shaft, std::move(step.facts), std::move(step.notes), std::move(step.part)};
    }
    const std::size_t first = head.find_first_not_of(" \t\r\n");
    const bool is_json = first != std::string_view::npos && head[first] == '{';
    if (is_json || file.bytes.empty() ||
        io::shaftFiles().sniff(file.path, head, file.reading) >= io::Likeness::Possible)
        return withStatedBores(io::loadShaft(file), file);
    PartFile table;
    table.shaft = readShaftCsv(file.bytes, table.notes, file.progress);
    for (Note& note : table.notes) set(note.values, "path", file.path);
    table.facts.path = file.path;
    table.facts.format = "csv";
    return table;
}

io::FileKinds PartInput::kinds()
{
    return {&io::shaftFiles(), &stepFiles()};
}

std::optional<Shaft> PartInput::ofItem(const Values& values)
{
    return shaftOf(values);
}

}  // namespace lathelier::cad
