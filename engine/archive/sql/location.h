// Where an archive lies: the path of a file, or a database as libpq names it.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace lathelier::archive::sql {

/// "postgresql://…", "postgres://…", or "host=… dbname=…" that begins with a key of libpq.
/// Source: PostgreSQL 15, libpq, 34.1.1 Connection Strings.
bool namesDatabase(const std::string& location);

/// The location without what stands in it as a password, for messages; that of a file as it is.
std::string withoutSecrets(const std::string& location);

/// Whether it states a password, in any of the ways of libpq (user:password@, ?password=, password=, sslpassword).
bool statesPassword(const std::string& location);

/// A socket of this machine or a loopback address: "", "/run/postgresql", "@name", "localhost", "127.…", "::1".
bool isThisMachine(std::string_view host);

/// What sslmode is to be. `hosts` are those that libpq will try ("a,b"), `mode` what it would take, `is_stated` whether
/// somebody chose that. Empty: as it is, for all are on this machine. Else one that requires TLS: verify-full where
/// none was stated. None: one was stated that does not require it.
std::optional<std::string> demandedTls(std::string_view hosts, const std::string& mode, bool is_stated);

}  // namespace lathelier::archive::sql
