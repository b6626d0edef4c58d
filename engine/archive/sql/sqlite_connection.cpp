#include "engine/archive/sql/sqlite_connection.h"

#include <sqlite3.h>
#include <sys/stat.h>

#include <chrono>
#include <cstring>
#include <thread>
#include <unordered_map>

#include "engine/archive/archive_codes.h"
#include "engine/archive/sql/sql_reasons.h"

namespace lathelier::archive::sql {
namespace {

constexpr int mostStatements = 200;
constexpr auto pauseOfWaiting = std::chrono::milliseconds(20);
constexpr int mostPauses = 1500;           // half a minute
constexpr int stepsBetweenChecks = 20000;  // of SQLite's machine: about a millisecond

using Statement = std::unique_ptr<sqlite3_stmt, int (*)(sqlite3_stmt*)>;

class SqliteRow final : public RowView {
public:
    explicit SqliteRow(sqlite3_stmt* statement) : statement_(statement) {}
    bool isNull(int column) const override { return sqlite3_column_type(statement_, column) == SQLITE_NULL; }
    std::int64_t integer(int column) const override { return sqlite3_column_int64(statement_, column); }
    double number(int column) const override { return sqlite3_column_double(statement_, column); }
    std::string_view text(int column) const override
    {
        // As bytes: of a text that is asked for as such SQLite makes a copy, for the zero behind it.
        const auto* bytes = static_cast<const char*>(sqlite3_column_blob(statement_, column));
        if (bytes == nullptr) return {};
        return {bytes, static_cast<std::size_t>(sqlite3_column_bytes(statement_, column))};
    }

private:
    sqlite3_stmt* statement_;
};

/// A statement that ends with its scope: it is free for its next use, and holds no lock.
class Running {
public:
    explicit Running(sqlite3_stmt* statement) : statement_(statement) {}
    ~Running()
    {
        sqlite3_reset(statement_);
        sqlite3_clear_bindings(statement_);
    }
    Running(const Running&) = delete;
    Running& operator=(const Running&) = delete;

private:
    sqlite3_stmt* statement_;
};

Value reasonOf(int code, int system_error, const char* message)
{
    switch (code & 0xFF) {
        case SQLITE_FULL: return reasons::diskFull;
        case SQLITE_READONLY: return reasons::readOnly;
        case SQLITE_PERM:
        case SQLITE_AUTH: return reasons::notPermitted;
        case SQLITE_BUSY:
        case SQLITE_LOCKED: return reasons::held;
        case SQLITE_CORRUPT:
        case SQLITE_NOTADB: return reasons::damaged;
        case SQLITE_NOMEM: return reasons::memory;
        default: break;
    }
    if (system_error == ENOSPC || system_error == EDQUOT) return reasons::diskFull;
    if ((code & 0xFF) == SQLITE_IOERR && system_error == EFBIG) return reasons::diskFull;
    return std::string(message);
}

class SqliteConnection final : public Connection {
public:
    SqliteConnection(const std::string& path, std::string shown, int flags) : location_(std::move(shown))
    {
        sqlite3* made = nullptr;
        // One caller at a time is our own rule; SQLite's lock around every cell would take half of the time of a
        // series.
        const int code = sqlite3_open_v2(path.c_str(), &made, flags | SQLITE_OPEN_URI | SQLITE_OPEN_NOMUTEX, nullptr);
        database_.reset(made);
        if (made != nullptr) {
            sqlite3_extended_result_codes(made, 1);
            sqlite3_busy_handler(made, &SqliteConnection::wait, this);
            sqlite3_progress_handler(made, stepsBetweenChecks, &SqliteConnection::isStopped, this);
        }
        check(code);
    }

    Dialect dialect() const override { return Dialect::Sqlite; }
    const std::string& location() const override { return location_; }

    void each(const std::string& statement, const Cells& parameters,
              const std::function<void(const RowView&)>& use) override
    {
        sqlite3_stmt* const prepared = prepare(statement);
        const Running running(prepared);
        bind(prepared, parameters);
        const SqliteRow row(prepared);
        int code = sqlite3_step(prepared);
        for (; code == SQLITE_ROW; code = sqlite3_step(prepared)) use(row);
        if (code != SQLITE_DONE) check(code);
    }

    std::int64_t change(const std::string& statement, const Cells& parameters) override
    {
        each(statement, parameters, [](const RowView&) {});
        return sqlite3_changes64(database_.get());
    }

    void run(const std::string& statements) override
    {
        check(sqlite3_exec(database_.get(), statements.c_str(), nullptr, nullptr, nullptr));
    }

protected:
    void begin(TransactionKind kind) override { run(kind == TransactionKind::Write ? "BEGIN IMMEDIATE" : "BEGIN"); }
    void commit() override { run("COMMIT"); }
    void rollback() noexcept override
    {
        // Some errors have taken everything back already. A stop that is asked for may not interrupt this.
        sqlite3_progress_handler(database_.get(), 0, nullptr, nullptr);
        if (sqlite3_get_autocommit(database_.get()) == 0)
            sqlite3_exec(database_.get(), "ROLLBACK", nullptr, nullptr, nullptr);
        sqlite3_progress_handler(database_.get(), stepsBetweenChecks, &SqliteConnection::isStopped, this);
    }

private:
    static int wait(void* self, int count)
    {
        const auto* connection = static_cast<const SqliteConnection*>(self);
        if (connection->progress_.stopped() || count > mostPauses) return 0;
        std::this_thread::sleep_for(pauseOfWaiting);
        return 1;
    }

