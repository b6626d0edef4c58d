// One section: from the revolutions of its record to the image of the surface and the motion of the spindle.
#pragma once

#include "engine/trajectory/record_plan.h"
#include "engine/trajectory/trajectory.h"

namespace lathelier::trajectory {

/// All members of a section except its number, position and names. Errors tooFewRevolutions, those of roundness().
TrajectorySection evaluate(const PreparedRecord& prepared, const RecordSegment& segment,
                           const TrajectoryParameters& parameters, double workpiece_diameter_mm,
                           const Progress& progress);

/// The same from averages over `revolutions` (0: not known).
TrajectorySection evaluate(const io::AveragedSection& averages, int revolutions, const TrajectoryParameters& parameters,
                           double workpiece_diameter_mm, const Progress& progress);

}  // namespace lathelier::trajectory
