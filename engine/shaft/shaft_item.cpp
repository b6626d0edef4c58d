#include "engine/shaft/shaft_item.h"

#include "engine/core/error.h"

namespace lathelier {

std::optional<Shaft> shaftOf(const Values& values)
{
    try {
        auto shaft = fromValues<Shaft>(values);
        if (shaft.segments.empty()) return std::nullopt;
        return shaft;
    } catch (const Error&) {  // a value that a shaft cannot have
        return std::nullopt;
    }
}

}  // namespace lathelier
