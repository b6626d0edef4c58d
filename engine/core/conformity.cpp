#include "engine/core/conformity.h"

namespace lathelier {

Verdict judge(double value, double expanded_uncertainty, double limit, DecisionRule rule)
{
    if (rule == DecisionRule::Simple) return value <= limit ? Verdict::Pass : Verdict::Fail;
    const double guard = rule == DecisionRule::Guarded ? expanded_uncertainty : 0;
    if (value + guard <= limit) return Verdict::Pass;
    return value - expanded_uncertainty > limit ? Verdict::Fail : Verdict::Undecided;
}

Verdict worse(Verdict a, Verdict b)
{
    if (a == Verdict::Fail || b == Verdict::Fail) return Verdict::Fail;
    return a == Verdict::Undecided ? a : b;
}

std::optional<bool> passed(const std::optional<Verdict>& verdict)
{
    if (!verdict || *verdict == Verdict::Undecided) return std::nullopt;
    return *verdict == Verdict::Pass;
}

std::string_view key(Verdict verdict)
{
    switch (verdict) {
        case Verdict::Pass: return "pass";
        case Verdict::Fail: return "fail";
        case Verdict::Undecided: return "undecided";
    }
    return {};
}

std::string_view key(DecisionRule rule)
{
    switch (rule) {
        case DecisionRule::GuardedRejection: return "guarded_rejection";
        case DecisionRule::Simple: return "simple";
        case DecisionRule::Guarded: return "guarded";
    }
    return {};
}

Text name(Verdict verdict)
{
    switch (verdict) {
        case Verdict::Pass: return LT_TEXT("Engine", "✓ within tolerance");
        case Verdict::Fail: return LT_TEXT("Engine", "✗ out of tolerance");
        case Verdict::Undecided: return LT_TEXT("Engine", "? not decided: too near the tolerance");
    }
    return {};
}

Text name(DecisionRule rule)
{
    switch (rule) {
        case DecisionRule::GuardedRejection:
            return LT_TEXT("Engine",
                           "guarded rejection: out only where the value less its uncertainty is beyond the limit");
        case DecisionRule::Simple: return LT_TEXT("Engine", "simple: the value alone is compared");
        case DecisionRule::Guarded: return LT_TEXT("Engine", "ISO 14253-1: only what is sure passes or fails");
    }
    return {};
}

Text shortName(Verdict verdict)
{
    switch (verdict) {
        case Verdict::Pass: return LT_TEXT("Engine", "✓ within");
        case Verdict::Fail: return LT_TEXT("Engine", "✗ out");
        case Verdict::Undecided: return LT_TEXT("Engine", "? undecided");
    }
    return {};
}

}  // namespace lathelier
