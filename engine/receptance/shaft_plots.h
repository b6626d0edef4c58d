// A shaft as charts: its meridian section with dimensions and supports, the shapes of its modes.
#pragma once

#include <optional>
#include <string>

#include "engine/receptance/shaft_study.h"
#include "engine/report/chart.h"

namespace lathelier::receptance {

/// The section to scale, z from the free end, with axis, diameters, lengths and what holds it. With `handles` the end
/// of each segment may be dragged; shafts of more than 12 segments have none, and no dimensions.
report::Plot shaftDrawing(const Shaft& shaft, const ShaftHolding& holding, bool handles = false,
                          const Language& language = {});

/// The segment whose end the handle `key` moves; nothing for another handle.
std::optional<std::size_t> segmentOfHandle(const std::string& key);

/// The shaft with the end of a segment dragged to z and a radius: the segment grows at the cost of its neighbour toward
/// the chuck, the last one by itself; a cylinder stays one. Rounded to 0.1 mm, of the diameter too. A neighbour keeps
/// 0.1 mm, a wall 0.1 mm beside the bore.
Shaft dragged(Shaft shaft, std::size_t segment, double z_mm, double radius_mm);

/// Deflection of the first modes along the shaft, `swing` (-1 to 1) of their largest one.
report::Plot modeShapesPlot(const ShaftStudy& study, double swing = 1, const Language& language = {});

}  // namespace lathelier::receptance
