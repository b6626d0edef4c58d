// Single nominal sizes that a person has accepted, applied to the shaft, with the measured ones kept. All of them at
// once are Snap::Apply.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "engine/features/recognition.h"
#include "engine/features/refit/row_change.h"

namespace lathelier::features {

struct AcceptedSize {
    std::int64_t row = 0;  ///< of Recognition::segments, from 1
    std::string quantity;  ///< Suggestion::quantity
    friend bool operator==(const AcceptedSize&, const AcceptedSize&) = default;
};

/// "2:diameter_mm,5:radius_mm": as the parameters of a project keep them. Entries that are not understood are left out.
std::vector<AcceptedSize> acceptedSizes(std::string_view text);
std::string textOf(const std::vector<AcceptedSize>& accepted);

/// The accepted sizes when the rows are changed (refit.h): those of the changed rows are gone, rows after them have
/// other numbers.
std::vector<AcceptedSize> afterChange(std::vector<AcceptedSize> accepted, const RowChange& change);

/// The shaft with the accepted sizes in place (snap.h), the measured ones in ShaftSegment::measured; with Snap::Apply
/// besides those that agree (agreeing_sizes.h). Sizes that are no longer suggested are ignored. With Snap::None and
/// with the published method the shaft is returned as it is.
Shaft withAccepted(const Recognition& result, const std::vector<AcceptedSize>& accepted);

/// Note nominalNotApplied where Snap::Apply left suggested sizes out that no person accepted.
Notes notesOfSizes(const Recognition& result, const std::vector<AcceptedSize>& accepted);

}  // namespace lathelier::features
