// Curves and regions as SVG paths: clipped at the frame, broken at missing data, decimated to the resolution of a
// sheet.
#pragma once

#include <string>

#include "engine/report/plot_frame.h"

namespace lathelier::report {

/// The finite points of a curve.
std::size_t lengthOf(const Curve& curve);

/// The line of a curve; an isolated point is a dot. Outside the frame's height the line follows the edge.
std::string linePath(const PlotFrame& frame, const Curve& curve);

/// A disc for each sample inside the frame.
std::string pointsPath(const PlotFrame& frame, const Curve& curve, double radius_px);

std::string bandPath(const PlotFrame& frame, const Curve& curve);
std::string barsPath(const PlotFrame& frame, const Curve& curve);

/// The part of the polygon inside the frame; empty when there is none.
std::string regionPath(const PlotFrame& frame, const Region& region);

std::string discPath(double x, double y, double radius_px);

}  // namespace lathelier::report
