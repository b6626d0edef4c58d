// A drawn part as an input of a task (task/inputs.h): STEP, SHAFT.json, a table, or a stock text, distinguished by
// content; bores as they are stated.
#pragma once

#include <optional>

#include "engine/cad/step_reader.h"
#include "engine/io/file_kind.h"
#include "engine/shaft/shaft.h"
#include "engine/shaft/shaft_item.h"

namespace lathelier::cad {

/// A part with the facts of its file.
struct PartFile {
    Shaft shaft;
    io::FileFacts facts;                ///< of shaftFiles() or stepFiles()
    Notes notes;                        ///< of the reader, with the path
    std::optional<StepPart> step = {};  ///< of a STEP file
};

struct PartInput {
    using File = PartFile;
    using Value = Shaft;
    static constexpr const char* item = shaftItem;

    /// Errors of readShaft(), readStock(), readStep(), readShaftCsv(), with the path; fileEmpty.
    static File read(const io::FileToRead& file);
    static Value valueOf(const File& file) { return file.shaft; }
    static io::FileKinds kinds();
    static std::optional<Value> ofItem(const Values& values);
};

}  // namespace lathelier::cad
