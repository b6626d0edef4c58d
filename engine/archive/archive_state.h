// What is behind an Archive.
#pragma once

#include <memory>
#include <mutex>
#include <string>

#include "engine/archive/archive.h"
#include "engine/archive/sql/connection.h"

namespace lathelier::archive {

struct Archive::State {
    std::unique_ptr<sql::Connection> connection;
    std::string location;  ///< as it may be shown
    std::string writer;    ///< of rows that are added here
    Notes notes;
    std::mutex mutex;  ///< one caller at a time
};

/// The connection looks at a progress as long as this lives.
class Watch {
public:
    Watch(sql::Connection& connection, const Progress& progress) : connection_(connection)
    {
        progress.check();
        connection_.watch(progress);
    }
    ~Watch() { connection_.watch({}); }
    Watch(const Watch&) = delete;
    Watch& operator=(const Watch&) = delete;

private:
    sql::Connection& connection_;
};

/// A call: it alone has the connection, in one transaction.
class Call {
public:
    Call(std::mutex& mutex, sql::Connection& connection, sql::TransactionKind kind, const Progress& progress)
        : lock_(mutex), watch_(connection, progress), transaction_(connection, kind)
    {
    }
    void commit() { transaction_.commit(); }

private:
    std::scoped_lock<std::mutex> lock_;
    Watch watch_;
    sql::Transaction transaction_;
};

/// Values of an error or note about a row.
Values valuesOf(const BrokenRow& broken, const std::string& location);

}  // namespace lathelier::archive
