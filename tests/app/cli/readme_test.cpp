// The examples of README.md run on the sample, every verb has one, and no verb is named that the program lacks.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include "tests/app/cli/run_program.h"
#include "tests/scratch_folder.h"

namespace lathelier::golden {
namespace {

/// The lines that begin with the program's name, in the blocks of code.
std::vector<std::string> readmeExamples()
{
    std::ifstream file(LATHELIER_SOURCE_DIR "/README.md");
    std::vector<std::string> examples;
    bool in_block = false;
    for (std::string line; std::getline(file, line);) {
        if (line.starts_with("```")) in_block = !in_block;
        if (in_block && line.starts_with("lathelier-cli ")) examples.push_back(line);
    }
    return examples;
}

std::string verbOf(const std::string& example)
{
    std::smatch match;
    return std::regex_search(example, match, std::regex("^lathelier-cli ([a-z]+)")) ? match.str(1) : "";
}

/// As a person types it, in the sample's folder.
Outcome typed(const std::string& line, const std::string& folder)
{
    golden::Run run;
    run.words = {"-c", "cd \"$1\" && exec " LATHELIER_CLI + line.substr(std::string("lathelier-cli").size()), "sh",
                 folder};
    return runProgram("/bin/sh", run);
}

TEST(Readme, ExamplesRunOnTheSample)
{
    const ScratchFolder scratch;
    ASSERT_EQ(typed("lathelier-cli sample .", scratch.string()).exit_code, 0);
    ASSERT_GT(readmeExamples().size(), 15u);
    for (const std::string& example : readmeExamples()) {
        const Outcome outcome = typed(example, scratch.string());
        EXPECT_EQ(outcome.exit_code, 0) << example << "\n" << outcome.standard_error;
        EXPECT_FALSE(outcome.standard_output.empty()) << example;
    }
}

TEST(Readme, NamesTheVerbsOfTheProgram)
{
    golden::Run run;
    run.words = {"--help"};
    const std::string help = runProgram(LATHELIER_CLI, run).standard_output;
    const std::string table = help.substr(std::min(help.find("Subcommands:"), help.size()));
    std::set<std::string> verbs, shown{"sample"};  // it makes what the others read
    const std::regex row("\n  ([a-z]+) ");
    for (std::sregex_iterator match(table.begin(), table.end(), row), end; match != end; ++match)
        verbs.insert(match->str(1));
    for (const std::string& example : readmeExamples()) shown.insert(verbOf(example));
    EXPECT_EQ(shown, verbs);
}

}  // namespace
}  // namespace lathelier::golden
