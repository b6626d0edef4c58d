// Jobs, posts and corrections as inputs of a task (task/inputs.h).
#pragma once

#include <optional>
#include <string>

#include "engine/cam/check/correction_file.h"
#include "engine/cam/job_file.h"
#include "engine/cam/job_item.h"
#include "engine/cam/post/post_file.h"

namespace lathelier::cam {

struct JobInput {
    using File = JobFile;
    using Value = Job;
    static constexpr const char* item = jobItem;

    static File read(const io::FileToRead& file) { return loadJob(file); }
    static Value valueOf(const File& file) { return file.job; }
    static io::FileKinds kinds() { return {&jobFiles()}; }
    static std::optional<Value> ofItem(const Values& values) { return jobOf(values); }
    /// Of its file, so that the digest of an item is that of the file with the same content.
    static std::string contentOf(const Values& values) { return jobText(*jobOf(values)); }
};

struct PostInput {
    using File = PostFile;
    using Value = Post;
    static constexpr const char* item = "";

    static File read(const io::FileToRead& file) { return loadPost(file); }
    static Value valueOf(const File& file) { return file.post; }
    static io::FileKinds kinds() { return {&postFiles()}; }
};

/// What `deflection --compensate --json` wrote.
struct CorrectionFile {
    gcode::StatedCorrection correction;
    Notes notes;  ///< none
};

struct CorrectionInput {
    using File = CorrectionFile;
    using Value = gcode::StatedCorrection;
    static constexpr const char* item = "";

    static File read(const io::FileToRead& file) { return {readCorrection(std::string(file.bytes)), {}}; }
    static Value valueOf(const File& file) { return file.correction; }
    static io::FileKinds kinds() { return {}; }
};

}  // namespace lathelier::cam
