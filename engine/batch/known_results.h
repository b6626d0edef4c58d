// What a folder of results already holds: the keys of all evaluations, 16 bytes each, so that a run continues where
// another ended, whatever became of it.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "engine/core/conformity.h"
#include "engine/core/json.h"
#include "engine/core/progress.h"

namespace lathelier::batch {

/// What came out for a part.
enum class Standing : std::uint8_t { Pass, Fail, Undecided, None, Failed };

/// None is "answered, nothing to judge".
Standing standingOf(const std::optional<Verdict>& verdict);

/// results.jsonl and those of shards, in byte order of their names.
std::vector<std::string> resultsIn(const std::string& folder);

/// Of the first lines of all results of the folder. Errors: batchOtherRecipe where one is of another recipe than
/// `recipe_sha256`; malformed (path, line) where it is of none.
void requireRecipe(const std::string& folder, const std::string& recipe_sha256);

/// The first bytes of Evaluation::key(), which tell keys apart.
using KeyBegin = std::array<std::uint8_t, 15>;
KeyBegin beginOf(const std::string& key);

class KnownResults {
public:
    /// Reads the complete lines of all results of the folder. Errors: malformed (path, line). Throws Cancelled.
    KnownResults(const std::string& folder, const Progress& progress);

    /// `key`: Evaluation::key(). None: not there.
    std::optional<Standing> find(const std::string& key) const;

private:
    struct Entry {
        KeyBegin key;
        Standing standing;
    };
    static_assert(sizeof(Entry) == 16);

    std::vector<Entry> entries_;  ///< in order of the keys
};

/// Calls use(line) for the evaluation of each of `keys` that is there without an answer; the keys in order.
void forFailed(const std::string& folder, const std::vector<std::string>& keys,
               const std::function<void(const std::string& key, const Json& line)>& use, const Progress& progress);

}  // namespace lathelier::batch
