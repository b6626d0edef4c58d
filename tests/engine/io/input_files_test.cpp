#include "engine/io/input_files.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>

#include "tests/scratch_folder.h"

namespace lathelier {
namespace {

class InputFilesTest : public ::testing::TestWithParam<bool> {};

TEST_P(InputFilesTest, DigestsAreOfTheBytesThatWereRead)
{
    const ScratchFolder folder;
    const std::string path = (folder / "input").string();
    const std::string first(3'000'000, 'a');
    io::writeFile(path, first);
    io::InputFiles inputs(GetParam());
    EXPECT_EQ(inputs.open(path), first);
    io::writeFile(path, "another content");
    EXPECT_EQ(inputs.open(path), "another content");
    inputs.drop();
    inputs.drop();  // nothing is left to give back
    const std::vector<InputFile> files = inputs.list();
    ASSERT_EQ(files.size(), 2u);
    EXPECT_EQ(files[0].bytes, 3'000'000);
    EXPECT_EQ(files[0].sha256, io::sha256(first));
    EXPECT_EQ(files[1].sha256, io::sha256("another content"));
    EXPECT_EQ(files[1].sha256, io::fileSha256(path));
}

INSTANTIATE_TEST_SUITE_P(BesideOrLater, InputFilesTest, ::testing::Bool());

TEST(InputFiles, AGivenTextStandsForAFileThatIsNotThere)
{
    io::InputFiles files;
    files.give("/nowhere/job.json", "{}");
    EXPECT_EQ(files.open("/nowhere/job.json"), "{}");
    files.drop();
    const std::vector<InputFile> list = files.list();
    ASSERT_EQ(list.size(), 1u);
    EXPECT_EQ(list[0].path, "/nowhere/job.json");
    EXPECT_EQ(list[0].bytes, 2);
    EXPECT_EQ(list[0].sha256, io::sha256("{}"));
}

}  // namespace
}  // namespace lathelier
