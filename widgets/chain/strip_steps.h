// The steps of the strip and their relation to the steps of the chain.
#pragma once

#include <QString>
#include <vector>

#include "engine/chain/dossier.h"
#include "engine/chain/of_project/project_chain.h"

namespace lathelier::chain_panel {

/// A step of the strip: one or more steps of the chain.
struct StripStep {
    const char* key;                    ///< key of its tile
    Text title;                         ///< shown title
    const char* panel;                  ///< id of the panel opened
    std::vector<const char*> of_chain;  ///< ids of the chain's steps; the first one is required
};

const std::vector<StripStep>& stripSteps();

/// Combined by precedence: failed, out of date, not made, missing, out of tolerance, not decided, done.
chain::StepStanding standingOf(const StripStep& step, const chain::Dossier& dossier);

/// State, error, inputs and outputs of its chain steps, for a tooltip.
QString aboutOf(const StripStep& step, const chain::Dossier& dossier);

}  // namespace lathelier::chain_panel
