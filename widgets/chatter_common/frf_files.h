// Cache of frequency response files.
#pragma once

#include "engine/io/frf/frf_reader.h"
#include "engine/task/file_cache.h"

namespace lathelier::chatter_common {

/// Source::import are ImportOptions and FrfOptions; errors as readFrf().
class FrfStore : public FileCache<io::FrfFile> {
public:
    FrfStore() : FileCache(20) {}

protected:
    io::FrfFile read(const project::Source& source, io::InputFiles& inputs, const Progress& progress) const override;
};

}  // namespace lathelier::chatter_common
