// A frequency response as an input of a task (task/inputs.h): a receptance, measured or made by another task.
#pragma once

#include <optional>

#include "engine/core/frf_item.h"
#include "engine/io/frf/frf_choice.h"
#include "engine/io/frf/frf_lines.h"
#include "engine/io/frf/frf_reader.h"

namespace lathelier::io {

struct FrfInput {
    using File = FrfFile;
    using Value = Frf;
    static constexpr const char* item = frfItem;

    static File read(const FileToRead& file)
    {
        return readFrf(file.path, file.bytes, fromValues<ImportOptions>(file.reading),
                       fromValues<FrfOptions>(file.reading), file.progress);
    }
    static Value valueOf(const File& file) { return toReceptance(preferredResponse(file.frfs).frf); }
    static FileKinds kinds() { return {&frfFiles()}; }
    static std::optional<Value> ofItem(const Values& values) { return frfOf(values); }
};

}  // namespace lathelier::io
