// The sections along the workpiece: taper, barrel, straightness, cylindricity.
#pragma once

#include <optional>
#include <vector>

#include "engine/trajectory/trajectory.h"

namespace lathelier::trajectory {

/// Longitudinal section of at least three sections, all of known z, at three different places; otherwise none, with the
/// note zUnknown or tooFewSections. A stack too short for an axis has no cylindricity (note noCylindricity).
std::optional<LongitudinalSection> longitudinalSection(const std::vector<TrajectorySection>& sections, Notes& notes,
                                                       const Progress& progress = {});

/// c0, c1, c2 of value(u) = c0 + c1 u + c2 u² by least squares, u running from -1 to 1 over the extent of `z_mm`.
std::array<double, 3> fitParabola(const std::vector<double>& z_mm, const std::vector<double>& values);

}  // namespace lathelier::trajectory
