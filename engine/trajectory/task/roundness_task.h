// The task roundness: how round are these profiles, or a section of this probe record? The verb and the panel
// Roundness.
//
// It stands here and not in the room form, because a section of a record is evaluated by this room.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/form/roundness/roundness.h"
#include "engine/form/roundness/superimpose.h"
#include "engine/trajectory/task/record_evaluation.h"

namespace lathelier::trajectory {

inline constexpr const char* profileRole = "profile";
inline constexpr const char* traceRole = "trace";  ///< a second profile, laid on the first

struct RoundnessQuestion {
    bool no_filter = false;          ///< the default, stated explicitly: no filter may stand beside it
    form::RoundnessParameters form;  ///< of a profile or a section; `outliers` of a record are sought over revolutions
    bool mirrored = false;           ///< superimpose also the other way round
    std::optional<int> section;      ///< number of a section of the record; none: the worst one
    TrajectoryParameters record;     ///< how a record is evaluated; what `form` states is taken from there

    TrajectoryParameters ofRecord() const;  ///< `record` with what `form` states
};

const std::vector<Field<RoundnessQuestion>>& fieldsOf(const RoundnessQuestion*);

struct RoundnessOutcome : task::Answered {
    RoundnessQuestion question;                          ///< the parameters as a value
    std::vector<form::RoundnessResult> results;          ///< of the profiles that could be answered, or of the section
    std::vector<std::string> paths;                      ///< file or item of each of `results`
    std::vector<Error> errors;                           ///< of the other profiles, and of the trace
    std::shared_ptr<const TrajectoryResult> trajectory;  ///< of the record; null: profiles are judged
    std::optional<std::size_t> section;                  ///< index of the judged section of `trajectory`
    std::shared_ptr<const form::SuperimposeResult> superimposed;  ///< null: no trace

    const TrajectorySection* chosenSection() const;  ///< nullptr: profiles are judged
};

/// Several profiles: those that can be answered, with the errors of the others. Errors: valueNotUnderstood of filters
/// that exclude each other and of a trace beside several profiles; those of takeRecords() and evaluate(). Throws
/// Cancelled.
RoundnessOutcome answerRoundness(const project::PanelState& state, form::MethodTable methods, Stores& stores,
                                 task::Sources& sources, const Progress& progress);

/// The same for a single profile: its errors are thrown.
RoundnessOutcome answerRoundness(const project::PanelState& state, Stores& stores, task::Sources& sources,
                                 const Progress& progress);

task::Outcome outcomeOf(const std::shared_ptr<const RoundnessOutcome>& outcome);

inline constexpr const char* qdasExport = "dfq";

const task::Task& roundnessTask();

}  // namespace lathelier::trajectory
