#include "widgets/trajectory_common/spindle_files.h"

namespace lathelier::trajectory_common {
io::ProbeFile RecordStore::read(const project::Source& source, io::InputFiles& inputs, const Progress& progress) const
{
    return io::readProbeRecord(source.path, inputs.open(source.path, progress), inputs,
                               fromValues<io::ImportOptions>(source.import),
                               fromValues<io::RecorderOptions>(source.import), progress);
}

io::ProfileFile ProfileStore::read(const project::Source& source, io::InputFiles& inputs,
                                   const Progress& progress) const
{
    return io::readProfile(source.path, inputs.open(source.path, progress),
                           fromValues<io::ImportOptions>(source.import), fromValues<io::ProfileOptions>(source.import),
                           progress);
}

}  // namespace lathelier::trajectory_common
