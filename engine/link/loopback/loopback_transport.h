// The link to a simulated control over TCP (messages.h), for schools and tests.
#pragma once

#include <memory>

#include "engine/link/link_config.h"
#include "engine/link/transport.h"

namespace lathelier::link {

/// `timeout_ms`: of connecting, and of each answer.
std::unique_ptr<Transport> loopbackTransport(const LoopbackSettings& settings, double timeout_ms);

}  // namespace lathelier::link
