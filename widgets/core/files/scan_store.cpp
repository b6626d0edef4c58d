#include "widgets/core/files/scan_store.h"

namespace lathelier {

io::ScanFile ScanStore::read(const project::Source& source, io::InputFiles& inputs, const Progress& progress) const
{
    return io::readScan(source.path, inputs.open(source.path, progress), fromValues<io::ImportOptions>(source.import),
                        progress);
}

}  // namespace lathelier
