// Tables of a roundness result, and additions of the panel to its polar plot.
#pragma once

#include "engine/form/roundness/roundness.h"
#include "engine/report/document.h"
#include "widgets/plot/polar_data.h"

namespace lathelier::roundness_panel {

/// Strongest harmonics with their share and meaning.
report::Table hintTable(const form::RoundnessResult& result);

/// The polar plot with one harmonic drawn as a further trace.
plot::PolarPicturePtr withHarmonic(const plot::PolarPicturePtr& outcome, const signal::Harmonic& harmonic);

}  // namespace lathelier::roundness_panel
