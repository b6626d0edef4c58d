// The meridian of a shaft as a chart to edit it in: outside, bores, and a handle at each place with a length dimension.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "engine/report/chart.h"
#include "engine/shaft/shaft.h"

namespace lathelier::drawing {

/// z across, radius upwards on both sides of the axis, to scale.
report::Plot meridianChart(const Shaft& shaft);

/// The row whose end the handle `key` moves (ShaftEdit's moveShoulder()); nothing for another handle.
std::optional<std::size_t> rowOfShoulder(const std::string& key);

/// The contour of a row of the outside, arcs as steps of at most 5°, for marks in pictures: points (z, r).
std::vector<Eigen::Vector2d> contourOfRow(const Shaft& shaft, std::size_t row);

}  // namespace lathelier::drawing
