// A run of the chain entered into the project, with the files that it was given; all else follows from them in the walk
// through the part. One undo step each.
#pragma once

#include "engine/chain/machine_fit.h"
#include "engine/chain/of_project/project_chain.h"
#include "widgets/core/session.h"

namespace lathelier::chain_panel {

/// Panels of the steps receive the files of the chain where they have none. `sha256`: of the dossier's file.
void landRun(Session& session, const chain::ChainQuestion& question, const chain::Dossier& dossier,
             const std::string& sha256);

/// The fitted machine becomes an item that Deflection takes, and the chain where its machine is given by springs; the
/// fitted set-up becomes that of the chain. Error fileNotWritable for the latter.
void landFit(Session& session, const chain::MachineFit& fit, const std::string& folder);

}  // namespace lathelier::chain_panel
