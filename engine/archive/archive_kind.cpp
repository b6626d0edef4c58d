#include "engine/archive/archive_kind.h"

#include "engine/archive/archive.h"
#include "engine/archive/sql/connection.h"
#include "engine/archive/sql/sqlite_connection.h"

namespace lathelier::archive {
namespace {

using namespace std::string_view_literals;

io::Likeness likeArchive(const std::string&, std::string_view head, const Values&)
{
    constexpr std::string_view magic = "SQLite format 3\0"sv;
    constexpr std::size_t placeOfId = 68, bytesOfId = 4;
    if (!head.starts_with(magic) || head.size() < placeOfId + bytesOfId) return io::Likeness::No;
    std::uint32_t id = 0;
    for (const char byte : head.substr(placeOfId, bytesOfId)) id = id << 8U | static_cast<unsigned char>(byte);
    return id == static_cast<std::uint32_t>(sql::sqliteApplicationId) ? io::Likeness::Certain : io::Likeness::No;
}

io::FileFacts factsOf(const io::FileToRead& file, Notes& notes)
{
    Archive archive = Archive::open(file.path, Access::Read, file.progress);
    notes.insert(notes.end(), archive.notes().begin(), archive.notes().end());
    Filter latest;
    latest.most = 1;
    const std::vector<Entry> entries = archive.list(latest, file.progress);
    io::FileFacts facts;
    facts.path = file.path;
    facts.format = "archive";
    facts.details = {{"evaluations", archive.connection().count("SELECT count(*) FROM evaluation")},
                     {"characteristics", static_cast<std::int64_t>(archive.characteristics({}, file.progress).size())},
                     {"last_recorded_at", entries.empty() ? Value() : Value(entries.front().recorded_at)}};
    return facts;
}

}  // namespace

const io::FileKind& archiveFiles()
{
    static const io::FileKind kind{
        "archive", LT_TEXT("Engine", "Archives of evaluations"), "*.archive *.sqlite *.db", {}, {}, likeArchive,
        factsOf};
    return kind;
}

}  // namespace lathelier::archive
