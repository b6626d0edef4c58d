// The workspaces of the bar at the top: each a saved arrangement of panels.
#pragma once

#include <QString>
#include <string>
#include <vector>

#include "engine/core/text.h"
#include "widgets/core/panel_facts.h"

namespace lathelier {

struct Workspace {
    std::string id;
    Text title;
    QString icon;
};

/// All workspaces in the order of the bar that have at least one of `panels`.
std::vector<Workspace> workspacesWith(const std::vector<PanelFacts>& panels);

bool isIn(const PanelFacts& panel, const std::string& workspace);

}  // namespace lathelier
