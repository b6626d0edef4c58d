// A program that is killed while it writes leaves whole calls and nothing of the one it was in.
#include <chrono>
#include <random>

#include "tests/engine/archive/archive_fixture.h"
#include "tests/killed_process.h"

namespace lathelier::archive {
namespace {

constexpr int partsOfOneCall = 5;
constexpr int allParts = 2000;

/// Adds call after call.
void writeAll(const std::string& location)
{
    Archive archive = Archive::open(location, Access::Write);
    for (int from = 0; from < allParts; from += partsOfOneCall)
        archive.add(partEvaluations(from, from + partsOfOneCall), inspector, partRecipes());
}

class Killed : public EitherArchive {};

TEST_P(Killed, a_writer_leaves_whole_calls)
{
    const std::string location = archiveOf(0);
    std::mt19937 random(7);
    std::uniform_int_distribution<int> pause_ms(5, 120);
    std::size_t rows = 0;
    int killed = 0;
    for (int round = 0; round < 10; ++round) {
        killed += workAndKill([&] { writeAll(location); }, std::chrono::milliseconds(pause_ms(random)));
        Archive archive = Archive::open(location, Access::Write);
        const Verification made = archive.verify();
        EXPECT_FALSE(made.broken);
        const std::size_t now = archive.list({.most = 0}).size();
        EXPECT_EQ(now % partsOfOneCall, 0u);
        EXPECT_GE(now, rows);
        rows = now;
    }
    EXPECT_GT(rows, 0u);
    EXPECT_GT(killed, 0);
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
