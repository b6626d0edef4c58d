// Golden runs of the real program: one test for each line of tests/golden/*.txt (see golden_line.h).
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <iostream>

#include "tests/app/cli/expectations.h"
#include "tests/app/cli/golden_data.h"
#include "tests/app/cli/golden_line.h"
#include "tests/app/cli/run_program.h"
#include "tests/scratch_folder.h"

namespace lathelier::golden {
namespace {

namespace fs = std::filesystem;

/// Made in runAll(), removed at its end.
fs::path madeFolder;
const std::string keptData = LATHELIER_SOURCE_DIR "/tests/data";

class GoldenRun : public ::testing::Test {
public:
    explicit GoldenRun(Line line) : line_(std::move(line)) {}

    void TestBody() override
    {
        const fs::path out = madeFolder / "out";
        const auto fresh = [&out] {
            fs::remove_all(out);
            fs::create_directories(out);
        };
        fresh();
        const auto fill = [&](const std::string& text) {
            return replaced(replaced(replaced(text, "{data}", (madeFolder / "data").string()), "{out}", out.string()),
                            "{kept}", keptData);
        };
        for (std::string* text : {&line_.run.stdout_file, &line_.run.feed_pipe, &line_.run.feed_file})
            *text = fill(*text);
        for (std::string& word : line_.run.words) word = fill(word);
        for (const std::vector<std::string>& words : line_.before) {
            golden::Run before;
            for (const std::string& word : words) before.words.push_back(fill(word));
            const Outcome outcome = runProgram(LATHELIER_CLI, before);
            ASSERT_EQ(outcome.exit_code, 0) << line_.source << "\n" << words.front() << "\n" << outcome.standard_error;
        }
        const Outcome outcome = runProgram(LATHELIER_CLI, line_.run);
        ASSERT_EQ(outcome.exit_code, line_.exit_code) << line_.source << "\n" << outcome.standard_error;
        const Evidence evidence{line_, outcome, out.string(), (madeFolder / "data").string(),
                                [](const golden::Run& run) { return runProgram(LATHELIER_CLI, run); }};
        for (const std::string& expectation : line_.expectations) {
            std::string problem;
            try {
                problem = check(fill(expectation), evidence);
            } catch (const std::exception& failure) {
                problem = failure.what();
            }
            if (!problem.empty())
                ADD_FAILURE() << line_.source << "\nexpected: " << expectation << "\n"
                              << problem << "\n"
                              << outcome.standard_error;
        }
    }

private:
    Line line_;
};

/// "compare.txt:12" as a name GoogleTest can filter by.
std::string testName(const std::string& name)
{
    std::string result = name;
    std::replace_if(
        result.begin(), result.end(), [](char c) { return !std::isalnum(static_cast<unsigned char>(c)); }, '_');
    return result;
}

int runAll(int argc, char** argv)
{
    ::testing::InitGoogleTest(&argc, argv);
    std::vector<fs::path> files;
    for (const auto& entry : fs::directory_iterator(LATHELIER_SOURCE_DIR "/tests/golden"))
        if (entry.path().extension() == ".txt") files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    for (const fs::path& file : files)
        for (const Line& line : readLines(file.string()))
            ::testing::RegisterTest("Golden", testName(line.name).c_str(), nullptr, nullptr, file.c_str(), 1,
                                    [line]() -> ::testing::Test* { return new GoldenRun(line); });
    const ScratchFolder scratch;
    madeFolder = scratch.path();
    fs::create_directories(madeFolder / "data");
    makeData((madeFolder / "data").string());
    return RUN_ALL_TESTS();
}

}  // namespace
}  // namespace lathelier::golden

int main(int argc, char** argv)
{
    try {
        return lathelier::golden::runAll(argc, argv);
    } catch (const std::exception& failure) {
        std::cerr << failure.what() << "\n";
        return 1;
    }
}
