#include "engine/shaft/shaft_item.h"

#include "engine/core/error.h"

namespace lathelier {
namespace {

constexpr const char* scanKey = "recovered_from_scan";
constexpr const char* shaKey = "recovered_from_sha256";
constexpr const char* methodKey = "recovered_by_method";

}  // namespace

Values itemValues(const Shaft& shaft, const RecoveredFrom& from)
{
    Values values = toValues(shaft);
    set(values, scanKey, from.scan);
    set(values, shaKey, from.scan_sha256);
    set(values, methodKey, from.method);
    return values;
}

std::optional<RecoveredFrom> recoveredFrom(const Values& values)
{
    const auto word = [&](const char* key) {
        const Value* const value = find(values, key);
        const auto* const said = value ? std::get_if<std::string>(value) : nullptr;
        return said ? *said : std::string();
    };
    const RecoveredFrom from{word(scanKey), word(shaKey), word(methodKey)};
    return from.scan.empty() ? std::nullopt : std::optional(from);
}

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
