#include "widgets/core/scan_store.h"

namespace lathelier {

ScanFile ScanStore::read(const Source& source, std::string_view bytes, const Progress& progress) const
{
    return readScan(source.path, bytes, fromValues<ImportOptions>(source.import), progress);
}

}  // namespace lathelier
