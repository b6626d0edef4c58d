// A roundness result as tables, and what the panel adds to its polar plot.
#pragma once

#include "engine/form/roundness.h"
#include "engine/report/document.h"
#include "widgets/plot/polar_data.h"

namespace lathelier {

/// The four circles: deviations, radius, centre, how sure.
Table circleTable(const form::RoundnessResult& result);

/// Strongest harmonics with their share and meaning.
Table hintTable(const form::RoundnessResult& result);

/// The polar plot with one harmonic drawn as a further trace.
PolarPicturePtr withHarmonic(const PolarPicturePtr& picture, const signal::Harmonic& harmonic);

}  // namespace lathelier
