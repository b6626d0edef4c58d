// A scan as an input of a task (task/inputs.h): a cloud, a mesh, or stacked sections.
#pragma once

#include <cstddef>
#include <optional>

#include "engine/io/cloud/scan_reader.h"
#include "engine/io/file_kind.h"

namespace lathelier::io {

struct ScanInput {
    using File = ScanFile;
    using Value = Scan;
    static constexpr const char* item = "";
    static constexpr std::size_t capacity = 6;  ///< scans are large: a cache keeps no more

    static File read(const FileToRead& file)
    {
        File loaded = readScan(file.path, file.bytes, fromValues<ImportOptions>(file.reading), file.progress);
        file.inputs.drop();
        return loaded;
    }
    static Value valueOf(const File& file) { return file.scan; }
    static FileKinds kinds() { return {&scanFiles()}; }
};

}  // namespace lathelier::io
