// A PostgreSQL server of the tests' own: made in a temporary folder, reached over a socket in it and from nowhere else,
// and stopped with the process.
#pragma once

#include <sys/types.h>

#include <string>

#include "tests/scratch_folder.h"

namespace lathelier::archive {

class PostgresServer {
public:
    /// Started with its first use. Throws std::runtime_error where PostgreSQL is not installed or does not start.
    static PostgresServer& instance();
    ~PostgresServer();
    PostgresServer(const PostgresServer&) = delete;
    PostgresServer& operator=(const PostgresServer&) = delete;

    /// A new empty database; its location for the owner.
    std::string newDatabase();

    /// The same database for another role, which is made.
    std::string withRole(const std::string& location, const std::string& role, const std::string& member_of);

    /// The same database for a role that is there, or is not.
    static std::string forRole(const std::string& location, const std::string& role);

    const std::string& folder() const { return folder_; }

private:
    PostgresServer();
    pid_t start(const std::string& program, const std::string& arguments) const;

    ScratchFolder scratch_;
    std::string folder_ = scratch_.string();
    pid_t server_ = 0;
    int databases_ = 0;
};

}  // namespace lathelier::archive
