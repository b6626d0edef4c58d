#include "widgets/trajectory_common/spindle_files.h"

namespace lathelier {
ProbeFile RecordStore::read(const Source& source, InputFiles& inputs, const Progress& progress) const
{
    return readProbeRecord(source.path, inputs.open(source.path, progress), inputs,
                           fromValues<ImportOptions>(source.import), fromValues<RecorderOptions>(source.import),
                           progress);
}

ProfileFile ProfileStore::read(const Source& source, InputFiles& inputs, const Progress& progress) const
{
    return readProfile(source.path, inputs.open(source.path, progress), fromValues<ImportOptions>(source.import),
                       fromValues<ProfileOptions>(source.import), progress);
}

}  // namespace lathelier
