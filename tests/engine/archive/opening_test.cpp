// What is opened and what is refused: places, kinds of file, roles, and a server that is not there.
#include <chrono>
#include <fstream>
#include <thread>

#include "engine/archive/sql/file_system.h"
#include "engine/archive/sql/location.h"
#include "engine/archive/sql/random_uuid.h"
#include "engine/core/texts.h"
#include "tests/engine/archive/archive_fixture.h"

namespace lathelier::archive {
namespace {

using sql::networkFileSystem;

TEST(Location, tells_a_database_from_a_file)
{
    for (const char* database : {"postgresql://host/name", "postgres://", "host=a dbname=b", "service=shop",
                                 "  dbname = x", "password=x host=y"})
        EXPECT_TRUE(isDatabase(database)) << database;
    for (const char* file : {"archive", "a/b=c", "/host=a", "./service=x", "shop.db", "x=y", ""})
        EXPECT_FALSE(isDatabase(file)) << file;
}

TEST(Location, password_is_found_in_every_spelling_and_never_shown)
{
    for (const char* location :
         {"postgresql://anna:secret@host/name", "postgres://anna:secret@host", "postgresql://host/name?password=secret",
          "postgresql://host/name?sslmode=require&password=secret", "postgresql://host/name?%70assword=secret",
          "postgresql://anna:se/secret@host/name", "postgresql://anna:s@secret@host/name", "host=a password=secret",
          "host=a password = 'a secret'", "password=secret host=a", "host=a sslpassword=secret",
          "postgresql://anna:secret@host/name?password=secret", "host=a password='it\\'s secret' dbname=b"}) {
        EXPECT_TRUE(sql::statesPassword(location)) << location;
        EXPECT_EQ(sql::withoutSecrets(location).find("secret"), std::string::npos) << sql::withoutSecrets(location);
        try {
            Archive::open(location, Access::Read);
            ADD_FAILURE() << location;
        } catch (const Error& error) {
            EXPECT_EQ(error.code(), errors::passwordInLocation);
            EXPECT_EQ(text(error).find("secret"), std::string::npos) << text(error);
            EXPECT_NE(text(error).find("~/.pgpass"), std::string::npos);
        }
    }
    for (const char* location : {"postgresql://anna@host:5432/name", "host=a user=password dbname='password=x'",
                                 "service=shop", "postgresql://[::1]:5432/name", "postgresql://host/a@b"})
        EXPECT_FALSE(sql::statesPassword(location)) << location;
}

TEST(Location, of_this_machine_is_told_from_the_network)
{
    for (const char* host : {"", "/run/postgresql", "@abstract", "localhost", "127.0.0.1", "127.8.0.1", "::1"})
        EXPECT_TRUE(sql::isThisMachine(host)) << host;
    for (const char* host : {"shop", "10.0.0.1", "127.example.org", "localhost.evil.org", "::2", "1127.0.0.1"})
        EXPECT_FALSE(sql::isThisMachine(host)) << host;
    EXPECT_EQ(codeOf([] { Archive::open("host=192.0.2.1 dbname=x sslmode=prefer", Access::Read); }), "tls_required");
    EXPECT_EQ(codeOf([] { Archive::open("postgresql://192.0.2.1/x?sslmode=disable", Access::Read); }), "tls_required");
    EXPECT_EQ(codeOf([] { Archive::open("host=/tmp,192.0.2.1 dbname=x sslmode=allow", Access::Read); }),
              "tls_required");
    EXPECT_EQ(codeOf([] { Archive::open("host=localhost hostaddr=192.0.2.1 sslmode=allow", Access::Read); }),
              "tls_required");
    EXPECT_EQ(codeOf([] { Archive::open("host=a nonsense", Access::Read); }), "location_unclear");
}

TEST(Location, over_the_network_needs_tls)
{
    EXPECT_EQ(sql::demandedTls("shop", "prefer", false), "verify-full");
    EXPECT_EQ(sql::demandedTls("shop", "require", true), "require");
    EXPECT_EQ(sql::demandedTls("shop", "verify-ca", true), "verify-ca");
    for (const char* mode : {"disable", "allow", "prefer"}) EXPECT_FALSE(sql::demandedTls("shop", mode, true)) << mode;
    EXPECT_EQ(sql::demandedTls("localhost", "disable", true), "");
    EXPECT_EQ(sql::demandedTls("", "prefer", false), "");
    EXPECT_EQ(sql::demandedTls("/run/postgresql,127.0.0.1", "prefer", false), "");
    EXPECT_EQ(sql::demandedTls("/run/postgresql,shop", "prefer", false), "verify-full");
}

TEST(FileSystem, of_a_network_is_known_by_its_magic)
{
    EXPECT_EQ(networkFileSystem(0x6969, "nfs4"), "NFS");
    EXPECT_EQ(networkFileSystem(0xFF534D42, "cifs"), "CIFS");
    EXPECT_EQ(networkFileSystem(static_cast<std::int32_t>(0xFE534D42), "smb3"), "SMB2");
    EXPECT_EQ(networkFileSystem(0x517B, "smbfs"), "SMB");
    EXPECT_EQ(networkFileSystem(0x65735546, "fuse.sshfs"), "fuse.sshfs");
    EXPECT_EQ(networkFileSystem(0x65735546, ""), "FUSE");
    EXPECT_FALSE(networkFileSystem(0x65735546, "fuseblk"));
    EXPECT_FALSE(networkFileSystem(0xEF53, "ext4"));
    EXPECT_FALSE(networkFileSystem(0x01021994, "tmpfs"));
    const ScratchFolder scratch;
    EXPECT_FALSE(sql::networkFileSystemOf(scratch / "not/yet/there"));
}

TEST(Opening, a_file_of_another_kind_is_refused_and_left_as_it_is)
{
    const ScratchFolder scratch;
    const std::string foreign = scratch / "foreign.db";
    {
        Archive::open(foreign, Access::Create);
        const auto raw = rawConnection(foreign);
        raw->run("PRAGMA application_id = 7");
        raw->run("PRAGMA journal_mode = DELETE");
    }
    std::ofstream(scratch / "text") << "No database, and much longer than the head of one would be: "
                                    << std::string(200, 'x');
    std::ofstream(scratch / "empty");
    for (const char* name : {"foreign.db", "text", "empty"}) {
        const std::string path = scratch / name;
        const std::string before = io::fileSha256(path);
        for (const Access access : {Access::Read, Access::Write, Access::Create})
            EXPECT_EQ(codeOf([&] { Archive::open(path, access); }), "no_archive") << path;
        EXPECT_EQ(io::fileSha256(path), before);
    }
    EXPECT_EQ(codeOf([&] { Archive::open(scratch / "missing", Access::Write); }), "file_not_found");
    EXPECT_EQ(codeOf([&] { Archive::open(scratch / "no/folder", Access::Create); }), "archive_not_written");
    std::size_t files = 0;
    for (const auto& entry : std::filesystem::directory_iterator(scratch.path()))
        if (entry.exists()) ++files;
    EXPECT_EQ(files, 3u);
}

TEST(Opening, a_damaged_file_is_told)
{
    const ScratchFolder scratch;
    const std::string path = scratch / "archive";
    Archive::open(path, Access::Create).add(partEvaluations(0, 200), {});
    std::filesystem::resize_file(path, std::filesystem::file_size(path) / 2 / 4096 * 4096);
    const std::string code = codeOf([&] { Archive::open(path, Access::Read).verify(); });
    EXPECT_TRUE(code == "archive_not_opened" || code == "archive_not_read") << code;
}

TEST(Opening, a_server_that_is_not_there_is_told_without_secrets)
{
    const ScratchFolder scratch;
    try {
        Archive::open("host=" + scratch.string() + " dbname=x", Access::Read);
        FAIL() << "it was opened";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), errors::archiveNotOpened);
        EXPECT_NE(text(error).find("No such file"), std::string::npos) << text(error);
    }
}

