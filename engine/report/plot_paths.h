// Curves and regions as SVG paths: cut at the frame, broken where there are no data, thinned to what a sheet can show.
#pragma once

#include <string>

#include "engine/report/plot_frame.h"

namespace lathelier::report {

/// The points a curve can be drawn from.
std::size_t lengthOf(const Curve& curve);

/// The line of a curve; a lone point shows as a dot. Beyond the frame's height it runs along the edge.
std::string linePath(const PlotFrame& frame, const Curve& curve);

/// A disc for each sample inside the frame.
std::string pointsPath(const PlotFrame& frame, const Curve& curve, double radius_px);

std::string bandPath(const PlotFrame& frame, const Curve& curve);
std::string barsPath(const PlotFrame& frame, const Curve& curve);

/// The part of the polygon inside the frame; empty when there is none.
std::string regionPath(const PlotFrame& frame, const Region& region);

std::string discPath(double x, double y, double radius_px);

}  // namespace lathelier::report
