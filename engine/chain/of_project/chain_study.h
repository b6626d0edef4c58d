// Outcome of the panel "Proof of the copy": content and check of the folder of a chain.
#pragma once

#include <memory>
#include <optional>

#include "engine/chain/dossier.h"
#include "engine/chain/machine_fit.h"
#include "engine/chain/of_project/chain_memory.h"
#include "engine/chain/of_project/project_chain.h"
#include "engine/chain/proof.h"
#include "engine/task/stores.h"

namespace lathelier::chain {

struct ChainOutcome {
    ChainSettings settings;                  ///< settings of the request
    std::shared_ptr<const Dossier> dossier;  ///< never null
    DossierCheck check;                      ///< check of its files and numbers on disk
    std::optional<Proof> proof;              ///< proof of the copy; none: the step is not done
    std::optional<MachineFit> fit;           ///< fitted machine; none: not requested or not possible
    InputFile file;                          ///< the dossier file
    Notes notes;                             ///< notes of the steps, of later changes and of the fit
    bool synthetic = false;                  ///< true: a scan is marked as synthetic
};

/// Thread-safe. Error chainInputMissing: the folder has no dossier. Throws Cancelled.
ChainOutcome chainOutcome(const project::PanelState& state, Stores& stores, const Progress& progress);

/// The proof's answer, |E_n| against 1; without a proof the progress of the chain.
report::Answer answerOf(const ChainOutcome& outcome);

/// The dossier's report with the fit.
report::Document reportOf(const ChainOutcome& outcome, const Language& language);

/// Factor, value and uncertainty of the fitted parameters; E_n before and after.
report::Table fitTable(const MachineFit& fit);

/// The proof's chart with the prediction of the fitted machine.
report::Plot plotOf(const ChainOutcome& outcome);

}  // namespace lathelier::chain
