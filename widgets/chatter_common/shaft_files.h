// Files of shafts and spindles that were read, and the libraries inside the program.
#pragma once

#include "engine/core/shaft.h"
#include "engine/io/import.h"
#include "engine/receptance/library.h"
#include "widgets/core/files/file_cache.h"

namespace lathelier::chatter_common {

struct ShaftFile {
    Shaft shaft;          ///< as read
    io::FileFacts facts;  ///< as inspect says
    Notes notes;          ///< of the reading
};

/// Errors as readShaftFile().
class ShaftStore : public FileCache<ShaftFile> {
public:
    ShaftStore() : FileCache(20) {}

protected:
    ShaftFile read(const project::Source& source, io::InputFiles& inputs, const Progress& progress) const override;
};

struct SpindleFile {
    receptance::SpindleReceptance spindle;  ///< as read
    io::FileFacts facts;                    ///< as inspect says
    Notes notes;                            ///< of the reading
};

/// Errors as readSpindle().
class SpindleStore : public FileCache<SpindleFile> {
public:
    SpindleStore() : FileCache(20) {}

protected:
    SpindleFile read(const project::Source& source, io::InputFiles& inputs, const Progress& progress) const override;
};

/// Read once from the program's resources. Safe from any thread.
const std::vector<receptance::LibraryEntry<Material>>& materialLibrary();
const std::vector<receptance::LibraryEntry<receptance::SpindleSprings>>& machineLibrary();

/// An item as if it had been a file: its name and the digest of its values.
InputFile inputOfItem(const project::Source& source, const Values& values);

}  // namespace lathelier::chatter_common
