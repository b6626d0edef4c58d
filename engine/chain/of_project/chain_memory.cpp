#include "engine/chain/of_project/chain_memory.h"

#include <filesystem>

#include "engine/chain/dossier_read.h"
#include "engine/io/file.h"

namespace lathelier::chain {

std::string dossierDigest(const std::string& folder, const Progress& progress)
{
    if (folder.empty()) return {};
    try {
        return io::fileSha256((std::filesystem::path(folder) / dossierFile).string(), progress);
    } catch (const Error&) {
        return {};
    }
}

void ChainMemory::keep(const std::string& folder, std::shared_ptr<const Dossier> dossier)
{
    const std::string sha256 = dossierDigest(folder);
    const std::lock_guard lock(mutex_);
    kept_[folder] = {sha256, std::move(dossier)};
}

std::shared_ptr<const Dossier> ChainMemory::find(const std::string& folder, const Progress& progress)
{
    const std::string sha256 = dossierDigest(folder, progress);
    if (sha256.empty()) return nullptr;
    {
        const std::lock_guard lock(mutex_);
        const auto kept = kept_.find(folder);
        if (kept != kept_.end() && kept->second.sha256 == sha256) return kept->second.dossier;
    }
    auto read = dossierIn(folder, progress);
    if (!read) return nullptr;
    auto dossier = std::make_shared<const Dossier>(*std::move(read));
    const std::lock_guard lock(mutex_);
    kept_[folder] = {sha256, dossier};
    return dossier;
}

}  // namespace lathelier::chain
