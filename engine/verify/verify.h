// "Verify installation": refits reference data with known answers and reports the deviations.
#pragma once

#include <string>
#include <vector>

#include "engine/core/verification.h"

namespace lathelier::verify {

struct VerifyResult {
    std::vector<VerifyKind> kinds;  ///< one for each check that was run
    std::string reference_data;     ///< folder of further sets; empty: none was given
    bool pass = false;              ///< true: all kinds passed
};

/// The parts of all rooms; a new room with checks adds one line in verify.cpp.
const std::vector<const VerifyPart*>& verifyParts();

inline constexpr const char* allTopics = "all";

/// The parts of one topic; "all": of all. Error valueNotUnderstood lists the topics.
std::vector<const VerifyPart*> partsOf(const std::string& topic);
std::vector<std::string> topics();

/// Runs the checks of `parts`, and those on the data of the folder `reference_data`, when one is given. Errors:
/// fileNotFound, notAFile, fileNotReadable, malformed, referenceDataMissing (a folder without such data). Throws
/// Cancelled.
VerifyResult verify(const std::vector<const VerifyPart*>& parts, const std::string& reference_data = {},
                    const Progress& progress = {});

}  // namespace lathelier::verify
