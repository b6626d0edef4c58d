// Trajectories, geometric images and the longitudinal section as a report, and as one sentence.
#pragma once

#include <vector>

#include "engine/report/document.h"
#include "engine/trajectory/trajectory.h"

namespace lathelier::trajectory {

/// "RONt(MZCI) 9.4 µm (section 7 of 20) · taper +16.0 µm on diameter · barrel 5.0 µm": the worst section first.
report::Answer answer(const TrajectoryResult& result, const Language& language = {});

/// Error motion of the workpiece axis in one section of `result`, measured by probe X3 (ISO 230-7).
report::Answer motionAnswer(const TrajectoryResult& result, const TrajectorySection& section);

/// Answer, longitudinal figures, verdict and notes: what the command line prints.
report::Section trajectorySummary(const TrajectoryResult& result, const Language& language = {});

/// One row for each section: deviation by the chosen reference circle with its verdict, size, place, run-out.
report::Table sectionsTable(const TrajectoryResult& result);

/// What was computed, how, and with which parameters: the last section of a report.
report::Section trajectoryMethod(const TrajectoryResult& result, const Language& language = {});

/// Longitudinal section and table of all sections against tolerance; image and trajectories of the worst section;
/// error motion of the spindle; cutting data; method and parameters; notes.
report::Document trajectoryReport(const TrajectoryResult& result, const std::vector<InputFile>& inputs,
                                  const Language& language = {});

}  // namespace lathelier::trajectory
