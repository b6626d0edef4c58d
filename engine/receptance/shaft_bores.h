// Blind or through bores stated apart from the contour, laid into the segments of a shaft.
#pragma once

#include <vector>

#include "engine/core/shaft.h"

namespace lathelier::receptance {

/// A bore from one end of the shaft.
struct Bore {
    bool from_free_end = true;           ///< false: from the chuck
    std::vector<ShaftSegment> segments;  ///< from the mouth inward; diameters are those of the bore
};

/// The shaft with its segments cut where its bores step; a bore that tapers is cut into 20 steps. Error
/// boresStatedTwice when segments have bores already; shaftSegmentUnusable for a bore longer than the shaft.
Shaft withBores(Shaft shaft, const std::vector<Bore>& bores);

}  // namespace lathelier::receptance
