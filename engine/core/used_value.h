// The parameter values of a result and their origin: given by the user, by a file, or assumed.
#pragma once

#include <optional>
#include <string_view>
#include <type_traits>
#include <vector>

#include "engine/core/fields.h"

namespace lathelier {

enum class ValueOrigin { Given, File, Assumed };

/// A parameter with an optional value, as used.
struct UsedValue {
    std::string key;  ///< of the parameter, as in fields()
    Text label;       ///< of the parameter, FieldInfo::label
    Value value;
    Text unit;  ///< of the value; empty: none
    ValueOrigin origin = ValueOrigin::Assumed;

    friend bool operator==(const UsedValue&, const UsedValue&) = default;
};

using UsedValues = std::vector<UsedValue>;

/// Adds the parameter described by `info`; what is in the list already is not repeated.
void addUsed(UsedValues& used, const FieldInfo& info, const Value& value, ValueOrigin origin);

/// Takes the value of parameter `key` of P: the given one, else that of the file, else the assumed one, and records the
/// origin.
template <class P, class T>
T resolve(UsedValues& used, std::string_view key, const std::optional<std::type_identity_t<T>>& given,
          const std::optional<std::type_identity_t<T>>& in_file, const T& assumed)
{
    const T value = given ? *given : in_file ? *in_file : assumed;
    for (const Field<P>& field : fields<P>())
        if (field.info.key == key)
            addUsed(used, field.info, Value(value),
                    given     ? ValueOrigin::Given
                    : in_file ? ValueOrigin::File
                              : ValueOrigin::Assumed);
    return value;
}

}  // namespace lathelier
