#include "engine/core/utc_time.h"

#include <chrono>
#include <cstdint>
#include <cstdio>
#include <ctime>

namespace lathelier {

std::string utcNow()
{
    const auto now = std::chrono::time_point_cast<std::chrono::milliseconds>(std::chrono::system_clock::now());
    const std::int64_t sinceEpoch_ms = now.time_since_epoch().count();
    const auto seconds = static_cast<std::time_t>(sinceEpoch_ms / 1000);
    std::tm utc{};
    gmtime_r(&seconds, &utc);
    char buffer[40];
    std::string time(buffer, std::strftime(buffer, sizeof buffer, "%Y-%m-%dT%H:%M:%S", &utc));
    std::snprintf(buffer, sizeof buffer, ".%03dZ", static_cast<int>(sinceEpoch_ms % 1000));
    return time + buffer;
}

}  // namespace lathelier
