#include "engine/receptance/shaft/shaft_contour.h"

#include <algorithm>

#include "engine/beam/segment_contour.h"

namespace lathelier::receptance {
namespace {

constexpr int piecesOfArc = 40;

}  // namespace

ShaftContour contourOf(const Shaft& shaft)
{
    ShaftContour contour;
    double z_mm = 0;
    for (const ShaftSegment& segment : shaft.segments) {
        const beam::SegmentContour shape(segment);
        const int pieces = segment.arc_radius_mm && segment.length_mm > 0 ? piecesOfArc : 1;
        for (int i = 0; i <= pieces; ++i) {
            const double at_mm = segment.length_mm * i / pieces;
            const double radius_mm = i == 0        ? segment.start_diameter_mm / 2
                                     : i == pieces ? segment.end_diameter_mm / 2
                                                   : shape.radiusAt_mm(at_mm);
            contour.z_mm.push_back(z_mm + at_mm);
            contour.radius_mm.push_back(radius_mm);
            contour.bore_mm.push_back(segment.bore_diameter_mm / 2);
            contour.largest_mm = std::max(contour.largest_mm, radius_mm);
        }
        z_mm += segment.length_mm;
    }
    return contour;
}

}  // namespace lathelier::receptance
