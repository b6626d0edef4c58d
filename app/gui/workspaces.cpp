#include "app/gui/workspaces.h"

#include <algorithm>

namespace lathelier {

std::vector<Workspace> workspacesOf(const std::vector<PanelFacts>& panels)
{
    std::vector<Workspace> all;
    for (const PanelFacts& panel : panels)
        for (const Workspace& workspace : panel.workspaces)
            if (std::none_of(all.begin(), all.end(), [&](const Workspace& known) { return known.id == workspace.id; }))
                all.push_back(workspace);
    std::stable_sort(all.begin(), all.end(), [](const Workspace& a, const Workspace& b) { return a.order < b.order; });
    return all;
}

bool isIn(const PanelFacts& panel, const std::string& workspace)
{
    return std::any_of(panel.workspaces.begin(), panel.workspaces.end(),
                       [&](const Workspace& one) { return one.id == workspace; });
}

}  // namespace lathelier
