// Results of a run of the chain entered into the project: items, and inputs of the panels of its steps that had none.
// One undo step each.
#pragma once

#include "engine/chain/machine_fit.h"
#include "engine/chain/of_project/project_chain.h"
#include "widgets/core/session.h"

namespace lathelier::chain_panel {

/// The drawing becomes an item; panels of the steps without inputs receive the inputs and outputs of the chain. Inputs
/// chosen by the user are kept. `sha256`: of the dossier's file.
void landRun(Session& session, const chain::ChainQuestion& question, const chain::Dossier& dossier,
             const std::string& sha256);

/// The fitted machine becomes an item that Deflection takes, and the chain where its machine is given by springs; the
/// fitted set-up becomes that of the chain. Error fileNotWritable for the latter.
void landFit(Session& session, const chain::MachineFit& fit, const std::string& folder);

}  // namespace lathelier::chain_panel
