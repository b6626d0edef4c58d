// The manual's pages of what is not modelled are made from the descriptions of the controls:
//     LATHELIER_WRITE_PAGES=1 build/tests/test_golden --gtest_filter=*NotModelledPage*
#include <gtest/gtest.h>

#include <fmt/format.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <string>

#include "engine/core/texts.h"
#include "engine/gcode/controls/controls.h"
#include "tests/app/cli/manual_languages.h"

namespace lathelier::golden {
namespace {

namespace fs = std::filesystem;

void append(std::string& list, const std::string& word)
{
    if (!list.empty()) list += ", ";
    list += "`" + word + "`";
}

std::string notModelledPage(const std::string& language)
{
    std::map<std::string, std::string> words = wordsOfPage("not_modelled", language);
    EXPECT_EQ(words.size(), 7u) << language << ": the words of a language's page, as in not_modelled_en.txt";
    std::string text = fmt::format("# {}\n\n{}\n\n{}\n\n{}\n\n## {}\n\n{}\n|---|---|---|---|\n", words["title"],
                                   words["about"], words["always"], words["assumed"], words["words"], words["head"]);
    std::string unread;
    for (const gcode::ControlPtr& control : gcode::allControls()) {
        const std::string name = lathelier::text(control->label);
        if (!control->is_read) {
            unread += "- " + name + "\n";
            continue;
        }
        std::string codes, names, letters;
        for (const auto& [code, meaning] : control->g)
            if (meaning == gcode::G::NotModelled || meaning == gcode::G::MillOn || meaning == gcode::G::DrillAcross ||
                meaning == gcode::G::PlaneOther || meaning == gcode::G::InverseTime)
                append(codes, code % 10 == 0 ? fmt::format("G{}", code / 10) : fmt::format("G{}", code / 10.0));
        for (const auto& [called, meaning] : control->names)
            if (meaning == gcode::Name::MillOn) append(names, called);
        for (const auto& [letter, use] : control->letters)
            if (use == gcode::Letter::NotModelled) append(letters, std::string(1, letter));
        text += fmt::format("| {} | {} | {} | {} |\n", name, codes, names, letters);
    }
    return text + "\n## " + words["unread"] + "\n\n" + unread;
}

class NotModelledPage : public ::testing::TestWithParam<std::string> {};

TEST_P(NotModelledPage, IsThatOfTheControls)
{
    const fs::path path = fs::path(LATHELIER_SOURCE_DIR) / "resources/manual" / GetParam() / "not-modelled.md";
    if (std::getenv("LATHELIER_WRITE_PAGES")) std::ofstream(path) << notModelledPage(GetParam());
    EXPECT_EQ(contentOf(path), notModelledPage(GetParam()))
        << "see the head of this test for how to make the page anew";
}

INSTANTIATE_TEST_SUITE_P(Languages, NotModelledPage, ::testing::ValuesIn(manualLanguages()));

}  // namespace
}  // namespace lathelier::golden
