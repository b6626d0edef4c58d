#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>

#include "engine/archive/archive_codes.h"
#include "engine/archive/sql/file_system.h"
#include "engine/archive/sql/random_uuid.h"
#include "engine/archive/sql/sqlite_connection.h"
#include "engine/archive/sql/sqlite_driver.h"
#include "engine/io/file.h"

namespace lathelier::archive::sql {
namespace {

constexpr std::string_view sqliteHead{"SQLite format 3\0", 16};
constexpr std::size_t placeOfApplication = 68;
constexpr std::size_t sizeOfHead = 100;

void refuseNetwork(const std::string& path)
{
    if (const auto system = networkFileSystemOf(path))
        throw Error(errors::archiveOnNetwork, {{"location", path}, {"file_system", *system}});
}

std::int32_t bigEndian(std::string_view bytes)
{
    std::uint32_t number = 0;
    for (const char byte : bytes) number = number << 8 | static_cast<unsigned char>(byte);
    return static_cast<std::int32_t>(number);
}

/// The head is written when the file is made and never changes, so it is right though a log may lie beside the file.
void refuseOtherKinds(const std::string& path)
{
    const std::string head = io::fileHead(path, sizeOfHead);
    const auto refuse = [&path](Text found) { throw Error(errors::noArchive, {{"location", path}, {"found", found}}); };
    if (head.empty()) refuse(LT_TEXT("Engine", "an empty file"));
    if (head.size() < sizeOfHead || !head.starts_with(sqliteHead))
        refuse(LT_TEXT("Engine", "a file that is no database of SQLite"));
    if (bigEndian(std::string_view(head).substr(placeOfApplication, 4)) != sqliteApplicationId)
        refuse(LT_TEXT("Engine", "a database of another program"));
}

/// Gives the file its name unless there is one of this name.
bool renameIfFree(const std::string& from, const std::string& to)
{
    if (::renameat2(AT_FDCWD, from.c_str(), AT_FDCWD, to.c_str(), RENAME_NOREPLACE) == 0) return true;
    if (errno == EEXIST) return false;
    if (::link(from.c_str(), to.c_str()) == 0) return true;  // where the file system cannot rename so
    if (errno == EEXIST) return false;
    throw Error(errors::archiveNotWritten, {{"location", to}, {"reason", std::string(std::strerror(errno))}});
}

}  // namespace

std::unique_ptr<Connection> openSqlite(const std::string& path, bool is_read_only, const Progress& progress)
{
    refuseOtherKinds(path);
    refuseNetwork(path);
    return openSqliteFile(path, is_read_only, progress);
}

void createSqlite(const std::string& path, const std::function<void(Connection&)>& define, const Progress& progress)
{
    refuseNetwork(path);
    struct stat status {};
    if (::lstat(path.c_str(), &status) == 0) {
        refuseOtherKinds(path);
        throw Error(errors::archiveExists, {{"location", path}});
    }
    // Made elsewhere and copied as a whole: a stop at any moment leaves no half file of this name.
    const io::PartFolder folder;
    const std::string made = folder.path() + "/archive";
    makeSqliteFile(made, path, define, progress);
    const std::string part = path + "." + randomUuid() + ".part";
    try {
        io::writeFile(part, io::FileBytes(made).view());
        const bool is_ours = renameIfFree(part, path);
        std::error_code ignored;
        std::filesystem::remove(part, ignored);
        if (!is_ours) throw Error(errors::archiveExists, {{"location", path}});
    } catch (const Error& error) {
        std::error_code ignored;
        std::filesystem::remove(part, ignored);
        const Value* reason = find(error.values(), "reason");
        if (!reason) throw;
        throw Error(errors::archiveNotWritten, {{"location", path}, {"reason", *reason}});
    }
}

}  // namespace lathelier::archive::sql
