#include "engine/beam/segment_contour.h"

#include <algorithm>
#include <cmath>

namespace lathelier::beam {

SegmentContour::SegmentContour(const ShaftSegment& segment)
    : length_mm_(segment.length_mm), start_mm_(segment.start_diameter_mm / 2), end_mm_(segment.end_diameter_mm / 2)
{
    if (!segment.arc_radius_mm || !(length_mm_ > 0)) return;
    radius_mm_ = std::abs(*segment.arc_radius_mm);
    side_ = *segment.arc_radius_mm > 0 ? 1 : -1;
    const double rise_mm = end_mm_ - start_mm_;
    const double chord_mm = std::hypot(length_mm_, rise_mm);
    // The centre lies on the perpendicular bisector of the chord: toward the axis for a convex arc.
    const double height_mm = side_ * std::sqrt(std::max(0.0, radius_mm_ * radius_mm_ - chord_mm * chord_mm / 4));
    centreZ_mm_ = length_mm_ / 2 + height_mm * rise_mm / chord_mm;
    centreR_mm_ = (start_mm_ + end_mm_) / 2 - height_mm * length_mm_ / chord_mm;
}

double SegmentContour::radiusAt_mm(double at_mm) const
{
    if (side_ == 0) return length_mm_ > 0 ? start_mm_ + (end_mm_ - start_mm_) * at_mm / length_mm_ : start_mm_;
    const double z_mm = at_mm - centreZ_mm_;
    return centreR_mm_ + side_ * std::sqrt(std::max(0.0, radius_mm_ * radius_mm_ - z_mm * z_mm));
}

}  // namespace lathelier::beam
