// The input files of a run: each is mapped once, and its digest is computed beside the work.
#pragma once

#include <deque>
#include <future>
#include <string>
#include <string_view>
#include <vector>

#include "engine/core/progress.h"
#include "engine/io/file.h"
#include "engine/report/document.h"

namespace lathelier::cli {

class Inputs {
public:
    /// `beside`: digests may use a thread of their own; else they wait until they are asked for.
    explicit Inputs(bool beside) : beside_(beside) {}

    /// Maps the file and starts its digest. The bytes live as long as this. Errors of FileBytes; throws Cancelled.
    std::string_view open(const std::string& path, const Progress& progress);

    /// The files opened so far, with their digests.
    std::vector<InputFile> files();

private:
    struct Entry {
        std::string path;
        FileBytes bytes;
        std::shared_future<std::string> sha256;
    };
    std::deque<Entry> entries_;
    bool beside_;
};

}  // namespace lathelier::cli
