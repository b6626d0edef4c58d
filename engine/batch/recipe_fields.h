// Parameters and reading options of a recipe as the task describes them.
#pragma once

#include <vector>

#include "engine/core/fields.h"
#include "engine/core/json.h"
#include "engine/task/task.h"

namespace lathelier::batch {

/// The question without what windows alone keep.
std::vector<FieldInfo> questionFields(const task::Task& task);

/// Reading options of all kinds of file of the task.
std::vector<FieldInfo> readingFields(const task::Task& task);

/// Their defaults.
Values readingDefaults(const task::Task& task);

/// The values that the fields describe, in the types that a file gives them.
Values asRead(const std::vector<FieldInfo>& fields, const Values& values);

}  // namespace lathelier::batch
