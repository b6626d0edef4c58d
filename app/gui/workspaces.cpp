#include "app/gui/workspaces.h"

#include <algorithm>

namespace lathelier {

std::vector<Workspace> workspacesWith(const std::vector<PanelFacts>& panels)
{
    std::vector<Workspace> all{{"inspection", LT_TEXT("Engine", "Inspection"), "inspection"},
                               {"roundness", LT_TEXT("Engine", "Roundness"), "roundness"},
                               {"chatter", LT_TEXT("Engine", "Chatter"), "chatter"},
                               {"deflection", LT_TEXT("Engine", "Deflection"), "deflection"}};
    std::erase_if(all, [&](const Workspace& workspace) {
        return std::none_of(panels.begin(), panels.end(),
                            [&](const PanelFacts& panel) { return isIn(panel, workspace.id); });
    });
    return all;
}

bool isIn(const PanelFacts& panel, const std::string& workspace)
{
    return std::find(panel.workspaces.begin(), panel.workspaces.end(), workspace) != panel.workspaces.end();
}

}  // namespace lathelier
