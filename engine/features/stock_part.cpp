#include "engine/features/stock_part.h"

#include "engine/shaft/shaft_contour.h"

namespace lathelier::features {

Shaft outOfChuck(const Shaft& shaft, double chucked_mm)
{
    Shaft out = beamView(shaft);
    while (chucked_mm > 0 && !out.segments.empty()) {
        ShaftSegment& last = out.segments.back();
        if (last.length_mm > chucked_mm) {
            const ContourPiece contour{{0, last.start_diameter_mm / 2},
                                       {last.length_mm, last.end_diameter_mm / 2},
                                       last.arc_radius_mm.value_or(0)};
            const double left_mm = last.length_mm - chucked_mm;
            last.end_diameter_mm = 2 * contour.radiusAt_mm(left_mm);
            last.length_mm = left_mm;
            return out;
        }
        chucked_mm -= last.length_mm;
        out.segments.pop_back();
    }
    return out;
}

}  // namespace lathelier::features
