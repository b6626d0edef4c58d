// Conformity decision for a measured value and its limit.
// Source: ISO 14253-1 (guarded), JCGM 106 (simple acceptance).
#pragma once

#include <optional>
#include <string_view>

#include "engine/core/text.h"

namespace lathelier {

enum class Verdict { Pass, Fail, Undecided };

/// Simple: the value alone is compared. Guarded: pass and fail only outside the uncertainty about the limit.
enum class DecisionRule { Simple, Guarded };

/// A deviation that is to be at most `limit`, in one unit; `expanded_uncertainty` (k = 2 or 95 %) counts in the guarded
/// rule only: pass when value + U ≤ limit, fail when value - U > limit, else undecided, also when U is NaN (not known).
Verdict judge(double value, double expanded_uncertainty, double limit, DecisionRule rule);

/// The worse of two: Fail, then Undecided, then Pass.
Verdict worse(Verdict a, Verdict b);

/// true, false; nullopt for Undecided or without a verdict.
std::optional<bool> passed(const std::optional<Verdict>& verdict);

std::string_view key(Verdict verdict);    ///< "pass" | "fail" | "undecided"
std::string_view key(DecisionRule rule);  ///< "simple" | "guarded"
Text name(Verdict verdict);               ///< "✓ within tolerance"…
Text name(DecisionRule rule);             ///< "simple: the value alone is compared"…
Text shortName(Verdict verdict);          ///< "✓ within", for the cells of tables

}  // namespace lathelier