TEST(Opening, a_database_without_an_archive_or_role_is_told)
{
    PostgresServer& server = PostgresServer::instance();
    const std::string location = server.newDatabase();
    EXPECT_EQ(codeOf([&] { Archive::open(location, Access::Read); }), "no_archive");
    EXPECT_EQ(codeOf([&] { Archive::open(location, Access::Write); }), "no_archive");
    try {
        Archive::open(PostgresServer::forRole(location, "nobody_here"), Access::Read);
        FAIL() << "it was opened";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), errors::archiveNotOpened);
        EXPECT_NE(text(error).find("nobody_here"), std::string::npos) << text(error);
    }
    EXPECT_EQ(codeOf([&] { Archive::open(server.withRole(location, "stranger", ""), Access::Create); }),
              "archive_not_written");
    EXPECT_EQ(codeOf([&] { Archive::open(location, Access::Read); }), "no_archive");
}

TEST(Roles, have_the_rights_of_their_groups)
{
    PostgresServer& server = PostgresServer::instance();
    const std::string location = server.newDatabase();
    Archive::open(location, Access::Create).add(partEvaluations(0, 2), inspector, partRecipes());
    const std::string reader = server.withRole(location, "anna_reads", "lathelier_reader");
    const std::string writer = server.withRole(location, "jan_writes", "lathelier_writer");
    const std::string stranger = server.withRole(location, "stranger", "");
    EXPECT_EQ(Archive::open(reader, Access::Read).list().size(), 2u);
    EXPECT_FALSE(Archive::open(reader, Access::Read).verify().broken);
    Archive asReader = Archive::open(reader, Access::Write);
    try {
        asReader.add(partEvaluations(2, 3), {});
        ADD_FAILURE() << "a reader added";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), errors::archiveNotWritten);
        EXPECT_STREQ(std::get<Text>(*find(error.values(), "reason")).english, "this role may not do that");
    }
    for (const std::string& role : {reader, writer})
        for (const char* statement :
             {"UPDATE evaluation SET person = 'x'", "DELETE FROM evaluation", "TRUNCATE evaluation CASCADE",
              "DROP TABLE evaluation", "ALTER TABLE evaluation DISABLE TRIGGER ALL", "UPDATE measured SET value = 1"})
            EXPECT_EQ(codeOf([&] { rawConnection(role)->run(statement); }), "archive_not_read") << statement;
    EXPECT_EQ(codeOf([&] { rawConnection(reader)->run("INSERT INTO recipe VALUES ('a', 'b')"); }), "archive_not_read");
    EXPECT_EQ(codeOf([&] { Archive::open(stranger, Access::Read); }), "archive_not_opened");
    EXPECT_EQ(Archive::open(writer, Access::Write).add(partEvaluations(2, 4), {}).added, 2);
    const Verification made = Archive::open(reader, Access::Read).verify();
    ASSERT_EQ(made.chains.size(), 2u);
    EXPECT_EQ(made.chains[0].writer, "jan_writes");
    EXPECT_EQ(made.chains[1].writer, "owner");
}

