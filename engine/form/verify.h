// "Verify installation": refits reference data whose answers are known, and says how far off it is.
#pragma once

#include <string>
#include <vector>

#include "engine/core/progress.h"
#include "engine/core/text.h"

namespace lathelier::form {

/// All sets that check one thing.
struct VerifyKind {
    std::string kind;  ///< stable key, "minimum_zone_circle"
    Text name;         ///< for people
    int sets = 0;
    double largest_deviation = 0;  ///< from the known answers
    Text unit;                     ///< empty: relative
    double limit = 0;
    bool pass = false;  ///< largest_deviation ≤ limit
};

struct VerifyResult {
    std::vector<VerifyKind> kinds;
    std::string reference_data;  ///< the folder of the NIST sets; empty: none was named, and they have no kind
    bool pass = false;           ///< all kinds
};

/// Circles: whole turns and quarter arcs, also a thousand radii off, with deviations that leave the least-squares
/// answer exact; lobes, ellipse, nested squares and Reuleaux triangle for the other three; scattered points against
/// all their possible contacts; the certificate's gap. Cylinders in several poses, straightness, the Gaussian filter
/// and harmonics. The NIST circle sets (`.ds`, `.fit`) of the folder `reference_data`, when one is named; it is looked
/// for nowhere else. Errors: fileNotFound, notAFile, fileNotReadable, malformed, referenceDataMissing (a folder without
/// circle sets: that says nothing of this installation). Throws Cancelled.
VerifyResult verify(const std::string& reference_data = {}, const Progress& progress = {});

}  // namespace lathelier::form
