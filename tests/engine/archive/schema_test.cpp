// Archives of older versions are brought up to date with everything in them; newer ones are refused.
#include "engine/archive/schema.h"

#include "tests/engine/archive/archive_fixture.h"

namespace lathelier::archive {
namespace {

std::string sampleText(const std::string& name)
{
    return std::string(io::FileBytes(std::string(LATHELIER_SOURCE_DIR) + "/tests/data/archive/" + name).view());
}

class Migration : public EitherArchive {
protected:
    /// The archive of version 1 that was written when there was no other.
    std::string sample()
    {
        const std::string location = newLocation();
        if (isDatabase(location)) {
            rawConnection(location)->run(sampleText("schema_1_postgresql.sql"));
        } else {
            sql::createSqlite(location, [](sql::Connection& connection) { connection.run(sampleText("schema_1.sql")); },
                              {});
        }
        return location;
    }
};

TEST_P(Migration, brings_version_1_up_to_date_with_everything_in_it)
{
    const std::string location = sample();
    EXPECT_EQ(versionOf(*rawConnection(location)), 1);
    {
        const Archive old = Archive::open(location, Access::Read);  // as it is
        EXPECT_EQ(old.list().size(), 3u);
        EXPECT_FALSE(old.verify().broken);
    }
    EXPECT_EQ(versionOf(*rawConnection(location)), 1);
    Archive archive = Archive::open(location, Access::Write);
    EXPECT_EQ(versionOf(archive.connection()), schemaVersion);
    EXPECT_EQ(archive.connection().count("SELECT count(*) FROM job"), 0);
    const Verification made = archive.verify();
    EXPECT_FALSE(made.broken);
    EXPECT_EQ(made.checked(), 3);
    for (int number = 1; number <= 3; ++number)
        EXPECT_EQ(toJson(archive.show("00000000-0000-4000-8000-00000000000" + std::to_string(number)).evaluation),
                  toJson(partEvaluation(number)));
    EXPECT_EQ(archive.add(partEvaluations(1, 5), {}).added, 1);
    EXPECT_FALSE(archive.verify().broken);
}

TEST_P(Migration, newer_version_is_refused_by_name)
{
    const std::string location = archiveOf(1);
    rawConnection(location)->run(isDatabase(location)
                                     ? "UPDATE archive_property SET value = '99' WHERE name = 'schema_version'"
                                     : "PRAGMA user_version = 99");
    for (const Access access : {Access::Read, Access::Write}) {
        try {
            Archive::open(location, access);
            ADD_FAILURE() << "it was opened";
        } catch (const Error& error) {
            EXPECT_EQ(error.code(), errors::archiveNewer);
            EXPECT_EQ(std::get<std::int64_t>(*find(error.values(), "found")), 99);
        }
    }
}

TEST_P(Migration, by_a_role_that_may_not_is_told)
{
    const std::string location = sample();
    if (!isDatabase(location)) {
        rawConnection(location)->run("CREATE TABLE job (other)");
        EXPECT_EQ(codeOf([&] { Archive::open(location, Access::Write); }), "archive_older");
    } else {
        const std::string reader = PostgresServer::instance().withRole(location, "plain_reader", "");
        rawConnection(location)->run(
            "GRANT USAGE ON SCHEMA lathelier TO plain_reader;"
            "GRANT SELECT ON ALL TABLES IN SCHEMA lathelier TO plain_reader");
        EXPECT_EQ(codeOf([&] { Archive::open(reader, Access::Write); }), "archive_older");
        EXPECT_EQ(Archive::open(reader, Access::Read).list().size(), 3u);
    }
    EXPECT_EQ(versionOf(*rawConnection(location)), 1);
}

TEST_P(Migration, the_queue_of_a_batch_has_its_table)
{
    const std::string location = archiveOf(0);
    const auto raw = rawConnection(location);
    const std::string insert =
        "INSERT INTO job (job, recipe_sha256, input, key, state) VALUES "
        "('f81d4fae-7dec-41d0-a765-00a0c91e6bf6', 'r', '{}', $1, $2)";
    EXPECT_EQ(raw->change(insert, {std::string("a"), std::string("waiting")}), 1);
    EXPECT_EQ(codeOf([&] { raw->change(insert, {std::string("a"), std::string("waiting")}); }), "archive_not_read");
    EXPECT_EQ(codeOf([&] { raw->change(insert, {std::string("b"), std::string("odd")}); }), "archive_not_read");
    EXPECT_EQ(raw->change("UPDATE job SET state = 'running', worker = 'w', tries = tries + 1"), 1);
}

TEST(Queue, two_workers_of_a_database_take_different_jobs)
{
    const std::string location = PostgresServer::instance().newDatabase();
    Archive first = Archive::open(location, Access::Create), second = Archive::open(location, Access::Write);
    for (const char* key : {"a", "b"})
        first.connection().change(
            "INSERT INTO job (job, recipe_sha256, input, key, state) VALUES "
            "('f81d4fae-7dec-41d0-a765-00a0c91e6bf6', 'r', '{}', $1, 'waiting')",
            {std::string(key)});
    const std::string take = "SELECT key FROM job WHERE state = 'waiting' ORDER BY id FOR UPDATE SKIP LOCKED LIMIT 1";
    const sql::Transaction one(first.connection(), sql::TransactionKind::Write);
    const sql::Transaction other(second.connection(), sql::TransactionKind::Write);
    EXPECT_EQ(first.connection().word(take), "a");
    EXPECT_EQ(second.connection().word(take), "b");
}

INSTANTIATE_TEST_SUITE_P(Databases, Migration, ::testing::Values(Backend::Sqlite, Backend::Postgres), backendName);

}  // namespace
}  // namespace lathelier::archive
