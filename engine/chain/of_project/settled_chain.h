// Completes the chain's question by what the questions of the part make of their inputs.
#pragma once

#include "engine/chain/of_project/project_chain.h"
#include "engine/task/stores.h"
#include "engine/walk/walk.h"

namespace lathelier::chain {

/// With files of the chain for the set-up of Deflection, where its form or its spindle changes the file's values; for
/// the drawing, where its table was edited; for the machine that was measured. What is unreadable is left unchanged and
/// reported by its step. Throws Cancelled.
AskedChain settled(AskedChain asked, const walk::Walk& walk, Stores& stores, const Progress& progress);

}  // namespace lathelier::chain
