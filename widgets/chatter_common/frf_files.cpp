#include "widgets/chatter_common/frf_files.h"

namespace lathelier::chatter_common {

io::FrfFile FrfStore::read(const project::Source& source, io::InputFiles& inputs, const Progress& progress) const
{
    return io::readFrf(source.path, inputs.open(source.path, progress), fromValues<io::ImportOptions>(source.import),
                       fromValues<io::FrfOptions>(source.import), progress);
}

}  // namespace lathelier::chatter_common
