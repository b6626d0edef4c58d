// The workspaces of the bar at the top: each a saved arrangement of panels.
#pragma once

#include <string>
#include <vector>

#include "widgets/core/panel/panel_facts.h"

namespace lathelier {

/// The workspaces that `panels` name, each once, in the order of the bar.
std::vector<Workspace> workspacesOf(const std::vector<PanelFacts>& panels);

bool isIn(const PanelFacts& panel, const std::string& workspace);

}  // namespace lathelier
