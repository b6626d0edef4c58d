// The chuck face of a machine as an input of a task (task/inputs.h).
#pragma once

#include <optional>

#include "engine/receptance/spindle/spindle_item.h"
#include "engine/receptance/spindle/spindle_kind.h"

namespace lathelier::receptance {

struct SpindleInput {
    using File = SpindleFile;
    using Value = SpindleReceptance;
    static constexpr const char* item = spindleItem;

    static File read(const io::FileToRead& file) { return loadSpindle(file); }
    static Value valueOf(const File& file) { return file.spindle; }
    static io::FileKinds kinds() { return {&spindleFiles()}; }
    static std::optional<Value> ofItem(const Values& values) { return spindleOf(values); }
};

}  // namespace lathelier::receptance
