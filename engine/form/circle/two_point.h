// Sizes across a section: two-point size through the centre, and width between parallel jaws.
// Source: ISO 14405-1 (two-point size); rotating calipers of Shamos (1978) and Toussaint (1983).
#pragma once

#include <span>

#include "engine/form/roundness/roundness.h"
#include "engine/signal/angular_sampling.h"

namespace lathelier::form {

/// `points_mm` in order of angle about `centre_mm`, with those angles (ascending). Where no point lies opposite, the
/// profile is interpolated between its neighbours, never beyond its extremes, so that the range is at most
/// 2 · RONt(LSCI); across gaps there is no size.
TwoPointSize twoPointSize(std::span<const Eigen::Vector2d> points_mm, const signal::AngularSampling& sampling,
                          const Eigen::Vector2d& centre_mm, const Progress& progress = {});

/// Largest and smallest width of the points between parallel jaws (rotating calipers on the convex hull).
struct CaliperWidth {
    double largest_mm = 0, smallest_mm = 0;
};
CaliperWidth caliperWidth(std::span<const Eigen::Vector2d> points_mm);

}  // namespace lathelier::form
