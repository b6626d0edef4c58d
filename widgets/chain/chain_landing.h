// What a run of the chain leaves in the project: items, and the inputs of the panels of its steps that had none. One
// undo step each.
#pragma once

#include "engine/chain/machine_fit.h"
#include "widgets/chain/chain_state.h"
#include "widgets/core/session.h"

namespace lathelier::chain_panel {

/// The drawing becomes an item; panels of the steps without inputs take what the chain has used and made. What the user
/// gave to a panel stays.
/// `sha256`: of the dossier's file.
void landRun(Session& session, const chain::ChainQuestion& question, const chain::Dossier& dossier,
             const std::string& sha256);

/// The fitted machine becomes an item that Deflection takes, and the chain where its machine is one of springs; the
/// fitted set-up becomes the one of the chain. Error fileNotWritable for the latter.
void landFit(Session& session, const chain::MachineFit& fit, const std::string& folder);

}  // namespace lathelier::chain_panel
