// Keys of the inputs of a panel: "role", and "role.2", "role.3"… where a role has several files.
#pragma once

#include <string>
#include <vector>

#include "engine/project/project.h"

namespace lathelier::project {

/// "record" and "record.2" belong to "record", "recorder" does not.
inline bool belongsTo(const std::string& input, const std::string& role)
{
    return input == role || input.starts_with(role + ".");
}

/// Of the number-th file of a role, counted from 1.
inline std::string keyOf(const std::string& role, std::size_t number)
{
    return number == 1 ? role : role + "." + std::to_string(number);
}

/// The keys given, in the order of their numbers up to the first gap.
inline std::vector<std::string> keysOf(const PanelState& state, const std::string& role)
{
    std::vector<std::string> keys;
    for (std::string key = role; state.inputs.count(key) > 0; key = keyOf(role, keys.size() + 1)) keys.push_back(key);
    return keys;
}

}  // namespace lathelier::project
