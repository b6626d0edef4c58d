#include "widgets/trajectory_common/spindle_files.h"

#include <algorithm>
#include <filesystem>

namespace lathelier {
namespace {

/// The other half of an L-Graph pair, with the same case of letters; empty when there is none.
std::string partnerOf(const std::string& path)
{
    const std::filesystem::path file(path);
    const std::string suffix = file.extension().string();
    std::string other;
    if (suffix == ".dat") other = ".par";
    if (suffix == ".par") other = ".dat";
    if (suffix == ".DAT") other = ".PAR";
    if (suffix == ".PAR") other = ".DAT";
    if (other.empty()) return {};
    std::filesystem::path partner = file;
    partner.replace_extension(other);
    std::error_code problem;
    return std::filesystem::is_regular_file(partner, problem) ? partner.string() : std::string();
}

}  // namespace

ProbeFile RecordStore::read(const Source& source, InputFiles& inputs, const Progress& progress) const
{
    return readProbeRecord(source.path, inputs.open(source.path, progress), inputs,
                           fromValues<ImportOptions>(source.import), fromValues<RecorderOptions>(source.import),
                           progress);
}

ProfileFile ProfileStore::read(const Source& source, InputFiles& inputs, const Progress& progress) const
{
    return readProfile(source.path, inputs.open(source.path, progress), fromValues<ImportOptions>(source.import),
                       fromValues<ProfileOptions>(source.import), progress);
}

std::vector<std::string> withoutPartners(const std::vector<std::string>& paths)
{
    std::vector<std::string> kept;
    for (const std::string& path : paths) {
        const std::string suffix = std::filesystem::path(path).extension().string();
        const bool isData = suffix == ".dat" || suffix == ".DAT";
        if (isData && std::find(paths.begin(), paths.end(), partnerOf(path)) != paths.end()) continue;
        kept.push_back(path);
    }
    return kept;
}

}  // namespace lathelier
