// Results of roundness as JSON, as scripts know them.
#pragma once

#include "engine/core/json.h"
#include "engine/form/roundness.h"
#include "engine/form/superimpose.h"

namespace lathelier::form {

/// One element of the command line's `profiles`, without the path.
Json toJson(const RoundnessResult& result);

Json toJson(const SuperimposeResult& result);
Json toJson(const TwoPointSize& size);
Json toJson(const std::vector<signal::Harmonic>& harmonics);

std::string_view key(DecisionRule rule);    ///< "simple" | "guarded"
std::string_view key(FormVerdict verdict);  ///< "pass" | "fail" | "undecided"

}  // namespace lathelier::form
