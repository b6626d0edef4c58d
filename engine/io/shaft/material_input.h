// A material as an input of a task (task/inputs.h).
#pragma once

#include <optional>

#include "engine/core/material.h"
#include "engine/io/file_kind.h"
#include "engine/io/shaft/shaft_file.h"

namespace lathelier::io {

struct MaterialFile {
    Material material;
    Notes notes;  ///< of readMaterial(), with path
};

struct MaterialInput {
    using File = MaterialFile;
    using Value = Material;
    static constexpr const char* item = "";

    static File read(const FileToRead& file)
    {
        MaterialFile loaded;
        loaded.material = readMaterial(std::string(file.bytes), loaded.notes);
        for (Note& note : loaded.notes) set(note.values, "path", file.path);
        return loaded;
    }
    static Value valueOf(const File& file) { return file.material; }
    static FileKinds kinds() { return {}; }
};

}  // namespace lathelier::io
