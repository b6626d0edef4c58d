// What the panels of workspace Roundness show: one state, one computation, three looks at it.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "engine/form/roundness/roundness.h"
#include "engine/form/roundness/superimpose.h"
#include "engine/project/project.h"
#include "engine/report/document.h"
#include "engine/trajectory/trajectory.h"
#include "widgets/core/files/stores.h"
#include "widgets/plot/polar_data.h"
#include "widgets/trajectory_common/spindle_files.h"

namespace lathelier::trajectory_common {

/// Key of the state in the project, and of its parameters beside those of the engine.
inline constexpr const char* spindleState = "roundness";
inline constexpr const char* sectionKey = "section";  ///< number of the chosen section; none: the worst one

struct SpindlePicture {
    std::vector<LoadedRecordPtr> records;  ///< as read, in the order of the inputs; none with a profile for roundness
    std::shared_ptr<const trajectory::TrajectoryResult> trajectory;  ///< null without a record, or with `problem`
    std::shared_ptr<const std::vector<trajectory::TimeSignal>>
        time_signals;                    ///< of the first record; null for averages
    std::optional<Error> problem;        ///< why the records that were read have no answer
    std::optional<std::size_t> section;  ///< index of the chosen one in the result

    LoadedProfilePtr profile;                                       ///< measured elsewhere; it goes before the record
    std::shared_ptr<const form::RoundnessResult> profileRoundness;  ///< of `profile`; null without one
    LoadedProfilePtr trace;                                         ///< laid on the profile or the section's image
    std::shared_ptr<const form::SuperimposeResult> superimposed;    ///< of `trace`; null without two profiles

    plot::PolarPicturePtr polar;  ///< of the roundness; with Roundness only
    plot::PolarPicturePtr laid;   ///< of the two superimposed profiles

    std::vector<InputFile> inputs;  ///< files that this picture rests on
    Notes notes;                    ///< of results and files
    bool synthetic = false;         ///< one of the sources is marked as synthetic

    /// Of the profile, else of the chosen section; null when there is neither.
    const form::RoundnessResult* roundness() const;
    const trajectory::TrajectorySection* chosenSection() const;
};

/// Says in a report's first section which section of the record it is about; nothing for a profile.
void saySection(const SpindlePicture& picture, report::Document& document);

/// What a panel needs of it.
enum class SpindleWant { Roundness, Trajectory, Longitudinal };

/// Reads and computes what is not there yet; safe from any thread, and computed once however many panels ask.
/// With Trajectory a record without an answer gives a picture with `problem`. Errors: those of the readers and of
/// roundness(), superimpose(), trajectory(). Throws Cancelled.
SpindlePicture findPicture(const project::PanelState& state, SpindleWant want, Stores& stores,
                           const Progress& progress = {});

/// The same where nobody would look at a picture without an answer: its problem is thrown.
SpindlePicture answeredPicture(const project::PanelState& state, SpindleWant want, Stores& stores,
                               const Progress& progress = {});

/// The objects that the command line writes for these results.
std::string roundnessJson(const SpindlePicture& picture);
std::string trajectoryJson(const SpindlePicture& picture);

}  // namespace lathelier::trajectory_common
