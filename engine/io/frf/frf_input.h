// A frequency response as an input of a task (task/inputs.h): a receptance, measured or made by another task.
#pragma once

#include <optional>

#include "engine/core/frf_item.h"
#include "engine/io/frf/frf_choice.h"
#include "engine/io/frf/frf_lines.h"
#include "engine/io/frf/frf_reader.h"

namespace lathelier::io {

/// A file of responses of which one is taken.
struct FrfChoiceFile : FrfFile {
    std::size_t used = 0;        ///< index of chosenResponse()
    Notes notes_of_choice = {};  ///< notesOfChoice(), where none was named

    const MeasuredFrf& response() const { return frfs[used]; }
};

struct FrfInput {
    using File = FrfChoiceFile;
    using Value = Frf;
    static constexpr const char* item = frfItem;

    /// Errors of readFrf() and chosenResponse().
    static File read(const FileToRead& file)
    {
        const auto options = fromValues<FrfOptions>(file.reading);
        File all{readFrf(file.path, file.bytes, fromValues<ImportOptions>(file.reading), options, file.progress)};
        const MeasuredFrf& used = chosenResponse(all.frfs, options);
        all.used = static_cast<std::size_t>(&used - all.frfs.data());
        if (options.response.empty()) all.notes_of_choice = notesOfChoice(all.frfs, used, file.path);
        return all;
    }
    static Value valueOf(const File& file) { return toReceptance(file.response().frf); }
    static FileKinds kinds() { return {&frfFiles()}; }
    static std::optional<Value> ofItem(const Values& values) { return frfOf(values); }
};

}  // namespace lathelier::io
