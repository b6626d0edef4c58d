// The kinds of links, by the names that the command line and the panel know them by.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "engine/link/link_config.h"
#include "engine/link/transport.h"

namespace lathelier::link {

struct TransportKind {
    const char* key;     ///< "loopback"; also that of its part of ASSIST.json
    Text title;          ///< as a window shows it
    bool is_verified;    ///< on a real control, or on what it stands for
    bool is_for_window;  ///< false: the control starts and ends the program that is linked to it
    bool (*is_configured)(const LinkConfig& config);
    std::unique_ptr<Transport> (*make)(const LinkConfig& config);  ///< only where it is configured
};

const std::vector<TransportKind>& transportKinds();

/// Errors: valueNotUnderstood (no such kind), linkNotConfigured.
std::unique_ptr<Transport> transportOf(const std::string& kind, const LinkConfig& config);

}  // namespace lathelier::link
