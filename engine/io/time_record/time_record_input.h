// A time record as an input of a task (task/inputs.h).
#pragma once

#include <cstddef>

#include "engine/io/time_record/time_record_reader.h"

namespace lathelier::io {

struct TimeRecordInput {
    using File = TimeRecordFile;
    using Value = TimeRecordFile;
    static constexpr const char* item = "";
    static constexpr std::size_t capacity = 40;  ///< one for each hit

    static File read(const FileToRead& file)
    {
        return readTimeRecord(file.path, file.bytes, fromValues<ImportOptions>(file.reading), file.progress);
    }
    static Value valueOf(const File& file) { return file; }
    static FileKinds kinds() { return {&timeRecordFiles()}; }
};

}  // namespace lathelier::io
