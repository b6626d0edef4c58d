// The part of a cache key that stands for what was read.
#pragma once

#include <cstddef>
#include <initializer_list>
#include <string>

#include "engine/task/inputs.h"

namespace lathelier::task {

/// Equal where the same was read in the same way: the content of all files and items read since `sources` had `first`
/// inputs, and the reading options of the inputs of `roles`, without which one file has several meanings.
std::string readKey(const project::PanelState& state, std::initializer_list<std::string> roles, const Sources& sources,
                    std::size_t first);

}  // namespace lathelier::task
