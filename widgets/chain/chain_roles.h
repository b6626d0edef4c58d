// Inputs of the chain as those of its panel.
#pragma once

#include <vector>

#include "widgets/core/panel/panel_facts.h"

namespace lathelier::chain_panel {

std::vector<InputRole> chainRoles();

}  // namespace lathelier::chain_panel
