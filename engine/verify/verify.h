// "Verify installation": refits the rooms' reference data whose answers are known, and says how far off it is.
#pragma once

#include <string>
#include <vector>

#include "engine/core/verification.h"

namespace lathelier::verify {

struct VerifyResult {
    std::vector<VerifyKind> kinds;  ///< one for each check that was run
    std::string reference_data;     ///< the folder of further sets; empty: none was named, and they have no kind
    bool pass = false;              ///< all kinds
};

/// The parts of all rooms: a new room with checks is one line there.
const std::vector<const VerifyPart*>& verifyParts();

/// Runs the checks of `parts`, and those on the data of the folder `reference_data`, when one is named; it is looked
/// for nowhere else. Errors: fileNotFound, notAFile, fileNotReadable, malformed, referenceDataMissing (a folder without
/// such data: that says nothing of this installation). Throws Cancelled.
VerifyResult verify(const std::vector<const VerifyPart*>& parts, const std::string& reference_data = {},
                    const Progress& progress = {});

}  // namespace lathelier::verify
