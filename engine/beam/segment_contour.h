// The contour of one segment of a shaft: cylinder, cone or arc.
#pragma once

#include "engine/shaft/shaft.h"

namespace lathelier::beam {

/// Precondition unless the length is zero: an arc radius is at least half its chord.
class SegmentContour {
public:
    explicit SegmentContour(const ShaftSegment& segment);

    bool isCylinder() const { return side_ == 0 && start_mm_ == end_mm_; }

    /// Radius at `at_mm` from the segment's start.
    double radiusAt_mm(double at_mm) const;

private:
    double length_mm_, start_mm_, end_mm_;
    double radius_mm_ = 0, centreZ_mm_ = 0, centreR_mm_ = 0;
    double side_ = 0;  // 1 convex, -1 concave, 0 no arc
};

}  // namespace lathelier::beam
