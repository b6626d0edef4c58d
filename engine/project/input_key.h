// Keys of a panel's inputs: a role with several files has the keys "role", "role.2", "role.3"…
#pragma once

#include <string>

namespace lathelier::project {

/// "record" and "record.2" belong to "record", "recorder" does not.
inline bool belongsTo(const std::string& input, const std::string& role)
{
    return input == role || input.starts_with(role + ".");
}

}  // namespace lathelier::project
