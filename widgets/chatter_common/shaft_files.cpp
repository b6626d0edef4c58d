#include "widgets/chatter_common/shaft_files.h"

#include "widgets/core/resources.h"

namespace lathelier::chatter_common {

receptance::ShaftFile ShaftStore::read(const project::Source& source, io::InputFiles& inputs,
                                       const Progress& progress) const
{
    return receptance::loadShaft({source.path, inputs.open(source.path, progress), source.import, inputs, progress});
}

receptance::SpindleFile SpindleStore::read(const project::Source& source, io::InputFiles& inputs,
                                           const Progress& progress) const
{
    return receptance::loadSpindle({source.path, inputs.open(source.path, progress), source.import, inputs, progress});
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

}  // namespace lathelier::chatter_common
