// What the worker of the panel "Proof of the copy" finds in the folder of a chain.
#pragma once

#include <memory>
#include <optional>

#include "engine/chain/dossier.h"
#include "engine/chain/machine_fit.h"
#include "engine/chain/proof.h"
#include "widgets/chain/chain_memory.h"
#include "widgets/chain/chain_state.h"
#include "widgets/core/files/stores.h"

namespace lathelier::chain_panel {

struct ChainPicture {
    ChainSettings settings;                         ///< as asked
    std::shared_ptr<const chain::Dossier> dossier;  ///< never null
    chain::DossierCheck check;                      ///< of its files and numbers on the disk
    std::optional<chain::Proof> proof;              ///< none: the step is not done
    std::optional<chain::MachineFit> fit;           ///< none: nothing to be fitted, or not possible
    InputFile file;                                 ///< the dossier
    Notes notes;                                    ///< of the steps, of what has changed since, of the fit
    bool synthetic = false;                         ///< a scan is marked so
};

/// Safe from any thread. Error chainInputMissing: there is no dossier in the folder. Throws Cancelled.
ChainPicture chainPicture(const project::PanelState& state, Stores& stores, const Progress& progress);

/// The proof's answer, |E_n| against 1; without a proof how far the chain came.
report::Answer answerOf(const ChainPicture& picture);

/// The dossier's report with the fit.
report::Document reportOf(const ChainPicture& picture);

/// Factor, value and uncertainty of what was fitted; E_n before and after.
report::Table fitTable(const chain::MachineFit& fit);

/// The proof's chart with the prediction of the fitted machine.
report::Plot plotOf(const ChainPicture& picture);

}  // namespace lathelier::chain_panel
