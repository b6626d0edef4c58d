// The panel table: menu, docks, layouts, shortcuts and reports follow from it.
#pragma once

#include <vector>

#include "widgets/core/panel/panel_facts.h"

namespace lathelier {

const std::vector<PanelFacts>& panelTable();

}  // namespace lathelier
