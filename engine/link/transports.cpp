#include "engine/link/transports.h"

#include "engine/core/core_codes.h"
#include "engine/link/focas/focas_transport.h"
#include "engine/link/link_codes.h"
#include "engine/link/linuxcnc/hal_transport.h"
#include "engine/link/loopback/loopback_transport.h"

namespace lathelier::link {
const std::vector<TransportKind>& transportKinds()
{
    static const std::vector<TransportKind> all{
        {"loopback", LT_TEXT("Engine", "Simulated control"), true, true,
         [](const LinkConfig& config) { return config.loopback.has_value(); },
         [](const LinkConfig& config) { return loopbackTransport(*config.loopback, config.loop.timeout_ms); }},
        {"linuxcnc", LT_TEXT("Engine", "LinuxCNC"), true, false,
         [](const LinkConfig& config) { return config.linuxcnc.has_value(); },
         [](const LinkConfig& config) { return halTransport(*config.linuxcnc, config.loop.timeout_ms); }},
        {"focas", LT_TEXT("Engine", "FANUC (FOCAS2)"), false, true,
         [](const LinkConfig& config) { return config.focas.has_value(); },
         [](const LinkConfig& config) { return focasTransport(*config.focas, config.loop.timeout_ms); }},
    };
    return all;
}

std::unique_ptr<Transport> transportOf(const std::string& kind, const LinkConfig& config)
{
    std::string known;
    for (const TransportKind& one : transportKinds()) {
        if (kind == one.key) {
            if (!one.is_configured(config)) throw Error(errors::linkNotConfigured, {{"kind", kind}});
            return one.make(config);
        }
        known.append(known.empty() ? "" : " | ").append(one.key);
    }
    throw Error(errors::valueNotUnderstood, {{"parameter", "link"}, {"found", kind}, {"expected", known}});
}

}  // namespace lathelier::link
