// A shaft as charts: its meridian section with dimensions and supports, the shapes of its modes.
#pragma once

#include <optional>
#include <string>

#include "engine/receptance/shaft/shaft_study.h"
#include "engine/report/chart.h"

namespace lathelier::receptance {

/// The section to scale, z from the free end, with axis, diameters, lengths and supports. With `handles` the end of
/// each segment is draggable; shafts of more than 12 segments have neither handles nor dimensions.
report::Plot shaftDrawing(const Shaft& shaft, const ShaftHolding& holding, bool handles = false,
                          const Language& language = {});

/// The segment whose end the handle `key` moves; none for another handle.
std::optional<std::size_t> segmentOfHandle(const std::string& key);

/// The shaft with the end of a segment moved to z and a radius: the segment is lengthened at the expense of its
/// neighbour toward the chuck, the last one lengthens the shaft; a cylinder remains a cylinder. Length and diameter are
/// rounded to 0.1 mm. The neighbour's length and the wall beside the bore stay at least 0.1 mm.
Shaft dragged(Shaft shaft, std::size_t segment, double z_mm, double radius_mm);

/// Deflection of the first modes along the shaft, scaled by `swing` (-1 to 1).
report::Plot modeShapesPlot(const ShaftStudy& study, double swing = 1, const Language& language = {});

}  // namespace lathelier::receptance
