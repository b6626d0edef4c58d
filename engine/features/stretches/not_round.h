// Stretches that are not round: eccentrics, hexagons and squares, splines and serrations, deep threads and worms.
//
//   runs of equal sections (sections.h) ─► points of a run ─► eccentricOf(), prismOf(), splineOf() ─► its ends
//   runs of deep ones ────────────────────────────────────► helixOf() ────────────────────────────┘
//
// A stretch is named only where one of these shapes explains its points within their noise; all others stay what the
// rest of the recognition makes of them. What is named is made round (rounding.h), so that the table has one row there:
// the own diameter of an eccentric, the circle over the corners of a prism, the crests of teeth and threads.
#pragma once

#include <vector>

#include "engine/features/stretches/section_shape.h"
#include "engine/features/walls/walls.h"
#include "engine/registration/revolution/revolution_axis.h"

namespace lathelier::features {

/// The round beyond an end of a stretch, where gaps or faces go on: a chamfer.
struct RoundBeyond {
    double at_mm = 0, radius_mm = 0, slope = 0;
    bool is_explained = true;  ///< the points there lie on it or on the shape: an end of the part there is seen

    double radiusAt_mm(double z_mm) const { return radius_mm + slope * (z_mm - at_mm); }
};

/// z in the frame of the fit.
struct NotRoundStretch {
    SectionShape shape;
    ShaftMark mark;  ///< as the fit's frame has it; z of what was cut: further than `from_mm` on a chamfer
    double from_mm = 0, to_mm = 0;         ///< where the section is the same
    RoundBeyond before = {}, behind = {};  ///< between these and the ends of the mark
};

/// In order of z. `sigma_mm`: noise of single points. Throws Cancelled.
std::vector<NotRoundStretch> notRoundStretches(const MeridianCloud& cloud, double sigma_mm,
                                               const registration::RevolutionFit& fit, const Progress& progress = {});

}  // namespace lathelier::features
