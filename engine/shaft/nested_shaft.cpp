#include "engine/shaft/nested_shaft.h"

#include "engine/shaft/shaft_item.h"

namespace lathelier {

Value shaftAsValue(const Shaft& shaft)
{
    return Rows{{Row{toValues(shaft)}}};
}

std::optional<Shaft> shaftOf(const Value& value)
{
    const Rows* const rows = std::get_if<Rows>(&value);
    return rows && rows->rows.size() == 1 ? shaftOf(rows->rows.front().cells) : std::nullopt;
}

}  // namespace lathelier
