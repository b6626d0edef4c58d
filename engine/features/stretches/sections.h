// Sections across the axis: the radius by sectors, and runs of equal sections that are not round.
//
// A section is a few tenths of a millimetre long. In each of its sectors the median of the outermost wall is taken.
// Neighbouring sections are alike where they differ by less than their own departure from a circle; a helix, which
// turns from section to section, makes no such run.
#pragma once

#include <vector>

#include "engine/core/progress.h"
#include "engine/features/walls/walls.h"

namespace lathelier::features {

/// A stretch along the axis whose sections are alike and not round.
struct SectionRun {
    double from_mm = 0, to_mm = 0;  ///< of its sections
    double least_mm = 0;            ///< least radius of a sector of a section
};

/// In order of z.
struct SectionRuns {
    std::vector<SectionRun> alike;
    std::vector<SectionRun> winding;  ///< of deep sections that are not alike: perhaps a helix
};

/// `sigma_mm`: noise of single points. Throws Cancelled.
SectionRuns notRoundRuns(const MeridianCloud& cloud, double sigma_mm, const Progress& progress = {});

}  // namespace lathelier::features
