// A program that is killed while it writes leaves whole calls and nothing of the one it was in.
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <random>
#include <thread>

#include "tests/engine/archive/archive_fixture.h"

namespace lathelier::archive {
namespace {

constexpr int partsOfOneCall = 5;
constexpr int allParts = 2000;

/// A program of its own that adds call after call until it is killed.
pid_t startWriter(const std::string& location)
{
    const pid_t child = ::fork();
    if (child != 0) return child;
    try {
        Archive archive = Archive::open(location, Access::Write);
        for (int from = 0; from < allParts; from += partsOfOneCall)
            archive.add(partEvaluations(from, from + partsOfOneCall), inspector, partRecipes());
    } catch (...) {
        ::_exit(1);
    }
    ::_exit(0);
}

class Killed : public EitherArchive {};

TEST_P(Killed, a_writer_leaves_whole_calls)
{
    const std::string location = archiveOf(0);
    std::mt19937 random(7);
    std::uniform_int_distribution<int> pause_ms(5, 120);
    std::size_t rows = 0;
    for (int round = 0; round < 10; ++round) {
        const pid_t writer = startWriter(location);
        std::this_thread::sleep_for(std::chrono::milliseconds(pause_ms(random)));
        ::kill(writer, SIGKILL);
        int status = 0;
        ASSERT_EQ(::waitpid(writer, &status, 0), writer);
        EXPECT_TRUE(WIFSIGNALED(status) || WEXITSTATUS(status) == 0);
        Archive archive = Archive::open(location, Access::Write);
        const Verification made = archive.verify();
        EXPECT_FALSE(made.broken);
        const std::size_t now = archive.list({.most = 0}).size();
        EXPECT_EQ(now % partsOfOneCall, 0u);
        EXPECT_GE(now, rows);
        rows = now;
    }
    EXPECT_GT(rows, 0u);
    Archive archive = Archive::open(location, Access::Write);
    const int more = static_cast<int>(rows) + 10;
    const Added added = archive.add(partEvaluations(0, more), inspector);
    EXPECT_EQ(added.already_there, static_cast<std::int64_t>(rows));
    EXPECT_EQ(added.added, 10);
    EXPECT_FALSE(archive.verify().broken);
}

INSTANTIATE_TEST_SUITE_P(Databases, Killed, ::testing::Values(Backend::Sqlite, Backend::Postgres), backendName);

}  // namespace
}  // namespace lathelier::archive
