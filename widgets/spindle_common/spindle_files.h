// Probe records and profiles that were read, kept as long as their files stay as they were.
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
    ProbeFile read(const Source& source, std::string_view bytes, const Progress& progress) const override;
};

/// Source::import are ImportOptions and ProfileOptions; errors as readProfile().
class ProfileStore : public FileCache<ProfileFile> {
public:
    ProfileStore() : FileCache(12) {}

protected:
    ProfileFile read(const Source& source, std::string_view bytes, const Progress& progress) const override;
};

/// For the audit: the file, and for a record of L-Graph its other half.
std::vector<InputFile> inputFilesOf(const Loaded<ProbeFile>& record);
InputFile inputFileOf(const Loaded<ProfileFile>& profile);

/// Of a list of paths, each L-Graph pair once, by its .par where both were given.
std::vector<std::string> withoutPartners(const std::vector<std::string>& paths);

}  // namespace lathelier
