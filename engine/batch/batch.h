// A recipe over many parts: a day's copies, or a computing centre's share of a series.
//
//   recipe + files ─► parts ─► (shard) ─► jobs side by side ─► lines in the order of the parts ─► results.jsonl
//
// One part that is refused never stops the others. A second run over the same folder computes nothing again: it takes
// over what is answered, and what was refused because of the part's content. The lines are the same bytes whatever
// the number of jobs, threads, runs and shards. Memory is bounded by the number of jobs: the recipe's files are read
// once, those of a part are given back with its line.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "engine/batch/failures.h"
#include "engine/batch/known_results.h"
#include "engine/batch/part_run.h"
#include "engine/batch/remembered_run.h"
#include "engine/batch/results_file.h"
#include "engine/report/document.h"

namespace lathelier::batch {

struct BatchSettings {
    std::string folder;     ///< of the results; made when it is missing
    Shard shard;            ///< parts are assigned to shards by their place in the list, in turn
    int jobs = 0;           ///< parts computed side by side; 0: as many as there are threads
    bool reports = false;   ///< a report of each answered part, reports/NAME.html
    CompleteFrom complete;  ///< what a shop makes; none: recipes with a shop are asked without it
    RememberedRun asked;    ///< remembered in the folder; without a recipe: nothing is
};

struct BatchResult {
    std::string task;           ///< key
    std::string recipe_sha256;  ///< identity
    std::int64_t parts = 0;     ///< of this shard: computed, taken over, duplicates, and those that cannot be read
    std::int64_t computed = 0;  ///< in this run
    std::int64_t taken_over = 0;
    std::int64_t duplicates = 0;             ///< parts with the content of an earlier one of this shard
    std::array<std::int64_t, 4> verdicts{};  ///< of answered parts, by Standing: pass, fail, undecided, none
    std::vector<Failure> failures;           ///< in the order of the parts
    Notes notes;                             ///< of duplicates
    std::string results_file;                ///< path
    std::string failures_file;               ///< path

    std::int64_t failed() const { return static_cast<std::int64_t>(failures.size()); }
    /// False: a part is out of tolerance or undecided; none: nothing was judged.
    std::optional<bool> pass() const;
};

/// Errors: those of requireUnchanged() and partsOf(); batchOtherRecipe, batchUnderWay, fileNotWritable, outputIsInput
/// for a folder whose files are the parts. What was finished stays after an error and after Cancelled, which it throws.
BatchResult runBatch(const std::vector<std::string>& inputs, const Recipe& recipe, const BatchSettings& settings,
                     const Progress& progress = {});

Json toJson(const BatchResult& result);

/// A short table; the failures, at most 100 of them.
report::Document batchReport(const BatchResult& result);

/// The same for people, without a heading.
std::string batchSummary(const BatchResult& result);

}  // namespace lathelier::batch
