#include "engine/archive/archive.h"

#include "engine/archive/archive_codes.h"
#include "engine/archive/archive_rows.h"
#include "engine/archive/archive_state.h"
#include "engine/archive/schema.h"
#include "engine/archive/sql/location.h"
#include "engine/archive/sql/postgres_connection.h"
#include "engine/archive/sql/random_uuid.h"
#include "engine/archive/sql/sqlite_connection.h"

namespace lathelier::archive {
namespace {

using sql::Connection;
using sql::Transaction;
using sql::TransactionKind;

/// The values of an error about the same matter, with the reason of this one.
Values withReason(const Error& error, Values values)
{
    if (const Value* reason = find(error.values(), "reason")) set(values, "reason", *reason);
    return values;
}

void makeFile(const std::string& path, const Progress& progress)
{
    sql::createSqlite(
        path,
        [](Connection& connection) {
            Transaction transaction(connection, TransactionKind::Write);
            defineSchema(connection);
            connection.change("INSERT INTO archive_property (name, value) VALUES ('writer', $1)", {sql::randomUuid()});
            transaction.commit();
        },
        progress);
}

void makeTables(Connection& connection, Notes& notes)
{
    Transaction transaction(connection, TransactionKind::Write);
    lockForWriting(connection);
    if (versionOf(connection)) throw Error(errors::archiveExists, {{"location", connection.location()}});
    connection.run(std::string("CREATE SCHEMA IF NOT EXISTS ") + sql::postgresSchema);
    defineSchema(connection);
    if (!grantRights(connection))
        notes.push_back(
            {notes::archiveRolesMissing, {{"location", connection.location()}, {"roles", std::string(rolesOfGroups)}}});
    transaction.commit();
}

/// An older version can be read as it is: the steps since have added tables only.
void bringUpToDate(Connection& connection, Access access)
{
    const auto version = versionOf(connection);
    if (!version || *version < 1)
        throw Error(errors::noArchive, {{"location", connection.location()},
                                        {"found", LT_TEXT("Engine", "a database without the tables of an archive")}});
    const Values values{
        {"location", connection.location()}, {"found", *version}, {"expected", std::int64_t{schemaVersion}}};
    if (*version > schemaVersion) throw Error(errors::archiveNewer, values);
    if (*version == schemaVersion || access == Access::Read) return;
    try {
        Transaction transaction(connection, TransactionKind::Write);
        lockForWriting(connection);
        const std::int64_t now = versionOf(connection).value_or(0);  // another program may have been faster
        if (now < schemaVersion) migrateSchema(connection, now);
        if (connection.dialect() == sql::Dialect::Postgres) grantRights(connection);
        transaction.commit();
    } catch (const Error& error) {
        throw Error(errors::archiveOlder, withReason(error, values));
    }
}

std::string writerOf(Connection& connection)
{
    const bool is_file = connection.dialect() == sql::Dialect::Sqlite;
    return connection
        .word(is_file ? "SELECT value FROM archive_property WHERE name = 'writer'" : "SELECT session_user::text")
        .value_or("");
}

void checkTails(Connection& connection, Access access, Notes& notes)
{
    const auto broken = brokenTail(connection);
    if (!broken) return;
    const Values values = valuesOf(*broken, connection.location());
    if (access != Access::Read) throw Error(errors::chainBroken, values);
    notes.push_back({notes::chainBroken, values});
}

std::unique_ptr<Connection> connectionTo(const std::string& location, Access access, Notes& notes,
                                         const Progress& progress)
{
    const bool is_read_only = access == Access::Read;
    if (!isDatabase(location)) {
        if (access == Access::Create) makeFile(location, progress);
        return sql::openSqlite(location, is_read_only, progress);
    }
    auto connection = sql::openPostgres(location, is_read_only, progress);
    if (access == Access::Create) makeTables(*connection, notes);
    return connection;
}

}  // namespace

Values valuesOf(const BrokenRow& broken, const std::string& location)
{
    return {{"location", location},
            {"writer", broken.writer},
            {"sequence", broken.sequence},
            {"uuid", broken.uuid},
            {"fault", name(broken.fault)}};
}

std::int64_t Verification::checked() const
{
    std::int64_t sum = 0;
    for (const CheckedChain& chain : chains) sum += chain.checked;
    return sum;
}

bool isDatabase(const std::string& location)
{
    return sql::namesDatabase(location);
}

Archive::Archive(std::unique_ptr<State> state) : state_(std::move(state)) {}
Archive::~Archive() = default;
Archive::Archive(Archive&&) noexcept = default;
Archive& Archive::operator=(Archive&&) noexcept = default;

Archive Archive::open(const std::string& location, Access access, const Progress& progress)
{
    auto state = std::make_unique<State>();
    state->connection = connectionTo(location, access, state->notes, progress);
    Connection& connection = *state->connection;
    state->location = connection.location();
    try {
        bringUpToDate(connection, access);
        Transaction transaction(connection, TransactionKind::Read);
        state->writer = writerOf(connection);
        checkTails(connection, access, state->notes);
        transaction.commit();
    } catch (const Error& error) {
        if (!(error.code() == errors::archiveNotRead)) throw;
        throw Error(errors::archiveNotOpened, withReason(error, {{"location", state->location}}));
    }
    connection.watch({});
    return Archive(std::move(state));
}

const std::string& Archive::location() const
{
    return state_->location;
}

const Notes& Archive::notes() const
{
    return state_->notes;
}

sql::Connection& Archive::connection()
{
    return *state_->connection;
}

}  // namespace lathelier::archive
