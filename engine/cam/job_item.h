// A job as an item of the project: its fields, and its shaft where it holds one.
#pragma once

#include <optional>

#include "engine/cam/job.h"

namespace lathelier::cam {

inline constexpr const char* jobItem = "job";  ///< kind of the item

/// Values of the item: those of toValues(job), and the shaft as a table of one row under "shaft".
Values valuesOf(const Job& job);

/// The inverse; none when the values are not those of a job with a bar, a chuck, tools and cutting data.
std::optional<Job> jobOf(const Values& values);

}  // namespace lathelier::cam
