// A step of a chain as the state of the panel of its task, so that a window shows the chain's own data.
#pragma once

#include <optional>
#include <string>

#include "engine/chain/dossier.h"
#include "engine/task/task.h"

namespace lathelier::chain {

/// The task of a step; nullptr: the step is not a task.
const task::Task* taskOf(const std::string& step);

/// Files within `folder`, the folder of the chain, with its path. None: the step is not a task or was not run.
std::optional<project::PanelState> stateOf(const ChainStep& step, const std::string& folder);

}  // namespace lathelier::chain
