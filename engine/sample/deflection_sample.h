// Programs for slender shafts in the sample project, with machine and stock.
#pragma once

#include "engine/core/sample_part.h"

namespace lathelier::sample {

/// case_a.nc with case_a_setup.json and case_a_stock.txt: the shaft of G. Grossi et al., "A digital solution for
/// slender workpiece turning: the DRITTO project", case A. stepped.nc with stepped_setup.json and stepped_stock.txt: a
/// shaft of our own in three passes, with a cone; the panels of Deflection open it.
const SamplePart& deflectionSample();

}  // namespace lathelier::sample
