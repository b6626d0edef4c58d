// SQLite, one file: write-ahead log, every commit synchronised with the disk (synchronous = FULL), foreign keys.
// Sources: SQLite documentation, "Write-Ahead Logging", "Database File Format" (application_id, user_version).
#pragma once

#include <memory>
#include <string>

#include "engine/archive/sql/connection.h"

namespace lathelier::archive::sql {

/// At byte 68 of a file of ours: "LaAr".
inline constexpr std::int32_t sqliteApplicationId = 0x4C614172;

/// Opens an existing file of this application. It is looked at before SQLite opens it, so that a file of another kind
/// stays as it is. Errors noArchive, archiveNotOpened, archiveOnNetwork; fileNotFound of io.
std::unique_ptr<Connection> openSqlite(const std::string& path, bool is_read_only, const Progress& progress);

/// Makes a file with what `define` puts into it, whole or not at all. Errors archiveExists (it is left as it is),
/// archiveNotWritten, archiveOnNetwork.
void createSqlite(const std::string& path, const std::function<void(Connection&)>& define, const Progress& progress);

}  // namespace lathelier::archive::sql
