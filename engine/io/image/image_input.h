// A picture as an input of a task (task/inputs.h).
#pragma once

#include <cstddef>

#include "engine/io/image/image.h"
#include "engine/io/image/image_kind.h"

namespace lathelier::io {

struct ImageInput {
    using File = Image;
    using Value = Image;
    static constexpr const char* item = "";
    static constexpr std::size_t capacity = 3;  ///< of 400 MB at 100 Mpx: before, after, and the next one

    static File read(const FileToRead& file)
    {
        File loaded = readImage(file.path, file.bytes, file.progress);
        file.inputs.drop();
        return loaded;
    }
    static Value valueOf(const File& file) { return file; }
    static FileKinds kinds() { return {&imageFiles()}; }
};

}  // namespace lathelier::io
