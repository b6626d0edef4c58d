// The tasks over probe records. Trajectory: the image of the surface, its sections and the longitudinal section; the
// verb trajectory and the panel Longitudinal. Motion: the same evaluation, asked for the motion of spindle and tool in
// one section; the panel Trajectory.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "engine/trajectory/task/record_evaluation.h"

namespace lathelier::trajectory {

struct TrajectoryQuestion {
    bool no_filter = false;                       ///< the default, stated explicitly: no filter may stand beside it
    std::optional<double> error_motion_limit_um;  ///< of the total error motion of probe X3; none: it is not judged
    TrajectoryParameters parameters;
};

const std::vector<Field<TrajectoryQuestion>>& fieldsOf(const TrajectoryQuestion*);

struct TrajectoryOutcome : task::Answered {
    std::vector<RecordPtr> records;                      ///< as read, in the order of the inputs
    std::shared_ptr<const TrajectoryResult> trajectory;  ///< null only in a MotionOutcome with `problem`
    /// Index of the section that a window shows: that of sectionKey in the state, which changes no number, or the
    /// worst.
    std::optional<std::size_t> section;

    TrajectoryQuestion question;

    const TrajectorySection* chosenSection() const;  ///< nullptr: there is none
};

struct MotionOutcome : TrajectoryOutcome {
    std::shared_ptr<const std::vector<TimeSignal>> time_signals;  ///< of the first record; null for averages
    std::optional<Error> problem;  ///< why the records that were read have no answer; their signals show it
};

/// Errors: valueNotUnderstood of filters that exclude each other; those of takeRecords() and evaluate(). Throws
/// Cancelled.
TrajectoryOutcome answerTrajectory(const project::PanelState& state, Stores& stores, task::Sources& sources,
                                   const Progress& progress);

/// The same with the signals of the first record; errors of the evaluation are part of the outcome.
MotionOutcome answerMotion(const project::PanelState& state, Stores& stores, task::Sources& sources,
                           const Progress& progress);

task::Outcome outcomeOf(const std::shared_ptr<const TrajectoryOutcome>& outcome);
/// Its numbers are those of the trajectory; answer and report are about the motion in the chosen section.
task::Outcome outcomeOf(const std::shared_ptr<const MotionOutcome>& outcome);

inline constexpr const char* sectionsExport = "csv";
inline constexpr const char* imagesExport = "image-csv";
inline constexpr const char* sectionsQdasExport = "dfq";

const task::Task& trajectoryTask();
const task::Task& motionTask();

}  // namespace lathelier::trajectory
