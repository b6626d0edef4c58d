// Polar plots of a report as SVG.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/report/chart.h"

namespace lathelier::report {

/// Deviations drawn around the base circle with grid circles and degrees; the magnification, and what a grid division
/// is, are stated beside it with the legend. Long traces are thinned to the smallest and largest value in each quarter
/// degree.
std::string toSvg(const PolarPlot& plot, const Language& language = {});

/// A place in the drawing, seen from the plot's centre: x to the right, y upward.
struct PolarPlace {
    double x_px = 0, y_px = 0;
};

/// The number of a ring, and where its middle stands; nowhere when it has no room beside the numbers before it.
struct RingLabel {
    double radius_px = 0;
    double width_px = 0, height_px = 0;
    std::optional<PolarPlace> place{};
};

/// Places the labels on one ray between two of degrees: where least of what is drawn lies on them, and beside their
/// ring rather than on a curve that runs along it.
void placeRingLabels(std::vector<RingLabel>& labels, const std::vector<PolarPlace>& drawn, double rim_px);

/// What `plot.magnification` stands for when it is not given: 1, 2 or 5 × 10^n, so that all fits between the core and
/// the rim. 1 for a plot without deviations.
double fittingMagnification(const PolarPlot& plot);

}  // namespace lathelier::report
