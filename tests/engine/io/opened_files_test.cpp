// Files that were read are known by any name, and the check before writing keeps them.
#include <gtest/gtest.h>

#include <filesystem>
#include <stdexcept>

#include "engine/io/file.h"
#include "engine/io/opened_files.h"
#include "tests/scratch_folder.h"

namespace lathelier::io {
namespace {

TEST(OpenedFiles, AreKnownByAnyName)
{
    const ScratchFolder folder;
    const std::string one = folder / "one", other = folder / "other", link = folder / "link";
    writeFile(one, "1");
    writeFile(other, "2");
    std::filesystem::create_symlink(one, link);
    EXPECT_FALSE(openedAs(one));
    EXPECT_EQ(FileBytes(one).view(), "1");
    EXPECT_EQ(openedAs(one), one);
    EXPECT_EQ(openedAs(link), one);
    EXPECT_FALSE(openedAs(other));
    EXPECT_FALSE(openedAs(folder / "none"));
    EXPECT_EQ(fileHead(other, 1), "2");
    EXPECT_EQ(openedAs(other), other);
}

TEST(OpenedFiles, TheCheckComesBeforeAnythingIsWritten)
{
    const ScratchFolder folder;
    const std::string path = folder / "kept";
    writeFile(path, "as it was");
    setWriteCheck([] { throw std::runtime_error("refused"); });
    EXPECT_THROW(writeFile(path, "new"), std::runtime_error);
    setWriteCheck({});
    EXPECT_EQ(FileBytes(path).view(), "as it was");
    writeFile(path, "new");
    EXPECT_EQ(FileBytes(path).view(), "new");
}

}  // namespace
}  // namespace lathelier::io
