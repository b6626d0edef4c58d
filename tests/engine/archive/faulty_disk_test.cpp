// A disk that fails at any write leaves the archive as it was before the call or as it is after it.
#include "tests/engine/archive/faulty_disk.h"

#include <sqlite3.h>

#include "tests/engine/archive/archive_fixture.h"

namespace lathelier::archive {
namespace {

class Faulty : public ::testing::TestWithParam<bool> {};

TEST_P(Faulty, a_call_is_done_or_not_wherever_the_disk_fails)
{
    const ScratchFolder scratch;
    FaultyDisk disk;
    int n = 1, refused = 0;
    for (bool has_failed = true; has_failed; ++n) {
        const std::string location = scratch / ("archive_" + std::to_string(n));
        Archive::open(location, Access::Create).add(partEvaluations(0, 3), inspector, partRecipes());
        std::string code;
        {
            disk.failAt(n, n % 2 == 0 ? SQLITE_IOERR_WRITE : SQLITE_IOERR_FSYNC, GetParam());
            code = codeOf([&] {
                Archive archive = Archive::open(location, Access::Write);
                archive.add(partEvaluations(3, 9), inspector);
            });
            has_failed = disk.hasFailed();
            disk.failAt(0, SQLITE_OK, false);
        }
        SCOPED_TRACE(std::to_string(n) + " " + code);
        Archive archive = Archive::open(location, Access::Write);
        const std::size_t rows = archive.list().size();
        EXPECT_TRUE(rows == 3 || rows == 9) << rows;
        if (code.empty()) {
            EXPECT_EQ(rows, 9u);
        } else {
            EXPECT_TRUE(code == "archive_not_written" || code == "archive_not_opened");
            ++refused;
        }
        EXPECT_FALSE(archive.verify().broken);
        EXPECT_EQ(archive.add(partEvaluations(0, 9), inspector).added, static_cast<std::int64_t>(9 - rows));
        EXPECT_FALSE(archive.verify().broken);
    }
    EXPECT_GT(n, 5);
    EXPECT_GT(refused, 2);
}

INSTANTIATE_TEST_SUITE_P(Disks, Faulty, ::testing::Bool(),
                         [](const auto& of) { return of.param ? "ForGood" : "Once"; });

TEST(FullDisk, is_told_and_nothing_is_added)
{
    const ScratchFolder scratch;
    const std::string location = scratch / "archive";
    Archive::open(location, Access::Create).add(partEvaluations(0, 3), inspector);
    FaultyDisk disk;
    {
        Archive archive = Archive::open(location, Access::Write);
        disk.failAt(1, SQLITE_FULL, true);
        try {
            archive.add(partEvaluations(3, 9), inspector);
            ADD_FAILURE() << "it was taken";
        } catch (const Error& error) {
            EXPECT_EQ(error.code(), errors::archiveNotWritten);
            EXPECT_STREQ(std::get<Text>(*find(error.values(), "reason")).english, "the disk is full");
        }
        disk.failAt(0, SQLITE_OK, false);
        EXPECT_EQ(archive.list().size(), 3u);
        EXPECT_EQ(archive.add(partEvaluations(3, 9), inspector).added, 6);
    }
    EXPECT_FALSE(Archive::open(location, Access::Read).verify().broken);
}

}  // namespace
}  // namespace lathelier::archive
