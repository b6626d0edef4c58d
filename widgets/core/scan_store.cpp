#include "widgets/core/scan_store.h"

namespace lathelier {

ScanFile ScanStore::read(const Source& source, InputFiles& inputs, const Progress& progress) const
{
    return readScan(source.path, inputs.open(source.path, progress), fromValues<ImportOptions>(source.import),
                    progress);
}

}  // namespace lathelier
