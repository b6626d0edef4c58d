// Verdicts as files and the command line have them: "pass", "fail", "undecided", null without one.
#pragma once

#include <optional>
#include <string_view>

#include "engine/core/conformity.h"
#include "engine/core/json.h"

namespace lathelier {

Json verdictJson(const std::optional<Verdict>& verdict);

/// The verdict of this word; none: another one.
std::optional<Verdict> verdictOf(std::string_view word);

}  // namespace lathelier
