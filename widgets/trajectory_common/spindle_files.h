// Probe records and profiles that were read, kept until the user takes what has changed.
#pragma once

#include "engine/io/probe_reader.h"
#include "engine/io/profile_reader.h"
#include "engine/report/document.h"
#include "widgets/core/file_cache.h"

namespace lathelier {

using LoadedRecordPtr = std::shared_ptr<const Loaded<ProbeFile>>;
using LoadedProfilePtr = std::shared_ptr<const Loaded<ProfileFile>>;

/// Source::import are ImportOptions and RecorderOptions; errors as readProbeRecord().
class RecordStore : public FileCache<ProbeFile> {
public:
    RecordStore() : FileCache(60) {}

protected:
    ProbeFile read(const Source& source, InputFiles& inputs, const Progress& progress) const override;
};

/// Source::import are ImportOptions and ProfileOptions; errors as readProfile().
class ProfileStore : public FileCache<ProfileFile> {
public:
    ProfileStore() : FileCache(12) {}

protected:
    ProfileFile read(const Source& source, InputFiles& inputs, const Progress& progress) const override;
};

}  // namespace lathelier
