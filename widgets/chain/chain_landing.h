// What a run of the chain leaves in the project: items, and the inputs of the panels of its steps that had none. One
// undo step each.
#pragma once

#include "engine/chain/machine_fit.h"
#include "widgets/chain/chain_state.h"
#include "widgets/core/session.h"

namespace lathelier::chain_panel {

/// The drawing becomes an item; panels of the steps without inputs take what the chain has used and made. What the user
/// gave to a panel stays.
void landRun(Session& session, const chain::ChainQuestion& question, const chain::Dossier& dossier);

/// The fitted machine becomes an item that Deflection takes, the fitted set-up the one of the chain. Error
/// fileNotWritable for the latter.
void landFit(Session& session, const chain::MachineFit& fit, const std::string& folder);

}  // namespace lathelier::chain_panel
