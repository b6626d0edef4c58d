// The panel table: menu, docks, layouts, shortcuts and reports follow from it.
#pragma once

#include <vector>

#include "widgets/core/panel/panel_facts.h"
#include "widgets/core/panel/workspace_strip.h"

namespace lathelier {

const std::vector<PanelFacts>& panelTable();

/// What stands over the panels of workspaces.
const std::vector<StripFacts>& stripTable();

}  // namespace lathelier
