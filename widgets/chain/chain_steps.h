// The steps of the chain for its panel: sign, files, and the panel that shows a step.
#pragma once

#include <QString>

#include "engine/chain/dossier.h"

namespace lathelier::chain_panel {

/// "✓", "?", "!", "✗", "○", "–".
QString signOf(const chain::StepStanding& standing);

/// Id of the panel of a step; nullptr: none.
const char* panelOf(const std::string& step);

/// State, error, inputs and outputs, for a tooltip.
QString aboutOf(const chain::ChainStep& step);

}  // namespace lathelier::chain_panel
