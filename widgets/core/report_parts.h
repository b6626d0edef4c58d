// Parts of a report that stand for panels without an answer.
#pragma once

#include <optional>

#include "widgets/core/panel_facts.h"

namespace lathelier {

/// Says instead of the panel's answer why there is none: inputs that are missing, an error, or a computation that was
/// stopped.
Document partWithoutAnswer(const PanelFacts& facts, const PanelState& state, const std::optional<Error>& error,
                           const Language& language);

}  // namespace lathelier