TEST(Roles, two_of_them_at_once_have_a_chain_each_and_no_evaluation_twice)
{
    PostgresServer& server = PostgresServer::instance();
    const std::string location = server.newDatabase();
    Archive::open(location, Access::Create);
    const std::string other = server.withRole(location, "jan_writes", "lathelier_writer");
    const auto write = [](const std::string& at) {
        Archive archive = Archive::open(at, Access::Write);
        for (int number = 0; number < 30; ++number) archive.add(partEvaluations(number, number + 1), {});
    };
    std::thread first(write, location), second(write, other);
    first.join();
    second.join();
    const Archive archive = Archive::open(location, Access::Read);
    EXPECT_EQ(archive.list().size(), 30u);
    EXPECT_FALSE(archive.verify().broken);
}

TEST(Roles, that_cannot_be_made_are_told)
{
    PostgresServer& server = PostgresServer::instance();
    const std::string location = server.newDatabase();
    const auto owner = rawConnection(location);
    const std::string other = server.withRole(location, "maker", "");
    owner->run("GRANT CREATE ON DATABASE " + location.substr(location.rfind('=') + 1) + " TO maker");
    for (const char* role : {"lathelier_reader", "lathelier_writer", "lathelier_admin"})
        if (owner->word("SELECT rolname FROM pg_roles WHERE rolname = $1", {std::string(role)}))
            owner->run(std::string("ALTER ROLE ") + role + " RENAME TO " + role + "_away");
    Archive archive = Archive::open(other, Access::Create);
    for (const char* role : {"lathelier_reader", "lathelier_writer", "lathelier_admin"})
        if (owner->word("SELECT rolname FROM pg_roles WHERE rolname = $1", {std::string(role) + "_away"}))
            owner->run(std::string("ALTER ROLE ") + role + "_away RENAME TO " + role);
    EXPECT_TRUE(contains(archive.notes(), notes::archiveRolesMissing));
    EXPECT_EQ(archive.add(partEvaluations(0, 1), {}).added, 1);
}

TEST(Connection, that_was_lost_is_told)
{
    PostgresServer& server = PostgresServer::instance();
    const std::string location = server.newDatabase();
    Archive archive = Archive::open(location, Access::Create);
    rawConnection(location)->run(
        "SELECT pg_terminate_backend(pid) FROM pg_stat_activity WHERE datname = current_database() AND pid <> "
        "pg_backend_pid()");
    try {
        archive.add(partEvaluations(0, 1), {});
        FAIL() << "it was added";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), errors::archiveNotWritten);
        EXPECT_STREQ(std::get<Text>(*find(error.values(), "reason")).english, "the connection to the server was lost");
    }
    EXPECT_EQ(Archive::open(location, Access::Write).add(partEvaluations(0, 1), {}).added, 1);
}

TEST_P(EitherArchive, waiting_for_another_program_can_be_stopped)
{
    const std::string location = archiveOf(0);
    Archive archive = Archive::open(location, Access::Write);
    const auto holder = rawConnection(location);
    const sql::Transaction holding(*holder, sql::TransactionKind::Write);
    if (isDatabase(location)) holder->run("LOCK TABLE evaluation");
    std::stop_source stop;
    std::thread later([&stop] {
        std::this_thread::sleep_for(std::chrono::milliseconds(100));
        stop.request_stop();
    });
    EXPECT_THROW(archive.add(partEvaluations(0, 1), {}, {}, Progress(stop.get_token(), {})), Cancelled);
    later.join();
}

TEST(Uuid, is_of_version_4_and_never_the_same)
{
    const std::string one = sql::randomUuid();
    EXPECT_EQ(one.size(), 36u);
    EXPECT_EQ(one[14], '4');
    EXPECT_NE(one, sql::randomUuid());
}

}  // namespace
}  // namespace lathelier::archive
