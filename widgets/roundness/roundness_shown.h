// The outcome of the task roundness with its polar plots, which the worker prepares because every point is processed.
#pragma once

#include "engine/trajectory/task/roundness_task.h"
#include "widgets/plot/polar_data.h"

namespace lathelier::roundness_panel {

/// Of one profile or of one section.
struct RoundnessShown : trajectory::RoundnessOutcome {
    plot::PolarPicturePtr polar;  ///< never null
    plot::PolarPicturePtr laid;   ///< the two superimposed profiles; null without a trace

    const form::RoundnessResult& judged() const { return results.front(); }
    const project::Source* trace() const { return task::sourceOf(asked, trajectory::traceRole); }  ///< nullptr: none
};

/// Texts of the pictures in the language of the window. Errors: those of trajectory::answerRoundness().
RoundnessShown showRoundness(const project::PanelState& state, Stores& stores, task::Sources& sources,
                             const Progress& progress);

/// For TaskPanel, which finds it by the type of the outcome.
inline task::Outcome outcomeOf(const std::shared_ptr<const RoundnessShown>& shown)
{
    return trajectory::outcomeOf(std::shared_ptr<const trajectory::RoundnessOutcome>(shown));
}

}  // namespace lathelier::roundness_panel
