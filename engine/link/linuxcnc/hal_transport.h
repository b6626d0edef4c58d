// The link to LinuxCNC: a component of its hardware abstraction layer (HAL), through liblinuxcnchal. Pins have the
// names of control_values.h after that of the component, with "-" in place of "_": lathelier.diameter-mm. What is read
// are inputs of the type float (running: a bit), what is written are outputs of the type float.
//
// The library is loaded when the link starts, so that the program runs where LinuxCNC is not installed. Pins stand as
// long as LinuxCNC runs: a link that is closed and opened again has the pins of the same component. The component is
// known by its name, and HAL refuses a second one of it.
#pragma once

#include <memory>

#include "engine/link/link_config.h"
#include "engine/link/transport.h"

namespace lathelier::link {

/// `timeout_ms`: of the port that names the loaded program.
std::unique_ptr<Transport> halTransport(const LinuxCncSettings& settings, double timeout_ms);

}  // namespace lathelier::link
