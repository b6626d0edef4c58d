// Kinds of marks: features of a shaft besides the rows of its outside and its bores, most of them not of revolution.
#pragma once

#include <cstdint>
#include <string_view>

#include "engine/core/text.h"

namespace lathelier {

enum class MarkKind : std::uint8_t {
    Thread,
    Knurl,
    Keyway,
    Flat,
    CrossHole,
    FreeForm,
    Spline,
    Hexagon,
    Square,
    BoltCircle,
    Eccentric,
    Sphere,
    Unexplained,  ///< structure that a recognition found and could not name
    Bore,         ///< a bore that a drawing states as a mark
    Other         ///< a kind that this program does not know; its key stays in ShaftMark::other_kind
};

/// "thread", "cross_hole"…, as files have it; "" for Other.
const char* key(MarkKind kind);

/// Other for a key that is not known.
MarkKind markKindOf(std::string_view key);

/// For people; empty for Other.
Text nameOf(MarkKind kind);

}  // namespace lathelier
