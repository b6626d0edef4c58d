#include "engine/deflection/setup_item.h"

#include <algorithm>

#include "engine/core/error.h"
#include "engine/shaft/nested_shaft.h"

namespace lathelier::deflection {
namespace {

constexpr const char* pathKey = "stock";
constexpr const char* stockKey = "stock_shaft";

}  // namespace

Values valuesOf(const HeldSetup& held)
{
    Values values = lathelier::toValues(held.setup);
    set(values, pathKey, std::string());
    if (held.stock) set(values, stockKey, shaftAsValue(*held.stock));
    return values;
}

std::optional<HeldSetup> setupOf(const Values& values)
{
    const std::vector<FieldInfo> described = infos<TurningSetup>();
    const auto isMissing = [&](const FieldInfo& info) {
        return info.required && info.group_key.empty() && !find(values, info.key);
    };
    if (std::any_of(described.begin(), described.end(), isMissing)) return std::nullopt;
    try {
        HeldSetup held{fromValues<TurningSetup>(values), {}};
        held.setup.stock.clear();
        if (const Value* const stock = find(values, stockKey)) {
            held.stock = shaftOf(*stock);
            if (!held.stock) return std::nullopt;
        }
        return held;
    } catch (const Error&) {  // a value that a set-up cannot have
        return std::nullopt;
    }
}

}  // namespace lathelier::deflection
