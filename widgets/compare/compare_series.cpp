#include "widgets/compare/compare_series.h"

#include <filesystem>

#include "widgets/core/panel/panel_facts.h"

namespace lathelier::compare_panel {
namespace {

std::string nameOf(const std::string& path)
{
    return std::filesystem::path(path).filename().string();
}

}  // namespace

std::vector<project::Source> furtherCopies(const project::PanelState& state)
{
    InputRole role;
    role.role = copiesRole;
    role.several = true;
    return sourcesOf(state, role);
}

std::vector<registration::CopySummary> KnownCopies::find(const project::PanelState& state, const ComparePicture& shown,
                                                         const Progress& progress)
{
    const auto parameters = fromValues<registration::CompareParameters>(state.parameters);
    std::vector<registration::CopySummary> all{
        registration::summaryOf(nameOf(shown.inputs.back().path), *shown.result)};
    const std::vector<project::Source> sources = furtherCopies(state);
    for (std::size_t i = 0; i < sources.size(); ++i) {
        const Progress part = progress.part(static_cast<double>(i) / static_cast<double>(sources.size()),
                                            static_cast<double>(i + 1) / static_cast<double>(sources.size()));
        registration::CopySummary copy;
        copy.name = nameOf(sources[i].path);
        try {
            ScanStore once;  // forgotten at the end of the turn: the scans of many copies would fill the memory
            const LoadedScanPtr scan = once.load(sources[i], part.part(0, 0.3));
            project::PanelState pair;
            pair.parameters = state.parameters;
            pair.inputs = {{"reference", state.inputs.at("reference")}, {"copy", sources[i]}};
            pair.inputs["reference"].sha256 = shown.inputs.front().sha256;
            pair.inputs["copy"].sha256 = scan->inputs.front().sha256;
            const std::string key = stateDigest(pair);
            {
                const std::lock_guard lock(mutex_);
                if (const auto found = known_.find(key); found != known_.end()) {
                    all.push_back(found->second);
                    continue;
                }
            }
            copy = registration::summaryOf(copy.name, compare(shown.reference->file.scan, scan->file.scan, parameters,
                                                              part.part(0.3, 1), registration::CompareDetail::Summary));
            copy.file = scan->inputs.front();
            const std::lock_guard lock(mutex_);
            known_[key] = copy;
        } catch (const Error& error) {
            copy.error = error;
        }
        all.push_back(std::move(copy));
    }
    return all;
}

}  // namespace lathelier::compare_panel
