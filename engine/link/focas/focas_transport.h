// The link to a FANUC control through the vendor's library FOCAS2 (focas_api.h): registers of the R area of the PMC.
// Jasiewicz and Miądlicki, "An integrated CNC system for chatter suppression in turning", link its assistant so.
// Not verified on a real control.
#pragma once

#include <memory>

#include "engine/link/link_config.h"
#include "engine/link/transport.h"

namespace lathelier::link {

std::unique_ptr<Transport> focasTransport(const FocasSettings& settings, double timeout_ms);

}  // namespace lathelier::link
