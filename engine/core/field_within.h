// Fields of a member struct as fields of the containing struct.
#pragma once

#include <stdexcept>
#include <string>

#include "engine/core/fields.h"

namespace lathelier {

/// The field `key` of the struct that `member` holds, as a field of Q. Throws std::logic_error: there is none.
template <class Q, class Part>
Field<Q> within(Part Q::*member, const std::string& key)
{
    for (const Field<Part>& inner : fields<Part>())
        if (inner.info.key == key)
            return {inner.info, [member, inner](const Q& q) { return inner.get(q.*member); },
                    [member, inner](Q& q, const Value& value) { inner.set(q.*member, value); }};
    throw std::logic_error("no such parameter: " + key);
}

/// The same, folded away in the form.
template <class Q, class Part>
Field<Q> foldedWithin(Part Q::*member, const std::string& key)
{
    Field<Q> field = within(member, key);
    field.info.advanced = true;
    return field;
}

}  // namespace lathelier
