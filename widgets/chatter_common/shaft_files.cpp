#include "widgets/chatter_common/shaft_files.h"

#include <nlohmann/json.hpp>

#include "engine/core/json.h"
#include "engine/io/file.h"
#include "engine/receptance/shaft_file.h"
#include "engine/receptance/shaft_kind.h"
#include "engine/receptance/spindle_file.h"
#include "engine/receptance/spindle_kind.h"
#include "widgets/core/resources.h"

namespace lathelier::chatter_common {
namespace {

/// Calls `read`; its errors get the path.
template <class Read>
auto named(const std::string& path, Read read)
{
    try {
        return read();
    } catch (Error& error) {
        throw error.with("path", path);
    }
}

}  // namespace

ShaftFile ShaftStore::read(const project::Source& source, io::InputFiles& inputs, const Progress& progress) const
{
    const std::string_view bytes = inputs.open(source.path, progress);
    return named(source.path, [&] {
        ShaftFile file;
        Notes twice;
        file.shaft = receptance::readShaftFile(bytes, twice, progress);
        file.facts = receptance::shaftFiles().facts({source.path, bytes, source.import, inputs, progress}, file.notes);
        return file;
    });
}

SpindleFile SpindleStore::read(const project::Source& source, io::InputFiles& inputs, const Progress& progress) const
{
    const std::string_view bytes = inputs.open(source.path, progress);
    return named(source.path, [&] {
        SpindleFile file;
        Notes twice;
        file.spindle = receptance::readSpindle(std::string(bytes), twice);
        file.facts =
            receptance::spindleFiles().facts({source.path, bytes, source.import, inputs, progress}, file.notes);
        return file;
    });
}

const std::vector<receptance::LibraryEntry<Material>>& materialLibrary()
{
    static const auto library = receptance::readMaterials(resourceText(":/library/materials.json"));
    return library;
}

const std::vector<receptance::LibraryEntry<receptance::SpindleSprings>>& machineLibrary()
{
    static const auto library = receptance::readMachines(resourceText(":/library/machines.json"));
    return library;
}

InputFile inputOfItem(const project::Source& source, const Values& values)
{
    const std::string text = toJson(values).dump();
    return {source.item, static_cast<std::int64_t>(text.size()), io::sha256(text)};
}

}  // namespace lathelier::chatter_common
