// Which kind a file is, found once for what stands on the disk.
#pragma once

#include <map>
#include <mutex>
#include <optional>
#include <string>

#include "engine/io/file_kind.h"

namespace lathelier {

/// A file that was opened or dropped.
struct FoundFile {
    std::string path;
    const FileKind* kind = nullptr;  ///< nullptr: of no kind, or not to be read
    Likeness likeness = Likeness::No;
};

/// Safe from any thread.
class KindStore {
public:
    /// Reads the head of the file: not for the GUI thread.
    FoundFile find(const FileKinds& kinds, const std::string& path);

    /// What find() found, while the file is as it was. Never reads.
    std::optional<FoundFile> known(const std::string& path) const;

private:
    struct Entry {
        FoundFile file;
        std::string stamp;
    };
    mutable std::mutex mutex_;
    std::map<std::string, Entry> entries_;
};

}  // namespace lathelier
