// The queue of a batch in the archive's database: parts wait there, and workers on many machines take them one by one.
//
//   add: recipe + files ─► jobs (waiting) ─► a worker takes one (running, heartbeat) ─► archive, done
//                                             └ killed: lost after a while, waits again, at most three tries
//
// A part is queued once (its key: Evaluation::key()). A worker adds the evaluation to the archive, which takes no key
// twice, and marks the job after it: killed at any moment it loses nothing and doubles nothing. PostgreSQL gives each
// worker another row (FOR UPDATE SKIP LOCKED); a file is held by one writer at a time, and serves one machine.
//
// Errors: those of the archive; archiveNotWritten without the right to it.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "engine/archive/archive.h"
#include "engine/batch/failures.h"
#include "engine/batch/part_list.h"
#include "engine/batch/recipe.h"
#include "engine/core/json.h"

namespace lathelier::queue {

inline constexpr int mostTries = 3;

struct Queued {
    std::string recipe_sha256;
    std::int64_t queued = 0;
    std::int64_t already_there = 0;        ///< queued before, in any state, or their content twice
    std::vector<batch::Failure> failures;  ///< parts whose files cannot be read: not queued
};

/// `recipe_path`: of its file, which workers open; as the files of the parts it has to be reachable for them under the
/// same name. Throws Cancelled; what was queued before stays.
Queued enqueue(archive::Archive& archive, const std::string& recipe_path, const batch::Recipe& recipe,
               const std::vector<batch::Part>& parts, const Progress& progress = {});

/// A part as a worker takes it.
struct Job {
    std::int64_t id = 0;
    std::string key;            ///< of its evaluation
    std::string recipe_sha256;  ///< identity of the recipe when it was queued
    std::string recipe_path;
    batch::Part part;
    std::int64_t tries = 0;  ///< this one included
};

/// Takes the next job for `worker`: the first that waits, or whose worker has given no sign of life for `lost_after_s`.
/// Those that were lost three times fail first. None: there is nothing to take now.
std::optional<Job> take(archive::Archive& archive, const std::string& worker, double lost_after_s);

/// A sign of life.
void beat(archive::Archive& archive, const Job& job, const std::string& worker);

/// Only the worker that holds the job changes it; of another nothing happens.
void finish(archive::Archive& archive, const Job& job, const std::string& worker);
void fail(archive::Archive& archive, const Job& job, const std::string& worker, const Error& error);
void giveBack(archive::Archive& archive, const Job& job, const std::string& worker);  ///< it waits again, untried

/// After a failure of disk, memory or another program: it waits again, or fails after the last try.
void retryLater(archive::Archive& archive, const Job& job, const std::string& worker, const Error& error);

struct FailedJob {
    std::string name;  ///< path of the part's first file
    std::int64_t tries = 0;
    std::string error;  ///< as JSON: code and named values
};

struct QueueState {
    std::int64_t waiting = 0;
    std::int64_t running = 0;
    std::int64_t done = 0;
    std::int64_t failed = 0;
    std::vector<FailedJob> failures;  ///< in the order in which they were queued
};

/// Whether no part waits and none is being worked on.
bool isIdle(archive::Archive& archive);

QueueState stateOf(archive::Archive& archive);

/// Failed jobs wait again, with three tries. Returns how many.
std::int64_t retryFailed(archive::Archive& archive);

Json toJson(const QueueState& state);

}  // namespace lathelier::queue
