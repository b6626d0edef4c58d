// What of the chain's question has to be read before it can be asked: the set-up as the panel "Deflection" changes it.
#pragma once

#include "widgets/chain/chain_state.h"
#include "widgets/core/files/stores.h"

namespace lathelier::chain_panel {

/// With the set-up of the panel as a file of the chain, where its form or its spindle changes what the file has. A file
/// that cannot be read stays as it is: the step says why. Throws Cancelled.
AskedChain settled(AskedChain asked, Stores& stores, const Progress& progress);

}  // namespace lathelier::chain_panel
