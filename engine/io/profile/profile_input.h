// A measured profile as an input of a task (task/inputs.h): a file, or a section that another panel cut out of its
// data.
#pragma once

#include <cstddef>
#include <optional>

#include "engine/core/profile_item.h"
#include "engine/io/file_kind.h"
#include "engine/io/profile/profile_reader.h"

namespace lathelier::io {

struct ProfileInput {
    using File = ProfileFile;
    using Value = Profile;
    static constexpr const char* item = profileItem;
    static constexpr std::size_t capacity = 12;

    static File read(const FileToRead& file)
    {
        return readProfile(file.path, file.bytes, fromValues<ImportOptions>(file.reading),
                           fromValues<ProfileOptions>(file.reading), file.progress);
    }
    static Value valueOf(const File& file) { return file.profile; }
    static FileKinds kinds() { return {&profileFiles()}; }
    static std::optional<Value> ofItem(const Values& values) { return profileOf(values); }
};

}  // namespace lathelier::io
