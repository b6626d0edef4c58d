// Plots of trajectories, for the report.
#pragma once

#include "engine/report/document.h"
#include "engine/trajectory/trajectory.h"

namespace lathelier::trajectory {

/// Diameter along the workpiece, as measured and as the fitted parabola, about its mean.
Plot diameterAlongAxis(const LongitudinalSection& section);

/// RONt of every section along the workpiece (or by number without z), with the tolerance.
Plot roundnessAlongAxis(const TrajectoryResult& result);

/// Trajectories of the workpiece's axis and of the tool in one plane.
Plot trajectoryPlot(const TrajectorySection& section);

/// The radius with the envelope of single revolutions; for averages the radius alone.
Plot envelopePlot(const TrajectorySection& section);

/// Error motion of the sensitive direction: every revolution and the synchronous curve around a circle.
PolarPlot errorMotionPlot(const TrajectorySection& section, double workpiece_diameter_mm);

}  // namespace lathelier::trajectory
