// The chains that this process has run, with the reports of their steps, which a dossier on the disk has not.
#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <string>

#include "engine/chain/dossier.h"
#include "engine/core/progress.h"

namespace lathelier::chain_panel {

/// Safe from any thread; an object of Stores.
class ChainMemory {
public:
    void keep(const std::string& folder, std::shared_ptr<const chain::Dossier> dossier);

    /// The dossier in this folder as it lies on the disk, with the reports of its steps where this process has run
    /// them; null: there is none, or it cannot be read.
    std::shared_ptr<const chain::Dossier> find(const std::string& folder, const Progress& progress);

private:
    struct Kept {
        std::string sha256;  ///< of the file
        std::shared_ptr<const chain::Dossier> dossier;
    };
    std::mutex mutex_;
    std::map<std::string, Kept> kept_;  ///< by folder
};

/// SHA-256 of the dossier in the folder; empty: there is none.
std::string dossierDigest(const std::string& folder, const Progress& progress = {});

}  // namespace lathelier::chain_panel
