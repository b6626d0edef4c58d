// A roundness result as the values of its plots and tables.
#pragma once

#include "engine/form/roundness.h"
#include "engine/report/document.h"
#include "widgets/plot/plot_data.h"
#include "widgets/plot/polar_data.h"

namespace lathelier {

/// Amplitudes from 2 undulations a turn on (1 is the place, not the form); the crosshair says what they usually mean.
PlotData spectrumData(const form::RoundnessResult& result);

/// The four circles: deviations, radius, centre, how sure.
Table circleTable(const form::RoundnessResult& result);

/// Strongest harmonics with their share and meaning.
Table hintTable(const form::RoundnessResult& result);

/// The polar plot with one harmonic drawn as a further trace.
PolarPicturePtr withHarmonic(const PolarPicturePtr& picture, const signal::Harmonic& harmonic);

}  // namespace lathelier
