#include "engine/shaft/mark_kind.h"

#include <algorithm>
#include <array>

namespace lathelier {
namespace {

struct NamedKind {
    const char* key;
    Text name;
};

/// In the order of the enumerators.
const std::array<NamedKind, 15>& namedKinds()
{
    static const std::array<NamedKind, 15> kinds{{{"thread", LT_TEXT("Engine", "thread")},
                                                  {"knurl", LT_TEXT("Engine", "knurl")},
                                                  {"keyway", LT_TEXT("Engine", "keyway")},
                                                  {"flat", LT_TEXT("Engine", "flat")},
                                                  {"cross_hole", LT_TEXT("Engine", "cross hole")},
                                                  {"free_form", LT_TEXT("Engine", "free form")},
                                                  {"spline", LT_TEXT("Engine", "spline")},
                                                  {"hexagon", LT_TEXT("Engine", "hexagon")},
                                                  {"square", LT_TEXT("Engine", "square")},
                                                  {"bolt_circle", LT_TEXT("Engine", "bolt circle")},
                                                  {"eccentric", LT_TEXT("Engine", "eccentric")},
                                                  {"sphere", LT_TEXT("Engine", "sphere")},
                                                  {"unexplained", LT_TEXT("Engine", "unexplained")},
                                                  {"bore", LT_TEXT("Engine", "bore")},
                                                  {"", {}}}};
    return kinds;
}

}  // namespace

const char* key(MarkKind kind)
{
    return namedKinds()[static_cast<std::size_t>(kind)].key;
}

MarkKind markKindOf(std::string_view key)
{
    const auto& kinds = namedKinds();
    const auto found =
        std::find_if(kinds.begin(), kinds.end() - 1, [&](const NamedKind& one) { return key == one.key; });
    return static_cast<MarkKind>(found - kinds.begin());
}

Text nameOf(MarkKind kind)
{
    return namedKinds()[static_cast<std::size_t>(kind)].name;
}

}  // namespace lathelier
