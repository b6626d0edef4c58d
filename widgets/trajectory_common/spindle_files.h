// Caches of probe records and profiles, valid until the user accepts changes.
#pragma once

#include "engine/io/probe/probe_reader.h"
#include "engine/io/profile/profile_reader.h"
#include "engine/report/document.h"
#include "engine/task/file_cache.h"

namespace lathelier::trajectory_common {

using LoadedRecordPtr = std::shared_ptr<const Loaded<io::ProbeFile>>;
using LoadedProfilePtr = std::shared_ptr<const Loaded<io::ProfileFile>>;

/// Source::import are ImportOptions and RecorderOptions; errors as readProbeRecord().
class RecordStore : public FileCache<io::ProbeFile> {
public:
    RecordStore() : FileCache(60) {}

protected:
    io::ProbeFile read(const project::Source& source, io::InputFiles& inputs, const Progress& progress) const override;
};

/// Source::import are ImportOptions and ProfileOptions; errors as readProfile().
class ProfileStore : public FileCache<io::ProfileFile> {
public:
    ProfileStore() : FileCache(12) {}

protected:
    io::ProfileFile read(const project::Source& source, io::InputFiles& inputs,
                         const Progress& progress) const override;
};

/// A profile that another panel made, as if it had been read. Error itemNotThere when the project has it no longer, or
/// its values are not those of a profile.
LoadedProfilePtr profileFromItem(const project::Source& source, const std::string& role,
                                 const project::PanelState& state);

}  // namespace lathelier::trajectory_common
