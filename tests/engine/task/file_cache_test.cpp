#include "engine/task/file_cache.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <fstream>
#include <thread>

#include "engine/io/io_codes.h"
#include "engine/task/stores.h"
#include "tests/scratch_folder.h"

namespace lathelier {

/// Content of a file, read slowly so that requests meet.
class SlowTexts : public FileCache<std::string> {
public:
    SlowTexts() : FileCache(20) {}

    mutable std::atomic<int> readings{0};
    std::atomic<bool> is_refusing{false};

protected:
    std::string read(const project::Source& source, io::InputFiles& inputs, const Progress& progress) const override
    {
        ++readings;
        std::string text(inputs.open(source.path, progress));
        std::this_thread::sleep_for(std::chrono::milliseconds(50));
        if (is_refusing) throw Error(errors::fileEmpty, {});
        return text;
    }
};

namespace {

project::Source fileWith(const ScratchFolder& folder, const std::string& text)
{
    project::Source source;
    source.path = (folder / "file.txt").string();
    std::ofstream(source.path) << text;
    return source;
}

TEST(FileCache, requests_side_by_side_read_a_file_once)
{
    const ScratchFolder folder;
    const project::Source source = fileWith(folder, "one");
    SlowTexts texts;
    std::vector<SlowTexts::Pointer> found(4);
    {
        std::vector<std::jthread> threads;
        threads.reserve(found.size());
        for (SlowTexts::Pointer& place : found) threads.emplace_back([&] { place = texts.load(source); });
    }
    EXPECT_EQ(texts.readings, 1);
    for (const SlowTexts::Pointer& one : found) EXPECT_EQ(one, found.front());
}

TEST(FileCache, a_refused_reading_is_tried_by_the_next)
{
    const ScratchFolder folder;
    const project::Source source = fileWith(folder, "one");
    SlowTexts texts;
    texts.is_refusing = true;
    EXPECT_THROW(texts.load(source), Error);
    texts.is_refusing = false;
    EXPECT_EQ(texts.load(source)->file, "one");
    EXPECT_EQ(texts.readings, 2);
}

TEST(FileCache, a_forgotten_file_is_read_again_with_its_new_content)
{
    const ScratchFolder folder;
    const project::Source source = fileWith(folder, "one");
    Stores stores;
    const auto texts = stores.of<SlowTexts>();
    EXPECT_EQ(texts->load(source)->file, "one");
    fileWith(folder, "two");
    EXPECT_EQ(texts->load(source)->file, "one");
    stores.forget(source.path);
    EXPECT_TRUE(stores.seen().empty());
    EXPECT_EQ(texts->known(source), nullptr);
    EXPECT_EQ(texts->load(source)->file, "two");
}

}  // namespace
}  // namespace lathelier
