#include "engine/core/memory.h"

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <limits>
#include <optional>
#include <string>

namespace lathelier {
namespace {

constexpr std::uint64_t unlimited = std::numeric_limits<std::uint64_t>::max();

std::uint64_t remaining(std::uint64_t limit, std::uint64_t used)
{
    return limit > used ? limit - used : 0;
}

/// The number after `key` in a file of "key: number kB" lines.
std::optional<std::uint64_t> keyed_bytes(const char* path, const std::string& key)
{
    std::ifstream file(path);
    for (std::string word; file >> word;) {
        std::uint64_t kilobytes = 0;
        if (word == key && file >> kilobytes) return kilobytes * 1024;
    }
    return std::nullopt;
}

std::optional<std::uint64_t> readNumber(const std::string& path)
{
    std::ifstream file(path);
    std::uint64_t value = 0;
    return file >> value ? std::optional(value) : std::nullopt;  // "max" is no number: no limit
}

/// Of the control group (v2) that the process is in.
std::uint64_t groupLeft_bytes()
{
    std::ifstream file("/proc/self/cgroup");
    for (std::string line; std::getline(file, line);) {
        if (!line.starts_with("0::")) continue;
        const std::string folder = "/sys/fs/cgroup" + line.substr(3);
        const auto limit = readNumber(folder + "/memory.max");
        const auto used = readNumber(folder + "/memory.current");
        if (limit && used) return remaining(*limit, *used);
    }
    return unlimited;
}

std::uint64_t addressSpaceLeft_bytes()
{
    rlimit limit{};
    if (::getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY) return unlimited;
    const auto pages = readNumber("/proc/self/statm");
    return pages ? remaining(limit.rlim_cur, *pages * static_cast<std::uint64_t>(::sysconf(_SC_PAGESIZE))) : unlimited;
}

}  // namespace

std::uint64_t freeMemory_bytes()
{
    const std::uint64_t machine = keyed_bytes("/proc/meminfo", "MemAvailable:").value_or(unlimited);
    return std::min({machine, groupLeft_bytes(), addressSpaceLeft_bytes()});
}

}  // namespace lathelier
