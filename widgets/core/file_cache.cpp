#include "widgets/core/file_cache.h"

#include <filesystem>

namespace lathelier {

std::string fileStamp(const std::string& path)
{
    std::error_code problem;
    const auto size = std::filesystem::file_size(path, problem);
    const auto changed = std::filesystem::last_write_time(path, problem);
    return std::to_string(size) + "@" + std::to_string(changed.time_since_epoch().count());
}

}  // namespace lathelier
