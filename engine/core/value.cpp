#include "engine/core/value.h"

namespace lathelier {

const Value* find(const Values& values, std::string_view name)
{
    for (const auto& [key, value] : values)
        if (key == name) return &value;
    return nullptr;
}

void set(Values& values, std::string_view name, Value value)
{
    for (auto& [key, old] : values)
        if (key == name) {
            old = std::move(value);
            return;
        }
    values.emplace_back(name, std::move(value));
}

}  // namespace lathelier
