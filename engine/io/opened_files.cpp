#include "engine/io/opened_files.h"

#include <map>
#include <mutex>
#include <utility>

namespace lathelier::io {
namespace {

struct OpenedFiles {
    std::mutex mutex;
    std::map<std::pair<dev_t, ino_t>, std::string> names;
};

OpenedFiles& opened()
{
    static OpenedFiles files;
    return files;
}

std::function<void()>& writeCheck()
{
    static std::function<void()> check;
    return check;
}

}  // namespace

void noteOpened(const std::string& path, const struct stat& status)
{
    if (!S_ISREG(status.st_mode)) return;
    OpenedFiles& files = opened();
    const std::lock_guard lock(files.mutex);
    files.names.try_emplace({status.st_dev, status.st_ino}, path);
}

std::optional<std::string> openedAs(const std::string& path)
{
    struct stat status {};
    if (::stat(path.c_str(), &status) != 0) return std::nullopt;
    OpenedFiles& files = opened();
    const std::lock_guard lock(files.mutex);
    const auto found = files.names.find({status.st_dev, status.st_ino});
    return found == files.names.end() ? std::nullopt : std::optional(found->second);
}

void setWriteCheck(std::function<void()> check)
{
    writeCheck() = std::move(check);
}

void checkWrite()
{
    if (writeCheck()) writeCheck()();
}

}  // namespace lathelier::io
