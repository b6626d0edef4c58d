// Caches of shaft and spindle files.
#pragma once

#include "engine/io/shaft/shaft_kind.h"
#include "engine/receptance/spindle_kind.h"
#include "widgets/core/files/file_cache.h"

namespace lathelier::chatter_common {

/// Errors as io::loadShaft().
class ShaftStore : public FileCache<io::ShaftFile> {
public:
    ShaftStore() : FileCache(20) {}

protected:
    io::ShaftFile read(const project::Source& source, io::InputFiles& inputs, const Progress& progress) const override;
};

/// Errors as receptance::loadSpindle().
class SpindleStore : public FileCache<receptance::SpindleFile> {
public:
    SpindleStore() : FileCache(20) {}

protected:
    receptance::SpindleFile read(const project::Source& source, io::InputFiles& inputs,
                                 const Progress& progress) const override;
};

}  // namespace lathelier::chatter_common
