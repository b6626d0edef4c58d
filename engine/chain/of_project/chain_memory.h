// Chains run by this process, with the reports of their steps, which a dossier on disk lacks.
#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <string>

#include "engine/chain/dossier.h"
#include "engine/core/progress.h"

namespace lathelier::chain {

/// Thread-safe; an object of Stores.
class ChainMemory {
public:
    void keep(const std::string& folder, std::shared_ptr<const Dossier> dossier);

    /// The dossier in this folder, with the reports of the steps run by this process; null: missing or unreadable.
    std::shared_ptr<const Dossier> find(const std::string& folder, const Progress& progress);

private:
    struct Kept {
        std::string sha256;  ///< digest of the dossier file
        std::shared_ptr<const Dossier> dossier;
    };
    std::mutex mutex_;
    std::map<std::string, Kept> kept_;  ///< dossiers by folder
};

/// SHA-256 of the dossier in the folder; empty: there is none.
std::string dossierDigest(const std::string& folder, const Progress& progress = {});

}  // namespace lathelier::chain
