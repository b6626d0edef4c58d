// The result of a comparison as the values of its plots.
#pragma once

#include "engine/report/colours.h"
#include "widgets/compare/compare_picture.h"
#include "widgets/plot/plot_data.h"

namespace lathelier {

/// The unrolled z × angle map; empty where there is none.
MapData compareMap(const registration::CompareResult& result);

/// Reference profile and the copy's, whose deviation is drawn `magnification` times larger; empty where there is none.
PlotData compareMeridian(const registration::CompareResult& result, double magnification);

/// Histogram with the normal curve of the same mean and scatter. With a tolerance the bars are coloured by it, and the
/// two limits can be dragged; they are the plot's first two limits, lower one first.
PlotData compareHistogram(const registration::CompareResult& result, double limit_mm);

}  // namespace lathelier
