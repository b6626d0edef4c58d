// The charts of a recognition: the meridian with its rows, and under it the residuals between data and rows. Both have
// the same range of z and are aligned.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "engine/features/recognition.h"
#include "engine/report/chart.h"

namespace lathelier::features {

/// The contour of a row as points (z, r) in mm, arcs cut finely; `bore`: the row is one of a bore.
std::vector<Eigen::Vector2d> contourOf(const RecognizedRow& row, bool bore = false);

/// The part above and below its axis: rows by kind, bores, the bins of the data, marks and stretches without data. The
/// largest cylinders carry their diameters, features their designation.
report::Plot meridianPlot(const Recognition& result, const Language& language = {});

/// Bins minus rows along z in µm, with twice their standard uncertainty and the form tolerance.
report::Plot residualPlot(const Recognition& result);

/// Every bin: z, radius, its standard uncertainty, residual, row.
std::string meridianCsv(const Recognition& result);

}  // namespace lathelier::features
