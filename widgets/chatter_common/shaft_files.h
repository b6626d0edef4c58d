// Files of shafts and spindles that were read, and the libraries inside the program.
#pragma once

#include "engine/receptance/library.h"
#include "engine/receptance/shaft_kind.h"
#include "engine/receptance/spindle_kind.h"
#include "widgets/core/files/file_cache.h"

namespace lathelier::chatter_common {

/// Errors as receptance::loadShaft().
class ShaftStore : public FileCache<receptance::ShaftFile> {
public:
    ShaftStore() : FileCache(20) {}

protected:
    receptance::ShaftFile read(const project::Source& source, io::InputFiles& inputs,
                               const Progress& progress) const override;
};

/// Errors as receptance::loadSpindle().
class SpindleStore : public FileCache<receptance::SpindleFile> {
public:
    SpindleStore() : FileCache(20) {}

protected:
    receptance::SpindleFile read(const project::Source& source, io::InputFiles& inputs,
                                 const Progress& progress) const override;
};

/// Read once from the program's resources. Safe from any thread.
const std::vector<receptance::LibraryEntry<Material>>& materialLibrary();
const std::vector<receptance::LibraryEntry<receptance::SpindleSprings>>& machineLibrary();

}  // namespace lathelier::chatter_common
