// Single nominal sizes that a person has accepted, put into the shaft beside what was measured. All of them at once are
// Snap::Apply.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "engine/features/recognition.h"

namespace lathelier::features {

struct AcceptedSize {
    std::int64_t row = 0;  ///< of Recognition::segments, from 1
    std::string quantity;  ///< Suggestion::quantity
    friend bool operator==(const AcceptedSize&, const AcceptedSize&) = default;
};

/// "2:diameter_mm,5:radius_mm": as the parameters of a project keep them. What is not understood is left out.
std::vector<AcceptedSize> acceptedSizes(std::string_view text);
std::string textOf(const std::vector<AcceptedSize>& accepted);

/// Can this suggestion be accepted alone? A leg, a taper and an undercut change several rows at once: they can not.
bool isAcceptedAlone(const Suggestion& suggestion);

/// The shaft with the accepted sizes, the measured ones in ShaftSegment::measured; a neighbour that met the old size
/// follows. Of sizes that are no longer suggested nothing is taken. With Snap::Apply the shaft as it is.
Shaft withAccepted(const Recognition& result, const std::vector<AcceptedSize>& accepted);

}  // namespace lathelier::features
