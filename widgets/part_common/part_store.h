// Cache of shaft files for the panels Drawing and Compare, with bores as stated.
#pragma once

#include "engine/cad/step_kind.h"
#include "engine/io/shaft/shaft_kind.h"
#include "widgets/core/files/file_cache.h"

namespace lathelier::part_common {

/// SHAFT.json, stock text or STEP, distinguished by content. Errors: those of readShaft(), readStock(), readStep(),
/// with the path; fileEmpty.
class PartStore : public FileCache<io::ShaftFile> {
public:
    PartStore() : FileCache(20) {}

protected:
    io::ShaftFile read(const project::Source& source, io::InputFiles& inputs, const Progress& progress) const override;
};

}  // namespace lathelier::part_common
