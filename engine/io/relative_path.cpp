#include "engine/io/relative_path.h"

#include <filesystem>

namespace lathelier::io {

namespace fs = std::filesystem;

std::string relativePath(const std::string& folder, const std::string& path)
{
    const fs::path base = fs::absolute(folder.empty() ? "." : folder).lexically_normal();
    const std::string relative = fs::absolute(path).lexically_normal().lexically_relative(base).generic_string();
    return relative.empty() ? path : relative;
}

std::string openablePath(const std::string& folder, const std::string& stated)
{
    return (fs::path(folder) / stated).lexically_normal().string();
}

}  // namespace lathelier::io
