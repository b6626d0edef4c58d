#include "engine/core/used_value.h"

#include <algorithm>

namespace lathelier {

void addUsed(UsedValues& used, const FieldInfo& info, const Value& value, ValueOrigin origin)
{
    const UsedValue item{info.key, info.label, value, info.unit, origin};
    if (std::find(used.begin(), used.end(), item) == used.end()) used.push_back(item);
}

}  // namespace lathelier
