// Descriptions of controls: complete and free of contradictions, and all that the reader knows.
#include "engine/gcode/control.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <set>
#include <stdexcept>

#include "engine/core/error.h"
#include "engine/gcode/controls/add_words.h"
#include "engine/gcode/detection.h"
#include "engine/gcode/gcode_codes.h"
#include "tests/engine/core/code_of_error.h"
#include "tests/engine/gcode/run_program.h"

namespace lathelier::gcode {
namespace {

std::vector<ControlPtr> thoseRead()
{
    std::vector<ControlPtr> all;
    for (const ControlPtr& control : allControls())
        if (control->is_read) all.push_back(control);
    return all;
}

/// A copy in which something is changed.
template <class Change>
ControlPtr changed(const ControlPtr& control, const Change& change)
{
    Control copy = *control;
    change(copy);
    return std::make_shared<const Control>(std::move(copy));
}

Toolpath pathWith(const ControlPtr& control, const std::string& text)
{
    Program program = readProgram(text, control);
    return findToolpath(program);
}

std::string shownG(int code10)
{
    return fmt::format("G{}", code10 / 10.0);
}

/// A word by its name alone; one with a value where the name takes one.
std::string shownName(const std::string& name)
{
    const bool isAlone = std::isalpha(static_cast<unsigned char>(name.back())) != 0 && name.size() > 1;
    return isAlone ? name : fmt::format("{}=1", name);
}

TEST(Control, KeysAreUniqueAndKeptByTheChoices)
{
    std::set<std::string> keys;
    for (const ControlPtr& control : allControls()) {
        EXPECT_TRUE(keys.insert(control->key).second) << control->key;
        EXPECT_FALSE(control->label.empty()) << control->key;
        EXPECT_EQ(controlNamed(control->key), control);
    }
    EXPECT_EQ(controlNamed(automaticControl), nullptr);
    std::vector<std::string> choices;
    for (const FieldChoice& choice : controlChoices()) choices.push_back(choice.key);
    EXPECT_EQ(choices,
              (std::vector<std::string>{"auto", "fanuc", "fanuc_b", "fanuc_c", "haas", "sinumerik", "linuxcnc"}));
    EXPECT_EQ(usualControl()->key, "fanuc");
}

TEST(Control, TablesOfThoseReadAreComplete)
{
    for (const ControlPtr& control : thoseRead()) {
        const std::string& key = control->key;
        EXPECT_FALSE(control->extensions.empty()) << key;
        for (const G meaning : {G::Rapid, G::Line, G::ArcCw, G::ArcCcw, G::Dwell, G::Thread, G::InchAll, G::Metric,
                                G::PlaneZX, G::NoseOff, G::NoseLeft, G::NoseRight, G::CssOn, G::CssOff, G::PerMinute,
                                G::PerRevolution, G::MachineMove})
            EXPECT_TRUE(hasWord(*control, meaning)) << key << " " << static_cast<int>(meaning);
        for (const auto& [code10, meaning] : control->g) {
            EXPECT_NE(meaning, G::Unknown) << key << " " << shownG(code10);
            EXPECT_TRUE(code10 >= 0 && code10 < 10000) << key << " " << shownG(code10);
        }
        const auto ends = [](const auto& word) { return word.second == M::End || word.second == M::EndOrReturn; };
        EXPECT_TRUE(std::any_of(control->m.begin(), control->m.end(), ends)) << key;
        for (const auto& [number, meaning] : control->m) EXPECT_NE(meaning, M::Unknown) << key << " M" << number;
        for (const char letter : {'N', 'X', 'Z', 'I', 'K', 'F', 'S', 'T'})
            EXPECT_GE(meaningOfLetter(*control, letter), Letter::InBlock) << key << " " << letter;
        for (const auto& [letter, use] : control->letters) {
            EXPECT_NE(use, Letter::Unknown) << key << " " << letter;
            EXPECT_TRUE(letter != 'G' && letter != 'M') << key << ": these have tables of their own";
        }
        for (const auto& [name, meaning] : control->names) {
            EXPECT_NE(meaning, Name::Unknown) << key << " " << name;
            EXPECT_TRUE(std::none_of(name.begin(), name.end(), [](char c) { return c >= 'a' && c <= 'z'; })) << name;
        }
    }
}

TEST(Control, PropertiesGoTogether)
{
    for (const ControlPtr& control : thoseRead()) {
        const std::string& key = control->key;
        EXPECT_EQ(control->grammar.has_names, !control->names.empty()) << key;
        EXPECT_EQ(control->grammar.flow == FlowStyle::Labelled, control->grammar.statements.empty()) << key;
        EXPECT_EQ(control->start.assumed_motion != G::Unknown, !control->start.assumed_motion_word.empty()) << key;
        EXPECT_EQ(control->call_letter != 0, !control->program_head.empty()) << key;
        EXPECT_EQ(control->increments_are_letters, meaningOfLetter(*control, 'U') >= Letter::InBlock) << key;
        EXPECT_EQ(control->grammar.has_comma_words, meaningOfLetter(*control, 'c') >= Letter::InBlock) << key;
        EXPECT_FALSE(control->dwell.empty()) << key;
        for (const DwellWord& of : control->dwell)
            EXPECT_GE(meaningOfLetter(*control, of.letter), Letter::InBlock) << key << " " << of.letter;
        for (const char letter : {control->call_letter, control->css_limit})
            EXPECT_TRUE(letter == 0 || meaningOfLetter(*control, letter) >= Letter::InBlock) << key << " " << letter;
        const bool hasCycles = hasWord(*control, G::RoughTurn) || hasWord(*control, G::DriveThread);
        for (const char letter : {'P', 'Q', 'R'})
            EXPECT_TRUE(!hasCycles || meaningOfLetter(*control, letter) == Letter::InBlock) << key << " " << letter;
    }
}

TEST(Control, EvidenceNamesControlsOfTheList)
{
    for (const ControlPtr& control : allControls()) {
        const Evidence& evidence = control->evidence;
        EXPECT_FALSE(evidence.texts.empty() && evidence.blocks.empty()) << control->key;
        EXPECT_TRUE(!evidence.speaks_for_base || !evidence.variant_of.empty()) << control->key;
        if (!evidence.variant_of.empty()) {
            EXPECT_TRUE(controlNamed(evidence.variant_of)) << control->key;
            EXPECT_GT(evidence.certain, 0) << control->key << " can never be told";
        }
        for (const BlockSign& sign : evidence.blocks)
            for (const auto& codes : {sign.g, sign.also_g, sign.no_g})
                for (const int code : codes) EXPECT_TRUE(code >= 0 && code < 200) << control->key << " G" << code;
        if (control->is_read) continue;
        EXPECT_TRUE(control->g.empty() && control->m.empty() && control->letters.empty()) << control->key;
        EXPECT_GT(evidence.certain, 0) << control->key;
    }
}

TEST(Control, AWordHasOneMeaning)
{
    Control control = *controlNamed("fanuc");
    EXPECT_THROW(addWords(control.g, G::Drill, {0}), std::logic_error);
    EXPECT_THROW(addWords(control.m, M::End, {98}), std::logic_error);
    EXPECT_THROW(addWords(control.letters, Letter::Always, "X"), std::logic_error);
    addWords(control.names, Name::Round, {"RND"});
    EXPECT_THROW(addWords(control.names, Name::NoEffect, {"RND"}), std::logic_error);
    addWords(control.m, M::NoEffect, 0, 999);
    EXPECT_EQ(meaningOfM(control, 98), M::CallProgram);
}

TEST(Control, AWordThatIsTakenAwayIsReported)
{
    const auto isUnknown = [](const ControlPtr& control, const std::string& word) {
        Program program = readProgram(word + "\n", control);
        const bool isReported = diagnosticOf(findToolpath(program), "nc_word_unknown") != nullptr;
        EXPECT_TRUE(!isReported || countUnderstood(program) < countWords(program)) << word;
        return isReported;
    };
    for (const ControlPtr& control : thoseRead()) {
        for (const auto& [code10, meaning] : control->g) {
            const int code = code10;
            EXPECT_FALSE(isUnknown(control, shownG(code))) << control->key << " " << shownG(code);
            EXPECT_TRUE(isUnknown(changed(control, [code](Control& c) { c.g.erase(code); }), shownG(code)))
                << control->key << " " << shownG(code);
        }
        for (const auto& [number, meaning] : control->m) {
            const int code = number;
            const std::string word = fmt::format("M{}", code);
            EXPECT_FALSE(isUnknown(control, word)) << control->key << " " << word;
            EXPECT_TRUE(isUnknown(changed(control, [code](Control& c) { c.m.erase(code); }), word))
                << control->key << " " << word;
        }
        for (const auto& [letter, use] : control->letters) {
            const char gone = letter;
            const bool isComma = std::islower(static_cast<unsigned char>(gone)) != 0;
            const std::string word = fmt::format("{}{}1.", isComma ? "," : "", gone);
            EXPECT_FALSE(isUnknown(control, word)) << control->key << " " << word;
            EXPECT_TRUE(isUnknown(changed(control, [gone](Control& c) { c.letters.erase(gone); }), word))
                << control->key << " " << word;
        }
        for (const auto& [name, meaning] : control->names) {
            const std::string gone = name;
            if (gone.size() == 1) continue;  // "F=1" is a letter
            EXPECT_FALSE(isUnknown(control, shownName(gone))) << control->key << " " << gone;
            EXPECT_TRUE(isUnknown(changed(control, [&gone](Control& c) { c.names.erase(gone); }), shownName(gone)))
                << control->key << " " << gone;
        }
    }
}

TEST(Control, AWordThatIsTakenAwayIsAGap)
{
    const ControlPtr usual = controlNamed("fanuc"), named = controlNamed("sinumerik");
    const std::string increments = "G0 X20. Z5.\nG1 U4. W-2. F.1\n";
    EXPECT_DOUBLE_EQ(pathWith(usual, increments).moves.back().x_mm, 12);
    const auto withoutU = changed(usual, [](Control& c) { c.letters.erase('U'); });
    EXPECT_DOUBLE_EQ(pathWith(withoutU, increments).moves.back().x_mm, 10);
    EXPECT_DOUBLE_EQ(pathWith(withoutU, increments).moves.back().z_mm, 3);
    EXPECT_FALSE(pathWith(withoutU, increments).understanding.isWhole());

    const std::string arc = "G18 G90 DIAMON G95\nG0 X20 Z0\nG2 X30 Z-5 CR=5 F0.1\n";
    EXPECT_FALSE(pathWith(named, arc).has_errors);
    const auto withoutRadius = changed(named, [](Control& c) { c.names.erase("CR"); });
    EXPECT_EQ(pathWith(withoutRadius, arc).moves.size(), 1u);
    EXPECT_EQ(pathWith(withoutRadius, arc).understanding.first()->word, "CR=5");

    const std::string call = "O1\nG0 X20. Z5.\nM98 P2\nM30\nO2\nG0 X30.\nM99\n";
    EXPECT_EQ(pathWith(usual, call).moves.size(), 2u);
    EXPECT_EQ(pathWith(changed(usual, [](Control& c) { c.m.erase(98); }), call).moves.size(), 1u);
}

TEST(Control, AnyControlCanBeGiven)
{
    const auto own = changed(controlNamed("linuxcnc"), [](Control& control) {
        control.key = "own";
        control.start.is_diameter = true;
        control.names = {{"RADIUS", Name::ArcRadius}};
        control.grammar.has_names = true;
    });
    const std::string text = "G21 G95 G0 X20 Z0\nG2 X30 Z-5 RADIUS=5 F0.1\n";
    Program program = readProgram(text, own);
    EXPECT_EQ(program.control, own);
    const Toolpath path = findToolpath(program);
    EXPECT_FALSE(path.has_errors);
    EXPECT_EQ(path.parameters.dialect, "own");
    EXPECT_EQ(path.parameters.control, own);
    ASSERT_EQ(path.moves.size(), 2u);
    EXPECT_DOUBLE_EQ(path.moves.back().x_mm, 15);
    ToolpathParameters parameters;
    parameters.dialect = "fanuc";
    EXPECT_EQ(controlOf(parameters), controlNamed("fanuc"));
    parameters.control = own;
    EXPECT_EQ(controlOf(parameters), own);
}

TEST(Control, OthersAreToldAndRefusedByName)
{
    const std::pair<const char*, const char*> all[] = {
        {"0 BEGIN PGM A MM\nL X+1 Z+2 FMAX\n", "heidenhain"},
        {"$X.MIN%\nG00 X1 Z1\nNAT01\nG85 NLAP1 D4\n", "okuma"},
        {"(MAZATROL)\nUNIT 1\nG0 X1\n", "mazatrol"},
        {"%SHAFT,MX,\nG0 X1 Z1\n", "fagor"},
        {"%PM\nN9001 (BOLT)\nN10 G99 X80 Z220\n", "philips"},
        {"%MPF 12\nR10=5. R11=60.\nN5 G0 X60. Z2. D1\n", "sinumerik_800"},
        {"N10 G90 G95 T1 D1\nR105=1 R106=0.2 R108=2.5\nLCYC95\n", "sinumerik_802"}};
    for (const auto& [text, key] : all) {
        EXPECT_EQ(detectControl(text).control->key, key) << text;
        EXPECT_GT(detectControl(text).line, 0) << text;
        EXPECT_EQ(codeOfError([&] { readProgram(text); }), errors::ncDialectNotRead) << text;
        EXPECT_EQ(codeOfError([&] { readProgram("G0 X1.\n", controlNamed(key)); }), errors::ncDialectNotRead) << text;
    }
    EXPECT_EQ(detectControl("HELLO\n").control->key, usualControl()->key);
    EXPECT_EQ(detectControl("HELLO\n").line, 0);
}

TEST(Control, NewFilesHaveTheExtensionOfTheirControl)
{
    EXPECT_EQ(extensionOf(controlNamed("sinumerik")), ".mpf");
    EXPECT_EQ(extensionOf(controlNamed("fanuc_b")), ".nc");
    EXPECT_EQ(extensionOf(controlNamed("okuma")), ".nc");  // not read
    EXPECT_EQ(extensionOf(nullptr), ".nc");
}

}  // namespace
}  // namespace lathelier::gcode
