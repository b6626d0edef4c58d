#include "widgets/part_common/part_store.h"

#include "engine/io/shaft/shaft_file.h"
#include "engine/io/text/encoding.h"

namespace lathelier::part_common {
namespace {

constexpr std::size_t sniffedBytes = 4096;

/// The bores as stated in a SHAFT.json; loadShaft() merges them into the rows.
io::ShaftFile withStatedBores(io::ShaftFile loaded, const io::FileToRead& file)
{
    if (loaded.facts.format != "shaft_json") return loaded;
    Notes again;  // the same notes are in `loaded`
    const io::DecodedText text = io::decodeText(file.bytes, io::Encoding::Auto, file.progress);
    loaded.shaft = io::readShaft(std::string(text.view()), again);
    set(loaded.facts.details, "segments", static_cast<std::int64_t>(loaded.shaft.segments.size()));
    return loaded;
}

}  // namespace

io::ShaftFile PartStore::read(const project::Source& source, io::InputFiles& inputs, const Progress& progress) const
{
    const io::FileToRead file{source.path, inputs.open(source.path, progress), source.import, inputs, progress};
    if (!cad::looksLikeStep(file.bytes.substr(0, sniffedBytes))) return withStatedBores(io::loadShaft(file), file);
    cad::StepFile step = cad::loadStep(file);
    return {std::move(step.part.shaft), std::move(step.facts), std::move(step.notes)};
}

}  // namespace lathelier::part_common
