// Outcome of the panels of the workspace Roundness, which share one state and one computation.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "engine/form/roundness/roundness.h"
#include "engine/form/roundness/superimpose.h"
#include "engine/project/project.h"
#include "engine/report/document.h"
#include "engine/task/stores.h"
#include "engine/trajectory/trajectory.h"
#include "widgets/plot/polar_data.h"
#include "widgets/trajectory_common/spindle_files.h"

namespace lathelier::trajectory_common {

/// Key of the state in the project, and of its parameters beside those of the engine.
inline constexpr const char* spindleState = "roundness";
inline constexpr const char* sectionKey = "section";  ///< number of the chosen section; none: the worst one

struct SpindleOutcome {
    std::vector<LoadedRecordPtr> records;  ///< as read, in the order of the inputs; none with a profile for roundness
    std::shared_ptr<const trajectory::TrajectoryResult> trajectory;  ///< null without a record, or with `problem`
    std::shared_ptr<const std::vector<trajectory::TimeSignal>>
        time_signals;                    ///< of the first record; null for averages
    std::optional<Error> problem;        ///< why the records that were read have no answer
    std::optional<std::size_t> section;  ///< index of the chosen one in the result

    LoadedProfilePtr profile;  ///< separately measured profile; has precedence over the record
    std::shared_ptr<const form::RoundnessResult> profile_roundness;  ///< of `profile`; null without one
    LoadedProfilePtr trace;  ///< superimposed on the profile or the section's image
    std::shared_ptr<const form::SuperimposeResult> superimposed;  ///< of `trace`; null without two profiles

    plot::PolarPicturePtr polar;  ///< polar plot of the roundness; with Roundness only
    plot::PolarPicturePtr laid;   ///< polar plot of the two superimposed profiles

    std::vector<InputFile> inputs;  ///< input files of this outcome
    Notes notes;                    ///< of results and files
    bool synthetic = false;         ///< one of the sources is marked as synthetic

    /// Of the profile, else of the chosen section; null when there is neither.
    const form::RoundnessResult* roundness() const;
    const trajectory::TrajectorySection* chosenSection() const;
};

/// States in a report's first section which section of the record it refers to; nothing for a profile.
void addSectionSentence(const SpindleOutcome& outcome, report::Document& document);

/// The computation required by a panel.
enum class SpindleStudyKind { Roundness, Trajectory, Longitudinal };

/// Reads and computes what is not cached; thread-safe, computed once for several panels. With Trajectory a record
/// without a result gives an outcome with `problem`. Errors: those of the readers and of roundness(), superimpose(),
/// trajectory(). Throws Cancelled.
SpindleOutcome findOutcome(const project::PanelState& state, SpindleStudyKind studyKind, Stores& stores,
                           const Progress& progress = {});

/// The same, but throws `problem`.
SpindleOutcome outcomeOrThrow(const project::PanelState& state, SpindleStudyKind studyKind, Stores& stores,
                              const Progress& progress = {});

/// The JSON objects of the command line for these results.
std::string roundnessJson(const SpindleOutcome& outcome);
std::string trajectoryJson(const SpindleOutcome& outcome);

}  // namespace lathelier::trajectory_common
