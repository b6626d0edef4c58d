// Spurious bins of a radius profile caused by noise on a face across the axis.
#pragma once

#include <vector>

#include "engine/registration/revolution/revolution_axis.h"

namespace lathelier::registration {

/// Where a scan shows a face, noise along the axis gives single bins beside it a radius between those of its two sides,
/// or beyond the end of the part. They would split a shoulder. A run of bins no longer than that noise reaches, with a
/// step to its neighbours, is no land of the part: its radius becomes unknown. Three such runs in a row are a slope,
/// and stay, unless they lie beside unknown bins, where the face is, and no further from them than noise reaches.
/// `sigma_mm`: scatter of the points.
void clearFaceBins(RadiusProfile& profile, double sigma_mm);

/// The same for bins that look rough because they hold points of a face: a run of them between two sides of different
/// radius, or beyond an end, no longer than noise along the axis reaches. `rough_mm`: NaN where a bin is not rough.
void clearRoughFaceBins(std::vector<double>& rough_mm, const RadiusProfile& profile, double sigma_mm);

}  // namespace lathelier::registration
