// Conformity decision for a measured value and its limit.
// Source: ISO 14253-1 (guarded), JCGM 106 (simple acceptance, guarded rejection).
#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "engine/core/text.h"

namespace lathelier {

enum class Verdict { Pass, Fail, Undecided };

/// GuardedRejection: a value is out only where it surely is, and within where it lies within; a value out of its limit
/// by less than U is undecided. Simple: the value alone is compared. Guarded: pass and fail only outside the
/// uncertainty about the limit.
enum class DecisionRule { GuardedRejection, Simple, Guarded };
inline constexpr std::array decisionRules{DecisionRule::GuardedRejection, DecisionRule::Simple, DecisionRule::Guarded};

/// The one inequality of all verdicts, for a value that is to be at most `limit`, in one unit; U, its expanded
/// uncertainty (k = 2 or 95 %), is NaN where it is not known:
///                       pass              fail              else
///   GuardedRejection    value ≤ limit     value - U > limit undecided
///   Simple              value ≤ limit     value > limit
///   Guarded             value + U ≤ limit value - U > limit undecided
Verdict judge(double value, double expanded_uncertainty, double limit, DecisionRule rule);

/// The worse of two: Fail, then Undecided, then Pass.
Verdict worse(Verdict a, Verdict b);

/// true, false; nullopt for Undecided or without a verdict.
std::optional<bool> passed(const std::optional<Verdict>& verdict);

std::string_view key(Verdict verdict);    ///< "pass" | "fail" | "undecided"
std::string_view key(DecisionRule rule);  ///< "guarded_rejection" | "simple" | "guarded"
Text name(Verdict verdict);               ///< "✓ within tolerance"…
Text name(DecisionRule rule);             ///< "simple: the value alone is compared"…
Text shortName(Verdict verdict);          ///< "✓ within", for the cells of tables

}  // namespace lathelier
