// The page of the manual about the command line says what the program has, no less and no more.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include "tests/app/cli/manual_languages.h"
#include "tests/app/cli/run_program.h"

namespace lathelier::golden {
namespace {

namespace fs = std::filesystem;
using Words = std::set<std::string>;

Words found(const std::string& text, const std::regex& pattern)
{
    Words words;
    for (std::sregex_iterator match(text.begin(), text.end(), pattern), end; match != end; ++match)
        words.insert(match->str(1));
    return words;
}

std::string helpOf(const std::vector<std::string>& words)
{
    Run run;
    run.words = words;
    run.words.emplace_back("--help");
    const Outcome outcome = runProgram(LATHELIER_CLI, run);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.standard_error;
    return outcome.standard_output;
}

/// Options as they begin a line of a help page: "  -h,--help …", "  --seed N …".
Words optionsOf(const std::string& help)
{
    return found(help, std::regex("\n  (?:-[a-z],)?(--[A-Za-z0-9-]+)"));
}

/// By verb; the options that come without a verb stand under an empty name.
std::map<std::string, Words> optionsOfProgram()
{
    const std::string help = helpOf({});
    std::map<std::string, Words> options{{"", optionsOf(help)}};
    const std::string verbs = help.substr(std::min(help.find("Subcommands:"), help.find("Commands:")));
    for (const std::string& verb : found(verbs, std::regex("\n  ([a-z]+) "))) options[verb] = optionsOf(helpOf({verb}));
    return options;
}

std::string pageIn(const fs::path& language)
{
    const fs::path path = fs::path(LATHELIER_SOURCE_DIR) / "resources" / "manual" / language / "command-line.md";
    std::ifstream file(path);
    EXPECT_TRUE(file) << path;
    return {std::istreambuf_iterator<char>(file), {}};
}

class ManualPage : public ::testing::TestWithParam<std::string> {};

TEST_P(ManualPage, NamesTheVerbsAndTheirOptions)
{
    const std::string page = pageIn(GetParam());
    const Words named = found(page, std::regex("(--[A-Za-z][A-Za-z0-9-]*)"));
    const std::map<std::string, Words> program = optionsOfProgram();
    ASSERT_GT(program.size(), 5u);
    Words known;
    for (const auto& [verb, options] : program) {
        EXPECT_TRUE(verb.empty() || page.find("\n## " + verb + "\n") != std::string::npos) << verb;
        ASSERT_FALSE(options.empty()) << verb;
        for (const std::string& option : options) EXPECT_TRUE(named.count(option)) << verb << " " << option;
        known.insert(options.begin(), options.end());
    }
    for (const std::string& option : named) EXPECT_TRUE(known.count(option)) << option;
}

INSTANTIATE_TEST_SUITE_P(Languages, ManualPage, ::testing::ValuesIn(manualLanguages()));

}  // namespace
}  // namespace lathelier::golden
