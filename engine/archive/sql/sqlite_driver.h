// The part of sqlite_connection.h that speaks to the library.
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "engine/archive/sql/connection.h"

namespace lathelier::archive::sql {

/// Opens a file that is known to be ours. Error archiveNotOpened.
std::unique_ptr<Connection> openSqliteFile(const std::string& path, bool is_read_only, const Progress& progress);

/// Makes a file at `place`, which errors call `shown`, with everything in it and nothing in a log beside it.
void makeSqliteFile(const std::string& place, const std::string& shown, const std::function<void(Connection&)>& define,
                    const Progress& progress);

}  // namespace lathelier::archive::sql
