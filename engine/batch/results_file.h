// results.jsonl: the recipe on the first line, {"recipe": {…}, "sha256": "…"}, then one evaluation a line
// (archive/evaluation.h), in the order of the parts. A part without an answer has the member "message" besides, its
// error in English.
#pragma once

#include <chrono>
#include <cstdint>
#include <string>

#include "engine/core/json.h"

namespace lathelier::batch {

/// The i-th of n processes that share the parts; 1 of 1 has all.
struct Shard {
    std::int64_t number = 1;  ///< from 1
    std::int64_t count = 1;

    /// "results.jsonl"; of several "results-0003-of-0010.jsonl".
    std::string fileName(const std::string& stem, const std::string& suffix) const;
};

/// "3/10". Error valueNotUnderstood.
Shard shardFrom(const std::string& stated);

/// The only writer of one file of results. Each line is written at once and stays there when the process is killed;
/// what was written of a line when it was killed is cut off by the next writer. On the disk at most a second later.
class ResultsFile {
public:
    /// Makes the file, with `recipe` as its first line. Errors: batchUnderWay where another process writes it,
    /// fileNotWritable.
    ResultsFile(std::string path, const Json& recipe);
    ~ResultsFile();
    ResultsFile(const ResultsFile&) = delete;
    ResultsFile& operator=(const ResultsFile&) = delete;

    /// `line` without its end. Error fileNotWritable: nothing of it is left.
    void append(std::string line);

    /// On the disk. Error fileNotWritable.
    void flush();

private:
    void cutTornLine();
    [[noreturn]] void fail(int problem) const;

    std::string path_;
    int descriptor_ = -1;
    std::int64_t size_ = 0;  ///< of what was written whole, in bytes
    std::chrono::steady_clock::time_point flushed_;
    bool isFlushed_ = true;
};

}  // namespace lathelier::batch
