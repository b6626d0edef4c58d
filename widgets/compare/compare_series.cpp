#include "widgets/compare/compare_series.h"

#include <algorithm>
#include <filesystem>

#include "engine/features/shaft_mesh.h"
#include "engine/io/file.h"
#include "engine/registration/drawn_reference.h"
#include "engine/registration/verdict/verdict.h"
#include "engine/shaft/shaft_contour.h"
#include "widgets/core/panel/panel_facts.h"

namespace lathelier::compare_panel {
namespace {

std::string nameOf(const std::string& path)
{
    return std::filesystem::path(path).filename().string();
}

/// Key of a further copy: a file may occur twice with different import options.
std::string keyOf(project::Source source)
{
    source.sha256.clear();
    project::PanelState state;
    state.inputs = {{copiesRole, std::move(source)}};
    return stateDigest(state);
}

}  // namespace

std::vector<project::Source> furtherCopies(const project::PanelState& state)
{
    InputRole role;
    role.role = copiesRole;
    role.several = true;
    return sourcesOf(state, role);
}

std::vector<registration::CopySummary> KnownCopies::find(const project::PanelState& state, const CompareOutcome& shown,
                                                         const Progress& progress)
{
    const auto parameters = fromValues<registration::CompareParameters>(state.parameters);
    std::vector<registration::CopySummary> all{
        registration::summaryOf(nameOf(shown.inputs.back().path), *shown.result)};
    const std::vector<project::Source> sources = furtherCopies(state);
    forgetOthers(sources);
    for (std::size_t i = 0; i < sources.size(); ++i) {
        const Progress part = progress.part(static_cast<double>(i) / static_cast<double>(sources.size()),
                                            static_cast<double>(i + 1) / static_cast<double>(sources.size()));
        registration::CopySummary copy;
        copy.name = nameOf(sources[i].path);
        try {
            const Known known = compared(sources[i], shown, parameters, part);
            registration::CompareResult result = *known.result;
            judge(result, parameters, part);
            copy = registration::summaryOf(copy.name, result);
            copy.file = known.file;
        } catch (const Error& error) {
            copy.error = error;
        }
        all.push_back(std::move(copy));
    }
    return all;
}

void KnownCopies::forgetOthers(const std::vector<project::Source>& sources)
{
    const std::lock_guard lock(mutex_);
    std::erase_if(known_, [&](const auto& known) {
        return std::none_of(sources.begin(), sources.end(),
                            [&](const project::Source& source) { return keyOf(source) == known.first; });
    });
}

KnownCopies::Known KnownCopies::compared(const project::Source& source, const CompareOutcome& shown,
                                         const registration::CompareParameters& parameters, const Progress& progress)
{
    Known now{io::fileStamp(source.path), shown.inputs.front().sha256, {}, nullptr};
    {
        const std::lock_guard lock(mutex_);
        const auto found = known_.find(keyOf(source));
        if (found != known_.end() && found->second.stamp == now.stamp && found->second.reference == now.reference &&
            sameButVerdict(found->second.result->parameters, parameters))
            return found->second;
    }
    ScanStore once;  // released at the end, since the scans of many copies would fill the memory
    const LoadedScanPtr scan = once.load(source, progress.part(0, 0.3));
    now.file = scan->inputs.front();
    constexpr auto detail = registration::CompareDetail::Summary;
    const Progress comparing = progress.part(0.3, 1);
    const Scan& copy = scan->file.scan;
    now.result = std::make_shared<const registration::CompareResult>(
        shown.drawn ? compare(registration::DrawnReference{features::shaftMesh(shown.drawn->part.shaft).scan,
                                                           closedContour(shown.drawn->part.shaft)},
                              copy, parameters, comparing, detail)
                    : compare(shown.reference->file.scan, copy, parameters, comparing, detail));
    const std::lock_guard lock(mutex_);
    known_[keyOf(source)] = now;
    return now;
}

}  // namespace lathelier::compare_panel
