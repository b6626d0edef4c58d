// Completes the chain's question by the set-up as changed in the panel Deflection.
#pragma once

#include "engine/chain/of_project/project_chain.h"
#include "engine/task/stores.h"

namespace lathelier::chain {

/// With the set-up of the panel as a file of the chain, where its form or its spindle changes the file's values. An
/// unreadable file is left unchanged and reported by the step. Throws Cancelled.
AskedChain settled(AskedChain asked, Stores& stores, const Progress& progress);

}  // namespace lathelier::chain
