#include "engine/link/transports.h"

#include "engine/core/core_codes.h"
#include "engine/link/focas/focas_transport.h"
#include "engine/link/link_codes.h"
#include "engine/link/linuxcnc/hal_transport.h"
#include "engine/link/loopback/loopback_transport.h"

namespace lathelier::link {
namespace {

template <class Settings>
const Settings& needed(const std::optional<Settings>& settings, const char* kind)
{
    if (!settings) throw Error(errors::linkNotConfigured, {{"kind", kind}});
    return *settings;
}

}  // namespace

const std::vector<TransportKind>& transportKinds()
{
    static const std::vector<TransportKind> all{
        {"loopback", LT_TEXT("Engine", "Simulated control"), true, true,
         [](const LinkConfig& config) {
             return loopbackTransport(needed(config.loopback, "loopback"), config.loop.timeout_ms);
         }},
        {"linuxcnc", LT_TEXT("Engine", "LinuxCNC"), true, false,
         [](const LinkConfig& config) {
             return halTransport(needed(config.linuxcnc, "linuxcnc"), config.loop.timeout_ms);
         }},
        {"focas", LT_TEXT("Engine", "FANUC (FOCAS2)"), false, true,
         [](const LinkConfig& config) {
             return focasTransport(needed(config.focas, "focas"), config.loop.timeout_ms);
         }},
    };
    return all;
}

std::unique_ptr<Transport> transportOf(const std::string& kind, const LinkConfig& config)
{
    std::string known;
    for (const TransportKind& one : transportKinds()) {
        if (kind == one.key) return one.make(config);
        known.append(known.empty() ? "" : " | ").append(one.key);
    }
    throw Error(errors::valueNotUnderstood, {{"parameter", "link"}, {"found", kind}, {"expected", known}});
}

}  // namespace lathelier::link
