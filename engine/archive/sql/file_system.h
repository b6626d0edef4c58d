// File systems of a network: locks and shared memory of SQLite's write-ahead log do not hold there.
// Source: SQLite, Write-Ahead Logging, section 1 ("all processes must be on the same host"); statfs(2).
#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace lathelier::archive::sql {

/// The name of a file system that is not of this machine alone; none: a local one. `magic` as statfs() gives it;
/// `mount_type` is the type of the mount, "fuse.sshfs", and counts for FUSE only, whose kinds are refused unless they
/// are known to be local.
std::optional<std::string> networkFileSystem(std::int64_t magic, const std::string& mount_type);

/// The same of the place of `path`, which need not exist. None where the system does not tell.
std::optional<std::string> networkFileSystemOf(const std::string& path);

}  // namespace lathelier::archive::sql
