// Which inputs a task cannot do without.
#pragma once

#include <algorithm>

#include "engine/task/task.h"

namespace lathelier::task {

/// Whether something else may stand in place of the input.
inline bool isReplaceable(const Task& task, const Input& input)
{
    const std::vector<std::string>& keys = task.one_of.keys;
    return std::find(keys.begin(), keys.end(), input.role) != keys.end();
}

/// Required, and nothing may stand in its place.
inline bool isNeeded(const Task& task, const Input& input)
{
    return input.required && !isReplaceable(task, input);
}

}  // namespace lathelier::task
