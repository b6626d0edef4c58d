#include "engine/registration/verdict/verdict_values.h"

namespace lathelier::registration {

std::string_view key(VerdictRule rule)
{
    return rule == VerdictRule::Points ? "points" : "surface";
}

std::string_view key(Finding::Kind kind)
{
    switch (kind) {
        case Finding::Kind::Step: return "step";
        case Finding::Kind::Taper: return "taper";
        case Finding::Kind::Barrel: return "barrel";
        case Finding::Kind::Bump: return "bump";
        case Finding::Kind::Missing: return "missing";
    }
    return {};
}

Text name(VerdictRule rule)
{
    return rule == VerdictRule::Points ? LT_TEXT("Engine", "points: the share within the limits")
                                       : LT_TEXT("Engine", "surface: local means against the limits");
}

Text name(Finding::Kind kind)
{
    switch (kind) {
        case Finding::Kind::Step: return LT_TEXT("Engine", "off by a constant");
        case Finding::Kind::Taper: return LT_TEXT("Engine", "taper");
        case Finding::Kind::Barrel: return LT_TEXT("Engine", "barrel or hollow");
        case Finding::Kind::Bump: return LT_TEXT("Engine", "bump or dent");
        case Finding::Kind::Missing: return LT_TEXT("Engine", "no points of the copy");
    }
    return {};
}

}  // namespace lathelier::registration
