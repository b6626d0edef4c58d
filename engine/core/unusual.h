// Values that are possible but hardly meant: a modulus in GPa, a stiffness in N/m. They are computed with and named.
#pragma once

#include <string>
#include <vector>

#include "engine/core/error.h"
#include "engine/core/fields.h"

namespace lathelier {

namespace notes {

inline constexpr NoteCode valueUnusual{
    "value_unusual", Severity::Warning,
    LT_TEXT("Engine", "{parameter} is {found}; usual is {minimum} to {maximum}. Is its unit the one of the name?")};

}  // namespace notes

/// What the value of a field usually is.
struct UsualRange {
    std::string key;  ///< of the field
    Interval range;
};

/// Adds valueUnusual where `value` lies outside, once for each key.
void noteUnusual(const UsualRange& usual, double value, Notes& notes);

/// The same for the fields that `usual` lists.
template <class P>
void noteUnusual(const P& parameters, const std::vector<UsualRange>& usual, Notes& notes)
{
    const Values values = toValues(parameters);
    for (const UsualRange& one : usual) {
        const Value* const value = find(values, one.key);
        if (const auto* const number = value ? std::get_if<double>(value) : nullptr) noteUnusual(one, *number, notes);
    }
}

}  // namespace lathelier
