// Parameters and reading options as a file keeps them beside a task: recipes, configurations of links.
#pragma once

#include <vector>

#include "engine/core/fields.h"
#include "engine/core/json.h"
#include "engine/task/task.h"

namespace lathelier::task {

/// The question without what windows alone keep.
std::vector<FieldInfo> questionFields(const Task& task);

/// Reading options of all kinds of file of the task.
std::vector<FieldInfo> readingFields(const Task& task);

/// Their defaults.
Values readingDefaults(const Task& task);

/// The values that the fields describe, in the types that a file gives them.
Values asRead(const std::vector<FieldInfo>& fields, const Values& values);

}  // namespace lathelier::task
