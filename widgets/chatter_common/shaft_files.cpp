#include "widgets/chatter_common/shaft_files.h"

namespace lathelier::chatter_common {

io::ShaftFile ShaftStore::read(const project::Source& source, io::InputFiles& inputs, const Progress& progress) const
{
    return io::loadShaft({source.path, inputs.open(source.path, progress), source.import, inputs, progress});
}

receptance::SpindleFile SpindleStore::read(const project::Source& source, io::InputFiles& inputs,
                                           const Progress& progress) const
{
    return receptance::loadSpindle({source.path, inputs.open(source.path, progress), source.import, inputs, progress});
}

}  // namespace lathelier::chatter_common
