// The link to LinuxCNC: a component of its hardware abstraction layer (HAL), through liblinuxcnchal. Pins have the
// names of control_values.h after that of the component, with "-" in place of "_": lathelier.diameter-mm. What is read
// are inputs of the type float (running: a bit), what is written are outputs of the type float.
//
// The library is loaded when the link starts, so that the program runs where LinuxCNC is not installed. The component
// is known by its name, and HAL refuses a second one of it. A component that is made anew has its pins, but nothing is
// wired to them: LinuxCNC starts the program itself from its HAL file (loadusr -Wn) and ends it with itself by a
// signal.
#pragma once

#include <memory>

#include "engine/link/link_config.h"
#include "engine/link/transport.h"

namespace lathelier::link {

/// `timeout_ms`: of the port that names the loaded program.
std::unique_ptr<Transport> halTransport(const LinuxCncSettings& settings, double timeout_ms);

}  // namespace lathelier::link
