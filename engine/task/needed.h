// What may stand in place of an input of a task.
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

/// Whether the input belongs to others (Task::only_with) of which none is given.
inline bool saysNothing(const Task& task, const project::PanelState& state, const Input& input)
{
    return std::any_of(task.only_with.begin(), task.only_with.end(), [&](const OnlyWith& rule) {
        return std::find(rule.keys.begin(), rule.keys.end(), input.role) != rule.keys.end() &&
               std::none_of(rule.with.begin(), rule.with.end(),
                            [&](const std::string& key) { return isGiven(task, state, key); });
    });
}

/// Whether its file gives a field that a window edits.
inline bool givesField(const Task& task, const Input& input)
{
    return std::any_of(task.fields.begin(), task.fields.end(),
                       [&](const FieldInfo& field) { return task.fileOf(field) == &input; });
}

/// Required, and nothing may stand in its place.
inline bool isNeeded(const Task& task, const Input& input)
{
    return input.required && !isReplaceable(task, input);
}

}  // namespace lathelier::task
