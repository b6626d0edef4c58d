// Suggested sizes that are put in place without a person: those that the measured part agrees with.
//
// A suggestion counts where Suggestion::agrees holds or a person confirmed it. Putting sizes in place moves what
// follows from them (a taper of nominal ratio between two nominal diameters gets another length): where a row would
// become longer or shorter by more than the U of its ends, what moves it is left as measured.
#pragma once

#include <vector>

#include "engine/features/nominal/accepted_sizes.h"

namespace lathelier::features {

struct AgreeingShaft {
    Shaft shaft;
    std::vector<AcceptedSize> left_out;  ///< suggested sizes of the outside that are not in place
};

/// Precondition: `segments` is not empty.
AgreeingShaft agreeingNominal(const Recognition& recognition, const std::vector<AcceptedSize>& confirmed);

}  // namespace lathelier::features
