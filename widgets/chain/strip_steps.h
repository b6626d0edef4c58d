// The steps of the strip, and what they say of the steps of the chain.
#pragma once

#include <QString>
#include <vector>

#include "engine/chain/dossier.h"
#include "widgets/chain/chain_state.h"

namespace lathelier::chain_panel {

/// A step of the strip: one or more steps of the chain.
struct StripStep {
    const char* key;                    ///< of its tile
    Text title;                         ///< what people read
    const char* panel;                  ///< id of the panel that it opens
    std::vector<const char*> of_chain;  ///< ids of the chain's steps; the first one has to be there
};

const std::vector<StripStep>& stripSteps();

/// The state that stands for all of them: what failed, then what is out of date, not made, missing, done.
chain::StepState stateOf(const StripStep& step, const chain::Dossier& dossier);

/// State, error, inputs and outputs of the steps behind it, for a tooltip.
QString aboutOf(const StripStep& step, const chain::Dossier& dossier);

}  // namespace lathelier::chain_panel
