#include "app/gui/file_taker.h"

#include <algorithm>
#include <functional>

namespace lathelier {
namespace {

bool isIn(const io::FileKinds& kinds, const io::FileKind* kind)
{
    return std::find(kinds.begin(), kinds.end(), kind) != kinds.end();
}

bool takes(const PanelFacts& facts, const io::FileKind* kind)
{
    return isIn(facts.kinds, kind) || isIn(kindsOf(facts.roles), kind);
}

/// Whether each file gets an input of its own: a matching of files and roles, improved file by file.
bool takesAll(const PanelFacts& facts, const std::vector<FoundFile>& files)
{
    const std::vector<InputRole>& roles = facts.roles;
    std::vector<std::optional<std::size_t>> holder(roles.size());  // file by role
    const auto fits = [&](std::size_t file, std::size_t role) { return isIn(roles[role].kinds, files[file].kind); };
    const std::function<bool(std::size_t, std::vector<bool>&)> place = [&](std::size_t file, std::vector<bool>& tried) {
        for (std::size_t role = 0; role < roles.size(); ++role) {
            if (!fits(file, role) || tried[role]) continue;
            if (roles[role].several) return true;
            tried[role] = true;
            if (holder[role] && !place(*holder[role], tried)) continue;
            holder[role] = file;
            return true;
        }
        return false;
    };
    for (std::size_t file = 0; file < files.size(); ++file) {
        std::vector<bool> tried(roles.size());
        if (!place(file, tried)) return false;
    }
    return true;
}

bool hasBegun(const project::Project& project)
{
    return std::any_of(project.panels.begin(), project.panels.end(),
                       [](const auto& panel) { return !panel.second.inputs.empty(); });
}

std::size_t takerOf(const FoundFile& file, const std::vector<const PanelFacts*>& panels,
                    std::optional<std::size_t> active, const project::Project& project)
{
    const auto first = [&](const std::function<bool(const PanelFacts&)>& wanted) {
        const auto found =
            std::find_if(panels.begin(), panels.end(), [&](const PanelFacts* one) { return wanted(*one); });
        return found == panels.end() ? std::nullopt : std::optional(static_cast<std::size_t>(found - panels.begin()));
    };
    const auto home = first([&](const PanelFacts& facts) { return isIn(facts.alone, file.kind); });
    if (active && takes(*panels[*active], file.kind)) {
        const PanelFacts& facts = *panels[*active];
        if (!home || isIn(facts.alone, file.kind) || hasBegun(project)) return *active;
    }
    if (home) return *home;
    if (const auto one = first([&](const PanelFacts& facts) { return isIn(facts.kinds, file.kind); })) return *one;
    return first([&](const PanelFacts& facts) { return takes(facts, file.kind); }).value_or(0);
}

}  // namespace

std::vector<Opening> openingsOf(const std::vector<FoundFile>& files, const std::vector<const PanelFacts*>& panels,
                                std::optional<std::size_t> active, const project::Project& project)
{
    if (files.empty() || panels.empty()) return {};
    if (files.size() == 1) return {{takerOf(files.front(), panels, active, project), files}};
    if (active && takesAll(*panels[*active], files)) return {{*active, files}};
    for (std::size_t i = 0; i < panels.size(); ++i)
        if (takesAll(*panels[i], files)) return {{i, files}};
    std::vector<Opening> openings;
    for (const FoundFile& file : files) {
        const std::size_t taker = takerOf(file, panels, active, project);
        const auto same = std::find_if(openings.begin(), openings.end(),
                                       [taker](const Opening& opening) { return opening.panel == taker; });
        if (same == openings.end())
            openings.push_back({taker, {file}});
        else
            same->files.push_back(file);
    }
    return openings;
}

}  // namespace lathelier
