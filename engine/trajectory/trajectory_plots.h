// Charts of records and trajectories, for the window and the report.
#pragma once

#include "engine/report/chart.h"
#include "engine/trajectory/trajectory.h"

namespace lathelier::trajectory {

/// The angle on the part of each sample of a section, 0…360, as the polar plots have it.
std::vector<double> partAngles_deg(const TrajectorySection& section);

/// Radius along the workpiece about its mean: the sections, their line (taper) and their parabola (barrel).
report::Plot longitudinalPlot(const LongitudinalSection& section, const Language& language = {});

/// RONt of every section along the workpiece (or by number without z), with the tolerance.
report::Plot roundnessAlongAxis(const TrajectoryResult& result);

/// Trajectories of the workpiece's axis and of the tool in one plane; those of `others` in faint lines.
report::Plot trajectoryPlot(const TrajectorySection& section, const Language& language = {},
                            const std::vector<TrajectorySection>& others = {});

/// Means of the four probes and the radius vector's change over the angle.
report::Plot coordinatesPlot(const TrajectorySection& section, const Language& language = {});

/// The radius with the envelope of single revolutions; for averages the radius alone.
report::Plot envelopePlot(const TrajectorySection& section);

/// Signals over time with the revolution marks; as recorded while the channel map is unusable.
report::Plot signalsPlot(const std::vector<TimeSignal>& recorded, const Language& language = {});

/// Error motion of one probe (ISO 230-7): every revolution and the synchronous curve around the workpiece's circle, k =
/// 0 and 1 removed.
report::PolarPlot errorMotionPlot(const TrajectorySection& section, double workpiece_diameter_mm,
                                  Probe probe = Probe::X3, const Language& language = {});

}  // namespace lathelier::trajectory
