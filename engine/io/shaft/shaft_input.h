// A shaft as an input of a task (task/inputs.h): its contour as beams, stock and tools see it.
#pragma once

#include <optional>

#include "engine/io/shaft/shaft_kind.h"
#include "engine/shaft/shaft_contour.h"
#include "engine/shaft/shaft_item.h"

namespace lathelier::io {

struct ShaftInput {
    using File = ShaftFile;
    using Value = Shaft;
    static constexpr const char* item = shaftItem;

    static File read(const FileToRead& file) { return loadShaft(file); }
    static Value valueOf(const File& file) { return file.shaft; }
    static FileKinds kinds() { return {&shaftFiles()}; }
    static std::optional<Value> ofItem(const Values& values)
    {
        const std::optional<Shaft> shaft = shaftOf(values);
        return shaft ? std::optional(beamView(*shaft)) : std::nullopt;
    }
};

}  // namespace lathelier::io
