// Parameter structs as JSON objects, by their description: groups are objects within objects, rows lists of
// objects. A row may be a list of its values, in the order of the columns ("holder": [[0, 20], [5, 20]]).
#pragma once

#include <string>
#include <vector>

#include "engine/core/fields.h"
#include "engine/io/json/json_document.h"

namespace lathelier::io {

/// The members of `object` that `fields` describe, by their flat keys ("chuck.radial_N_mm"). A member that is neither
/// described nor in `others` gives the note unknownKey with its location. What stands under a former key is given under
/// that of today. Errors, with line and column: malformed (wrong type, no such choice), keyMissing (a required field),
/// keyOutOfRange, valueStatedTwice (under a former key and that of today).
Values valuesOf(const JsonCursor& object, const std::vector<FieldInfo>& fields, Notes& notes,
                const std::vector<std::string>& others = {});

/// The same as the struct; members not given keep their default.
template <class P>
P readFields(const JsonCursor& object, Notes& notes, const std::vector<std::string>& others = {}, P defaults = {})
{
    return fromValues<P>(valuesOf(object, infos<P>(), notes, others), std::move(defaults));
}

/// The reverse: values by flat keys as objects within objects; a group that is absent is null. A struct as JSON is
/// objectOf(infos<P>(), toValues(parameters)).
Json objectOf(const std::vector<FieldInfo>& fields, const Values& values);

}  // namespace lathelier::io
