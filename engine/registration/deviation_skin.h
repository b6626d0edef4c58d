// The closed surface of a turned reference with the copy's deviation at its vertices: what the views draw of a
// comparison.
#pragma once

#include "engine/core/progress.h"
#include "engine/core/skin.h"
#include "engine/registration/compare.h"

namespace lathelier::registration {

/// The reference's surface from its windows' stretches: sides, bores, faces; where the scan shows no face an end is
/// closed by a disc. Values: meansOf() with colourSigmaLimit_mm(), in mm; NaN where they are not significant, on such a
/// disc and on what lies between stretches. In the frame of axis_T_reference. Empty (no stations) where there is no
/// axis, or no windows. The same bits for any number of threads. Throws Cancelled.
Skin deviationSkin(const CompareResult& result, const Progress& progress = {});

}  // namespace lathelier::registration
