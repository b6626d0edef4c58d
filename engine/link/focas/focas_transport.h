// The link to a FANUC control through the vendor's library FOCAS2 (focas_api.h): registers of the R area of the PMC.
// Jasiewicz and Miądlicki, "An integrated CNC system for chatter suppression in turning", link its assistant so.
// Not verified on a real control.
#pragma once

#include <memory>

#include "engine/link/link_config.h"
#include "engine/link/transport.h"

namespace lathelier::link {

/// Values of registers within 64 bytes of each other are read by one call, so that they are of one moment. A call that
/// is not back within the time-out loses the link; until it is back, the link is not opened again. Errors of open(),
/// besides those of Transport, before anything is asked: linkValueNotHeld where a register cannot hold what is written
/// to it; linkNotFound where one that is written shares a byte with another.
std::unique_ptr<Transport> focasTransport(const FocasSettings& settings, double timeout_ms);

}  // namespace lathelier::link
