// Which NC program is loaded on LinuxCNC, asked of linuxcncrsh over TCP on this machine.
#pragma once

#include <optional>
#include <string>

#include "engine/link/link_config.h"

namespace lathelier::link {

/// Its path; nothing: none is loaded, or nobody answers within the time-out.
std::optional<std::string> programOfLinuxCnc(const LinuxCncSettings& settings, double timeout_ms);

/// The path in what linuxcncrsh answers to "get program": "PROGRAM shaft.ngc", "PROGRAM NONE".
std::optional<std::string> programIn(const std::string& answer);

}  // namespace lathelier::link
