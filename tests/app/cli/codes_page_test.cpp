// The manual's pages of error and note codes are made from the headers that define them, and from the translations:
//     LATHELIER_WRITE_PAGES=1 build/tests/test_golden --gtest_filter=*CodesPage*
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <regex>
#include <string>
#include <vector>

#include "tests/app/cli/manual_languages.h"

namespace lathelier::golden {
namespace {

namespace fs = std::filesystem;

struct Code {
    std::string room, kind, text;
};

/// The string literals of `source` one after another, without their quotes.
std::string joinedLiterals(const std::string& source)
{
    static const std::regex literal(R"re("((?:[^"\\]|\\.)*)")re");
    std::string result;
    for (std::sregex_iterator match(source.begin(), source.end(), literal), end; match != end; ++match)
        result += match->str(1);
    return result;
}

/// By key, of all headers that define codes.
std::map<std::string, Code> definedCodes(const std::string& type)
{
    const std::regex definition(
        type +
        R"re( \w+\{\s*"([\w.]+)",\s*\w+::(\w+),\s*LT_TEXT\(\s*"Engine",((?:\s*"(?:[^"\\]|\\.)*")+)\s*\)(?:,\s*NoteRole::\w+)?\};)re");
    std::map<std::string, Code> codes;
    for (const auto& entry : fs::recursive_directory_iterator(fs::path(LATHELIER_SOURCE_DIR) / "engine")) {
        if (!entry.path().filename().string().ends_with("_codes.h")) continue;
        const std::string text = contentOf(entry.path());
        for (std::sregex_iterator match(text.begin(), text.end(), definition), end; match != end; ++match)
            codes[match->str(1)] = {entry.path().parent_path().filename().string(), match->str(2),
                                    joinedLiterals(match->str(3))};
    }
    return codes;
}

/// What stands for a few characters in XML, and in C++ literals, as itself.
std::string plain(std::string text)
{
    const std::pair<const char*, const char*> marks[] = {{"&lt;", "<"},   {"&gt;", ">"},  {"&quot;", "\""},
                                                         {"&apos;", "'"}, {"&amp;", "&"}, {"\\\"", "\""}};
    for (const auto& [mark, character] : marks)
        for (std::size_t at = text.find(mark); at != std::string::npos; at = text.find(mark, at + 1))
            text.replace(at, std::string(mark).size(), character);
    return text;
}

/// English to the language; empty for English itself.
std::map<std::string, std::string> translations(const std::string& language)
{
    std::map<std::string, std::string> result;
    if (language == "en") return result;
    const std::string text =
        contentOf(fs::path(LATHELIER_SOURCE_DIR) / "translations" / ("lathelier_" + language + ".ts"));
    const std::regex message(
        "<source>([^<]*)</source>\\s*(?:<[a-z]*comment>[^<]*</[a-z]*comment>\\s*)*"
        "<translation>([^<]*)</translation>");
    for (std::sregex_iterator match(text.begin(), text.end(), message), end; match != end; ++match)
        result[plain(match->str(1))] = plain(match->str(2));
    return result;
}

std::string codesPage(const std::string& language)
{
    std::map<std::string, std::string> words = wordsOfPage("codes_page", language);
    EXPECT_EQ(words.size(), 13u) << language << ": the words of a language's page, as in codes_page_en.txt";
    const std::map<std::string, std::string> translated = translations(language);
    const auto table = [&](const std::map<std::string, Code>& codes) {
        std::string lines = "|---|---|---|---|\n";
        for (const auto& [key, code] : codes) {
            const std::string english = plain(code.text);
            const auto found = translated.find(english);
            EXPECT_TRUE(language == "en" || found != translated.end()) << language << ": " << english;
            lines += "| `" + key + "` | " + code.room + " | " + words[code.kind] + " | " +
                     (found == translated.end() ? english : found->second) + " |\n";
        }
        return lines;
    };
    const auto part = [&](const std::string& title, const std::string& head, const std::map<std::string, Code>& codes) {
        return "\n## " + words[title] + "\n\n" + words[head] + "\n" + table(codes);
    };
    return "# " + words["title"] + "\n\n" + words["about"] + "\n" + words["about_2"] + "\n" +
           part("errors", "errors_head", definedCodes("ErrorCode")) +
           part("notes", "notes_head", definedCodes("NoteCode"));
}

class CodesPage : public ::testing::TestWithParam<std::string> {};

TEST_P(CodesPage, IsThatOfTheHeaders)
{
    const fs::path path = fs::path(LATHELIER_SOURCE_DIR) / "resources/manual" / GetParam() / "codes.md";
    if (std::getenv("LATHELIER_WRITE_PAGES")) std::ofstream(path) << codesPage(GetParam());
    EXPECT_EQ(contentOf(path), codesPage(GetParam())) << "see the head of this test for how to make the page anew";
}

INSTANTIATE_TEST_SUITE_P(Languages, CodesPage, ::testing::ValuesIn(manualLanguages()));

TEST(Codes, NoDefinitionIsOverlooked)
{
    for (const std::string type : {"ErrorCode", "NoteCode"}) {
        std::size_t definitions = 0;
        const std::regex head("inline constexpr " + type + " ");
        for (const auto& entry : fs::recursive_directory_iterator(fs::path(LATHELIER_SOURCE_DIR) / "engine"))
            if (entry.path().filename().string().ends_with("_codes.h")) {
                const std::string text = contentOf(entry.path());
                definitions += static_cast<std::size_t>(
                    std::distance(std::sregex_iterator(text.begin(), text.end(), head), std::sregex_iterator()));
            }
        EXPECT_EQ(definedCodes(type).size(), definitions) << type;
        EXPECT_GT(definitions, 20U);
    }
}

}  // namespace
}  // namespace lathelier::golden
