// The motion of spindle and tool in one section, as a report.
#pragma once

#include "engine/report/document.h"
#include "engine/trajectory/trajectory.h"

namespace lathelier::trajectory {

/// Error motion of every probe, trajectories, method. The form of the workpiece is in trajectoryReport(). `notes`: of
/// the result and its files.
report::Document motionReport(const report::Answer& answer, const TrajectoryResult& result,
                              const TrajectorySection& section, const Notes& notes, const Language& language = {});

}  // namespace lathelier::trajectory
