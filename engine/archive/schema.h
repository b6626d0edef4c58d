// The tables of an archive, as a list of steps from version to version.
//
// evaluation: one row for each evaluation (chain.h); `measured`: its values, stored in the order of characteristic and
// time, so that the values of one characteristic lie side by side; `recipe`, `characteristic`; `archive_property`:
// schema_version, and writer of a file; from version 2 on `job`, the queue of a batch. Triggers refuse every change of
// what is archived. Group roles of PostgreSQL: lathelier_reader selects, lathelier_writer adds, lathelier_admin may
// everything.
#pragma once

#include "engine/archive/sql/connection.h"

namespace lathelier::archive {

inline constexpr int schemaVersion = 2;

/// Makes the tables of `version` in an empty database, within the transaction of the caller.
void defineSchema(sql::Connection& connection, int version = schemaVersion);

/// The version of an archive; none: the database holds none.
std::optional<std::int64_t> versionOf(sql::Connection& connection);

/// The steps from `version` to the newest, within the transaction of the caller.
void migrateSchema(sql::Connection& connection, std::int64_t version);

/// Makes the group roles where the role may, and gives them their rights. False: some are missing. PostgreSQL only,
/// within the transaction of the caller.
bool grantRights(sql::Connection& connection);
inline constexpr const char* rolesOfGroups = "lathelier_reader, lathelier_writer, lathelier_admin";

}  // namespace lathelier::archive
