// A probe record as an input of a task (task/inputs.h): a table, or one of a pair of L-Graph.
#pragma once

#include <cstddef>

#include "engine/io/file_kind.h"
#include "engine/io/probe/probe_reader.h"

namespace lathelier::io {

struct ProbeInput {
    using File = ProbeFile;
    using Value = ProbeFile;
    static constexpr const char* item = "";
    static constexpr std::size_t capacity = 60;  ///< one for each section of a workpiece

    static File read(const FileToRead& file)
    {
        return readProbeRecord(file.path, file.bytes, file.inputs, fromValues<ImportOptions>(file.reading),
                               fromValues<RecorderOptions>(file.reading), file.progress);
    }
    static Value valueOf(const File& file) { return file; }
    static FileKinds kinds() { return {&probeRecordFiles()}; }
};

}  // namespace lathelier::io
