#include "engine/io/file.h"
#include "engine/core/core_codes.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <thread>

#include "engine/core/error.h"
#include "engine/io/io_codes.h"

namespace lathelier {
namespace {

namespace fs = std::filesystem;

class FileTest : public testing::Test {
protected:
    void SetUp() override
    {
        folder_ = fs::temp_directory_path() / ("lathelier_file_test_" + std::to_string(::getpid()));
        fs::create_directories(folder_);
    }
    void TearDown() override { fs::remove_all(folder_); }

    std::string path(const std::string& name) const { return (folder_ / name).string(); }
    std::size_t filesInFolder() const
    {
        return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder_), {}));
    }
    static std::string read(const std::string& name) { return std::string(FileBytes(name).view()); }

    fs::path folder_;
};

template <class F>
Error errorOf(F&& f)
{
    try {
        f();
    } catch (const Error& error) {
        return error;
    }
    ADD_FAILURE() << "no error thrown";
    return Error(errors::unknownOption, {});
}

std::string wordOf(const Error& error, const char* name)
{
    const Value* value = find(error.values(), name);
    if (!value) return {};
    if (const Text* text = std::get_if<Text>(value)) return text->english;
    return std::get<std::string>(*value);
}

TEST_F(FileTest, readsBackWhatWasWritten)
{
    const std::string content = std::string("line\n\0\xff end", 11);
    writeFile(path("a"), content);
    EXPECT_EQ(read(path("a")), content);
    writeFile(path("a"), [](const auto& append) {
        for (int i = 0; i < 200000; ++i) append("0123456789");
    });
    EXPECT_EQ(read(path("a")).size(), 2000000u);
    EXPECT_EQ(filesInFolder(), 1u);
}

TEST_F(FileTest, anEmptyFileIsFine)
{
    writeFile(path("empty"), "");
    EXPECT_EQ(read(path("empty")), "");
}

TEST_F(FileTest, saysWhyAFileCannotBeRead)
{
    const Error missing = errorOf([&] { FileBytes file(path("missing")); });
    EXPECT_EQ(missing.code(), errors::fileNotFound);
    EXPECT_EQ(wordOf(missing, "path"), path("missing"));
    EXPECT_EQ(errorOf([&] { FileBytes file(""); }).code(), errors::fileNotFound);
    const Error folder = errorOf([&] { FileBytes file(folder_.string()); });
    EXPECT_EQ(folder.code(), errors::notAFile);
    EXPECT_EQ(wordOf(folder, "found"), "a folder");
    EXPECT_EQ(wordOf(errorOf([&] { FileBytes file("/dev/zero"); }), "found"), "a device");
    writeFile(path("secret"), "x");
    ::chmod(path("secret").c_str(), 0);
    if (::geteuid() != 0) {
        EXPECT_EQ(errorOf([&] { FileBytes file(path("secret")); }).code(), errors::fileNotReadable);
    }
}

TEST_F(FileTest, readsAPipeToItsEnd)
{
    ASSERT_EQ(::mkfifo(path("pipe").c_str(), 0600), 0);
    std::thread writer([name = path("pipe")] {
        std::ofstream out(name);
        for (int i = 0; i < 300000; ++i) out << "0123456789";
    });
    EXPECT_EQ(read(path("pipe")).size(), 3000000u);
    writer.join();
}

TEST_F(FileTest, aPipeWithoutAWriterCanBeCancelled)
{
    ASSERT_EQ(::mkfifo(path("pipe").c_str(), 0600), 0);
    std::stop_source stop;
    stop.request_stop();
    const Progress progress(stop.get_token(), {});
    EXPECT_THROW(FileBytes(path("pipe"), progress), Cancelled);
}

TEST_F(FileTest, aFailingWriteLeavesTheOldFileAndNothingElse)
{
    writeFile(path("a"), "old");
    EXPECT_THROW(writeFile(path("a"),
                           [](const auto& append) {
                               append(std::string(1 << 20, 'x'));
                               throw Cancelled();
                           }),
                 Cancelled);
    EXPECT_EQ(read(path("a")), "old");
    EXPECT_EQ(filesInFolder(), 1u);
}

TEST_F(FileTest, aDiskThatTakesNoMoreLeavesNothing)
{
    // A limit on the size of files acts like a full disk, without needing one.
    ::signal(SIGXFSZ, SIG_IGN);
    rlimit old{};
    ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &old), 0);
    rlimit small = old;
    small.rlim_cur = 100000;
    ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &small), 0);
    const Error error = errorOf([&] { writeFile(path("big"), std::string(1 << 20, 'x')); });
    ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &old), 0);
    EXPECT_EQ(error.code(), errors::fileNotWritable);
    EXPECT_EQ(wordOf(error, "reason"), "the file would be too large");
    EXPECT_EQ(filesInFolder(), 0u);
}

TEST_F(FileTest, writesThroughLinksAndDevicesAndKeepsPermissions)
{
    writeFile(path("target"), "old");
    ::chmod(path("target").c_str(), 0640);
    fs::create_symlink(path("target"), path("link"));
    writeFile(path("link"), "new");
    EXPECT_TRUE(fs::is_symlink(path("link")));
    EXPECT_EQ(read(path("target")), "new");
    EXPECT_EQ(fs::status(path("target")).permissions(), fs::perms(0640));
    writeFile("/dev/null", "gone");
    EXPECT_TRUE(fs::is_character_file("/dev/null"));
    const Error full = errorOf([] { writeFile("/dev/full", "x"); });
    EXPECT_EQ(full.code(), errors::fileNotWritable);
    EXPECT_EQ(wordOf(full, "reason"), "the disk is full");
}

TEST_F(FileTest, saysWhyAFileCannotBeWritten)
{
    EXPECT_EQ(wordOf(errorOf([&] { writeFile(folder_.string(), "x"); }), "reason"), "it is a folder");
    EXPECT_EQ(wordOf(errorOf([&] { writeFile(path("no/such/folder"), "x"); }), "reason"), "the folder does not exist");
    EXPECT_EQ(wordOf(errorOf([&] { writeFile(path(std::string(300, 'n')), "x"); }), "reason"), "the name is too long");
    EXPECT_EQ(filesInFolder(), 0u);
}

TEST(Sha256, knownAnswers)  // FIPS 180-4 examples
{
    EXPECT_EQ(sha256(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
    EXPECT_EQ(sha256("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
}

}  // namespace
}  // namespace lathelier
