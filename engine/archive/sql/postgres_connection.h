// PostgreSQL by libpq. What is ours lies in the schema `lathelier` of the database.
//
// Over the network TLS is required: sslmode below `require` is refused, one that is not stated becomes verify-full.
// A server that does not answer is given up after 10 s (connect_timeout), a statement after 5 minutes.
// Source: PostgreSQL 15, libpq (34.1 Database Connection Control Functions, 34.4 Asynchronous Command Processing).
#pragma once

#include <memory>
#include <string>

#include "engine/archive/sql/connection.h"

namespace lathelier::archive::sql {

inline constexpr const char* postgresSchema = "lathelier";

/// Errors: passwordInLocation, locationUnclear, tlsRequired (exit 2); archiveNotOpened.
std::unique_ptr<Connection> openPostgres(const std::string& location, bool is_read_only, const Progress& progress);

}  // namespace lathelier::archive::sql
