// "Verify installation": refits reference data whose answers are known, and says how far off it is.
#pragma once

#include <string>
#include <vector>

#include "engine/core/progress.h"
#include "engine/core/text.h"

namespace lathelier {

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
    std::string nist_directory;  ///< empty: the NIST sets were not there, and have no kind
    bool pass = false;           ///< all kinds
};

/// Circles: whole turns and quarter arcs, also a thousand radii off, with deviations that leave the least-squares
/// answer exact; lobes, ellipse, nested squares and Reuleaux triangle for the other three; scattered points against
/// all their possible contacts; the certificate's gap. Cylinders in several poses, straightness, the Gaussian filter
/// and harmonics. The NIST circle sets (`.ds`, `.fit`) when `nist_directory` or, if that is empty, the practice data
/// beside the current folder hold them. Errors: fileNotFound, fileNotReadable, malformed of a directory given. Throws
/// Cancelled.
VerifyResult verify(const std::string& nist_directory = {}, const Progress& progress = {});

}  // namespace lathelier