    static int isStopped(void* self) { return static_cast<const SqliteConnection*>(self)->progress_.stopped() ? 1 : 0; }

    void check(int code) const
    {
        if (code == SQLITE_OK) return;
        if (progress_.stopped() && (code == SQLITE_INTERRUPT || (code & 0xFF) == SQLITE_BUSY)) throw Cancelled();
        sqlite3* const database = database_.get();
        const Value reason = reasonOf(code, database ? sqlite3_system_errno(database) : 0,
                                      database ? sqlite3_errmsg(database) : sqlite3_errstr(code));
        throw Error(isWriting_ ? errors::archiveNotWritten : errors::archiveNotRead,
                    {{"location", location_}, {"reason", reason}});
    }

    sqlite3_stmt* prepare(const std::string& statement)
    {
        if (const auto found = statements_.find(statement); found != statements_.end()) return found->second.get();
        if (statements_.size() >= mostStatements) statements_.clear();
        sqlite3_stmt* made = nullptr;
        check(sqlite3_prepare_v3(database_.get(), statement.data(), static_cast<int>(statement.size()),
                                 SQLITE_PREPARE_PERSISTENT, &made, nullptr));
        return statements_.emplace(statement, Statement(made, &sqlite3_finalize)).first->second.get();
    }

    void bind(sqlite3_stmt* statement, const Cells& parameters) const
    {
        for (std::size_t i = 0; i < parameters.size(); ++i) {
            const int place =
                sqlite3_bind_parameter_index(statement, std::string("$").append(std::to_string(i + 1)).c_str());
            if (place > 0) check(bindOne(statement, place, parameters[i]));
        }
    }

    static int bindOne(sqlite3_stmt* statement, int place, const Cell& cell)
    {
        if (const auto* integer = std::get_if<std::int64_t>(&cell))
            return sqlite3_bind_int64(statement, place, *integer);
        if (const auto* number = std::get_if<double>(&cell)) return sqlite3_bind_double(statement, place, *number);
        if (const auto* text = std::get_if<std::string>(&cell))
            return sqlite3_bind_text64(statement, place, text->data(), text->size(), nullptr, SQLITE_UTF8);
        return sqlite3_bind_null(statement, place);
    }

    std::string location_;
    std::unique_ptr<sqlite3, int (*)(sqlite3*)> database_{nullptr, &sqlite3_close_v2};
    std::unordered_map<std::string, Statement> statements_;
};

/// "file:…?immutable=1" for SQLite: what is special in addresses is escaped.
std::string immutableAddress(const std::string& path)
{
    std::string address = "file:";
    for (const char sign : path) {
        if (sign == '%' || sign == '?' || sign == '#') {
            constexpr const char* digits = "0123456789ABCDEF";
            const auto code = static_cast<unsigned char>(sign);
            address.append({'%', digits[code / 16], digits[code % 16]});
        } else {
            address += sign;
        }
    }
    return address + "?immutable=1";
}

/// A name that begins like an address is a path all the same.
std::string plainPath(const std::string& path)
{
    return path.starts_with("file:") || path.starts_with(":") ? std::string("./").append(path) : path;
}

bool hasLog(const std::string& path)
{
    struct stat status {};
    return ::stat((path + "-wal").c_str(), &status) == 0 && status.st_size > 0;
}

std::unique_ptr<Connection> opened(const std::string& path, const std::string& shown, int flags,
                                   const Progress& progress, const char* settings)
{
    auto connection = std::make_unique<SqliteConnection>(path, shown, flags);
    connection->watch(progress);
    connection->run(settings);
    return connection;
}

[[noreturn]] void throwNotOpened(const Error& error)
{
    const Value* reason = find(error.values(), "reason");
    const Value* location = find(error.values(), "location");
    throw Error(errors::archiveNotOpened,
                {{"location", location ? *location : Value()}, {"reason", reason ? *reason : Value()}});
}

}  // namespace

std::unique_ptr<Connection> openSqliteFile(const std::string& path, bool is_read_only, const Progress& progress)
{
    const std::string plain = plainPath(path);
    try {
        if (!is_read_only)
            return opened(plain, path, SQLITE_OPEN_READWRITE, progress,
                          "PRAGMA synchronous = FULL; PRAGMA foreign_keys = ON; PRAGMA recursive_triggers = ON; "
                          "PRAGMA cell_size_check = ON; PRAGMA journal_mode = WAL; SELECT count(*) FROM sqlite_schema");
        // Who may write the file takes its log away behind him; who may not reads it as it is. On a medium that nobody
        // can write SQLite makes no memory to share beside the file, and needs none.
        const char* look = "PRAGMA query_only = ON; SELECT count(*) FROM sqlite_schema";
        try {
            return opened(plain, path, SQLITE_OPEN_READWRITE, progress, look);
        } catch (const Error&) {
        }
        try {
            return opened(plain, path, SQLITE_OPEN_READONLY, progress, look);
        } catch (const Error&) {
            if (hasLog(path)) throw;
        }
        return opened(immutableAddress(plain), path, SQLITE_OPEN_READONLY, progress, look);
    } catch (const Error& error) {
        throwNotOpened(error);
    }
}

void makeSqliteFile(const std::string& place, const std::string& shown, const std::function<void(Connection&)>& define,
                    const Progress& progress)
{
    const auto connection = opened(
        place, shown, SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE, progress,
        ("PRAGMA application_id = " + std::to_string(sqliteApplicationId) + "; PRAGMA journal_mode = WAL").c_str());
    define(*connection);
    connection->run("PRAGMA wal_checkpoint(TRUNCATE)");
}

}  // namespace lathelier::archive::sql
