// A worker of the queue: takes parts until none is left, computes them, and adds their evaluations to the archive.
#pragma once

#include <cstdint>
#include <string>

#include "engine/archive/archive.h"
#include "engine/batch/part_run.h"
#include "engine/batch/recipe.h"

namespace lathelier::queue {

struct WorkSettings {
    std::string location;              ///< of the archive
    std::string worker;                ///< name: of the machine and process; no other may have it
    archive::Attestation attestation;  ///< who answers for what it adds
    double lost_after_s = 60;          ///< a worker without a sign of life for so long is lost
    bool waits = false;                ///< for further parts, until it is stopped
};

struct Worked {
    std::int64_t computed = 0;       ///< parts that have an answer now
    std::int64_t already_there = 0;  ///< of those: their evaluation was in the archive
    std::int64_t refused = 0;        ///< parts without an answer: their evaluation says why
    std::int64_t put_back = 0;       ///< parts that a failure of this machine kept from an answer
};

/// "machine:process"
std::string nameOfThisWorker();

/// Works until no part waits and none is being worked on, so that those of lost workers are taken too. A part under way
/// is given back when it is stopped (Cancelled). Errors: those of the archive.
Worked work(const WorkSettings& settings, const batch::Tasks& tasks, const batch::CompleteFrom& complete,
            const Progress& progress = {});

}  // namespace lathelier::queue
