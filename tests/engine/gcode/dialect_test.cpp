// Which control a program is for: what tells it, what does not, and what is asked.
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <map>
#include <random>
#include <set>

#include "engine/core/error.h"
#include "engine/gcode/detection.h"
#include "engine/gcode/gcode_codes.h"
#include "tests/engine/core/code_of_error.h"
#include "tests/engine/gcode/run_program.h"

namespace lathelier::gcode {
namespace {

std::string told(const std::string& text, const std::string& name = {})
{
    return detectControl(text, name).control->key;
}

TEST(Dialect, FanucAndHaasAsManualsListThem)
{
    const std::pair<const char*, const char*> all[] = {
        {"%;\nO21(EOB);\nG21G99;\nT0303;\nG97S640M3;\nG0X44.Z3.;\nG1Z-17.F.15;\nM30;\n%\n", "fanuc"},
        {"o7\ng21 g99\nt0202\ng97 s700 m3\ng0 x44. z3.\ng1 z-17. f.15\nm30\n", "fanuc"},
        {"o1 ; a remark\ng21 g99 ; of another editor\n; g90 t1 m6\ng0 x44. z3. ;\ng1 z-17. f.15\n", "fanuc"},
        {":0412(BUSH)\nG21 G40 G99\nG97 S500 M3\nG0 X44. Z3.\nG1 Z-17. F.15\n", "fanuc"},
        {"%\nO00031\nN10 G40 G21\nN20 T5 M06\nN30 IF [ #5405 GE 800 ] THEN #3000= 7 (WORN)\nG0 X44. Z3.\n", "fanuc"},
        {"O3\nG21 G99 G97 S500 M3\nG0 X60. Z4.\nM97 P700\nM30\nN700 G0 X44. Z3.\nG1 Z-17. F.15\nM99\n", "haas"},
        {"N1 G90 G0 X44. Z3.\nG1 Z-17. F.15\n", "fanuc_b"},
    };
    for (const auto& [text, key] : all) {
        EXPECT_EQ(told(text), key) << text;
        const Toolpath path = pathOf(text);
        EXPECT_FALSE(path.has_errors) << text << path.diagnostics.front().code;
        const bool isCut = std::any_of(path.moves.begin(), path.moves.end(),
                                       [](const Move& move) { return move.x_mm == 22 && move.z_mm == 3; });
        EXPECT_TRUE(isCut) << text;
    }
}

TEST(Dialect, SystemsOfFanuc)
{
    const std::pair<const char*, const char*> all[] = {
        {"%\nO310\nG21 G90 G40 G95\nG92 S1800\nG0 X44. Z3.\nG1 Z-17. F.15\n", "fanuc_b"},
        {"%O310(BUSH)\nN5 G21 G90 G95\nN6 (T0404)\nN7 G97 S900 M3\nN8 G0 X44. Z3.\nN9 G1 Z-17. F.15\n", "fanuc_b"},
        {"G90 G95 G21\nT0404 M6\nG97 S900 M3\nG0 X44. Z3.\nG1 Z-17. F.15\n", "fanuc_b"},
        {"G92 S1800\nG0 X44. Z3.\nG1 Z-17. F.15\n", "fanuc_b"},
        {"O2\nG0 X50. Z3.\nG91 G1 X-6. F.15\nG90 Z-17.\n", "fanuc_b"},
        {"O2\nG0 X50. Z3. T0404\nG77 X44. Z-17. F.15\n", "fanuc_b"},
        {"O2\nG71 G90 G95\nG92 S1800\nT0404\nG0 X44. Z3.\nG1 Z-17. F.15\n", "fanuc_c"},
        {"O2\nT0404\nG0 X50. Z3.\nG20 X44. Z-17. F.15\n", "fanuc_c"},
        // system A all the same: G90 in a line that was copied, G94 and G92 as cycles
        {"O2\nG18 G21 G40 G90 G99\nT0404\nG50 S1800\nG0 X44. Z3.\nG1 Z-17. F.15\n", "fanuc"},
        {"O2\nG21 G99\nT0404\nG0 X50. Z3.\nG94 X20. Z-1. F.1\nG92 X44. Z-17. F1.5\n", "fanuc"},
    };
    for (const auto& [text, key] : all) EXPECT_EQ(told(text), key) << text;
}

TEST(Dialect, LinuxCncByItsOwnWords)
{
    for (const char* text : {"G21 G90 G95\nT2 M6\nS700 M3\nG0 X22. Z3.\nG1 Z-17. F.15\n",
                             "G7 G90 G94\nG0 X44 Z3\nG1 Z-17 F90\n", "G21 G18 G90 G94 G40\nT1\nM0\nG0 X22 Z3\n",
                             "o100 sub\nG0 X22 Z3\no100 endsub\no100 call\n", "O10\nG90 G94\n#<r>=22\nG0 X#<r> Z3\n"})
        EXPECT_EQ(told(text), "linuxcnc") << text;
    EXPECT_EQ(told("G0 X22 Z3\nG1 Z-17 F90\n", "/w/shaft.NGC"), "linuxcnc");
    EXPECT_EQ(told("G0 X22 Z3\nG1 Z-17 F90\n", "/w/shaft.nc"), usualControl()->key);
    EXPECT_EQ(told("O4\nT0101\nG50 S900\nG0 X22 Z3\n", "/w/shaft.ngc"), "fanuc");
}

TEST(Dialect, OthersAreNamed)
{
    const std::pair<const char*, const char*> all[] = {
        {"G50 S1800\nT020202\nG97 S700 M3 M8\nG0 X48 Z4\nG71 X44.6 Z-25 B60 D0.8 U0.1 H1.8 L2 F1.5\n", "okuma"},
        {"G140\nG50 S1800\nT050505\nG0 X48 Z4\nG1 Z-9 F.2\nG3 X50 Z-10 L1\n", "okuma"},
        {"N1 G50 S3000\nN2 T0303\nN3 G96 S200 M3\nN4 G0 X48 Z4\nN5 G95 G1 Z-9 F.2\nM2\n", "okuma"},
        {"%_N_BOLT_MPF\nG90 G95 T2 D1\nR105=9 R106=0.3 R108=1.5 R109=7\nLCYC95\nM2\n", "sinumerik_802"},
        {"%MPF 31\n(BOLT)\nR20=101 R21=5.\nN5 @714\nN10 G0 X44. Z3. D4\n", "sinumerik_800"},
        {"N9002 (BOLT)\nN10 G99 X90 Z300\nN8003 X40 Z2\nN8013\nN20 G13 N1=8003 N2=8013\n", "philips"},
    };
    for (const auto& [text, key] : all) {
        EXPECT_EQ(told(text), key) << text;
        EXPECT_EQ(codeOfError([&] { readProgram(text); }), errors::ncDialectNotRead) << text;
    }
    EXPECT_EQ(told("G0 X48 Z4\nG1 Z-9 F.2\n", "/w/BOLT.MIN"), "okuma");
    EXPECT_EQ(told("N10 G71 G90 G95\nN20 T1 D1\nN30 G0 X44 Z3\n"), "sinumerik");
    EXPECT_EQ(told("N10 G90 G95 T1 M6\nN20 R1=44\nN30 G0 X=R1 Z3\n"), "sinumerik");
}

TEST(Dialect, TwoThatAreEquallyLikelyAreAsked)
{
    const std::string head = "G21 G90 G94\nG32\nT1 M6\n";  // 2 and 5 points against 7
    ASSERT_TRUE(detectControl(head).rival);
    EXPECT_NO_THROW(readProgram(head));  // no number in it is read differently
    try {
        readProgram(head + "G0 X40. Z2.\nG1 Z-10. F100.\n");
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), errors::dialectUnclear);
        EXPECT_EQ(std::get<std::string>(*find(error.values(), "choices")), "fanuc_b, linuxcnc");
    }
    EXPECT_NO_THROW(readProgram(head + "G0 X40. Z2.\n", controlNamed("fanuc_b")));
    EXPECT_FALSE(detectControl("G0 X1.\n").rival);  // nothing tells: as ever
}

/// Moves without the lines that caused them.
std::string movesOf(const Toolpath& path)
{
    std::string text;
    for (const Move& move : path.moves)
        for (const double value : {static_cast<double>(move.kind), move.x_mm, move.z_mm, move.centre_x_mm,
                                   move.centre_z_mm, move.feed_mm_rev, move.feed_mm_min, move.speed_rpm,
                                   move.cutting_speed_m_min, move.speed_limit_rpm, move.dwell_s})
            text += std::to_string(value) + " ";
    return text;
}

/// A program with other numbers for its G words.
std::string renumbered(const std::string& text, const std::map<int, int>& numbers)
{
    std::string result;
    for (std::size_t at = 0; at < text.size();) {
        result += text[at++];
        if (result.back() != 'G') continue;
        std::size_t to = at;
        while (to < text.size() && std::isdigit(static_cast<unsigned char>(text[to]))) ++to;
        const int number = std::stoi(text.substr(at, to - at));
        const auto other = numbers.find(number);
        result += std::to_string(other == numbers.end() ? number : other->second);
        at = to;
    }
    return result;
}

constexpr const char* inSystemA =
    "%\nO12\nG21 G40 G99\nT0101\nG50 S2000\nG96 S180 M3\nG0 X52. Z2.\nG90 X46. Z-30. F0.25\nX42. R-1.\n"
    "G0 X52. Z2.\nG94 X20. Z-1. F0.2\nZ-2.\nG0 X46. Z4.\nG92 X39.2 Z-20. F1.5\nX38.6\nG0 X50. Z1.\n"
    "G71 U2. R0.5\nG71 P10 Q20 U0.4 W0.1 F0.3\nN10 G0 X30.\nG1 Z-10. F0.1\nN20 X48. W-2.\nG70 P10 Q20\n"
    "G72 W1. R0.5\nG72 P30 Q40 U0.2 W0.1 F0.3\nN30 G0 Z-8.\nG1 X40. F0.1\nN40 X34. Z1.\n"
    "G73 U3. W1. R3\nG73 P50 Q60 U0.2 W0.1 F0.3\nN50 G0 X30.\nG1 Z-10. F0.1\nN60 X50.\n"
    "G0 X50. Z2.\nG76 P020060 Q80 R0.03\nG76 X36. Z-18. P920 Q250 F1.5\nG74 R0.5\nG74 Z-20. Q5000 F0.1\n"
    "G75 R0.5\nG75 X40. Z-8. P2000 Q1000 F0.1\nG98 G1 U-2. F80.\nG32 Z-20. F1.5\nM30\n%\n";

TEST(Dialect, TheSystemsOfFanucDifferInTheirNumbers)
{
    const std::map<int, int> b{{50, 92}, {90, 77}, {92, 78}, {94, 79}, {98, 94}, {99, 95}, {32, 33}};
    const std::map<int, int> c{{20, 70}, {21, 71}, {50, 92}, {70, 72}, {71, 73}, {72, 74}, {73, 75}, {74, 76},
                               {75, 77}, {76, 78}, {90, 20}, {92, 21}, {94, 24}, {98, 94}, {99, 95}, {32, 33}};
    const Toolpath expected = pathOf(inSystemA);
    EXPECT_EQ(expected.parameters.dialect, "fanuc");
    ASSERT_FALSE(expected.has_errors);
    EXPECT_GT(expected.moves.size(), 100U);
    for (const auto& [key, numbers] : {std::pair{"fanuc_b", b}, std::pair{"fanuc_c", c}}) {
        const Toolpath path = pathOf(renumbered(inSystemA, numbers));
        EXPECT_EQ(path.parameters.dialect, key);
        EXPECT_EQ(path.words_understood, path.words) << key;
        EXPECT_EQ(movesOf(path), movesOf(expected)) << key;
    }
}

TEST(Dialect, IncrementsOfSystemB)
{
    const Toolpath path = pathOf(
        "O5\nG21 G90 G95\nG92 S1500\nG0 X44. Z3.\nG91 G1 X-4. Z-5. F.2\nU-2. W-1.\n"
        "G2 X4. Z-2. R2.\nG90 G1 X50. G94 F60.\nG92 X60. Z0.\nG91 G0 X2.\n");
    ASSERT_FALSE(path.has_errors);
    EXPECT_EQ(path.parameters.dialect, "fanuc_b");
    ASSERT_EQ(path.moves.size(), 6U);
    const double x[] = {22, 20, 19, 21, 25, 31}, z[] = {3, -2, -3, -5, -5, 0};
    for (std::size_t i = 0; i < 6; ++i) {
        EXPECT_DOUBLE_EQ(path.moves[i].x_mm, x[i]) << i;
        EXPECT_DOUBLE_EQ(path.moves[i].z_mm, z[i]) << i;
    }
    EXPECT_DOUBLE_EQ(path.moves[1].feed_mm_rev, 0.2);
    EXPECT_DOUBLE_EQ(path.moves[4].feed_mm_min, 60);
    EXPECT_DOUBLE_EQ(path.moves[4].speed_limit_rpm, 1500);
}

TEST(Dialect, InchesOfSystemC)
{
    const Toolpath path = pathOf("O5\nG70 G90 G95\nT0101\nG0 X2. Z.1\nG1 Z-1. F.01\n");
    EXPECT_EQ(path.parameters.dialect, "fanuc_c");
    ASSERT_EQ(path.moves.size(), 2U);
    EXPECT_DOUBLE_EQ(path.moves[1].x_mm, 25.4);
    EXPECT_DOUBLE_EQ(path.moves[1].feed_mm_rev, 0.254);
}

TEST(Dialect, ColonIsTheLetterOOfIsoCode)
{
    const std::string text = ":10(MAIN)\nG21 G99\nM98 P20\nM30\n:20\nG0 X44. Z3.\nM99\n";
    for (const char* key : {"fanuc", "fanuc_b", "fanuc_c", "haas"}) {
        const Toolpath path = pathOf(text, key);
        EXPECT_FALSE(path.has_errors) << key;
        ASSERT_EQ(path.moves.size(), 1U) << key;
        EXPECT_DOUBLE_EQ(path.moves[0].x_mm, 22);
    }
    for (const char* wrong : {"G0 :10 X1.\n", ": X1.\n"})
        EXPECT_TRUE(diagnosticOf(pathOf(wrong, "fanuc"), "nc_character_unexpected")) << wrong;
}

TEST(Dialect, BlocksBehindTheEndOfABlockAreNoted)
{
    const Toolpath path = pathOf("O2; T0101;\nG21 G99;\nG0 X44. Z3.; G1 Z-17. F.15;\nX50. ; rapid\n", "fanuc");
    const Diagnostic* const found = diagnosticOf(path, "nc_block_not_modelled");
    ASSERT_TRUE(found);
    EXPECT_EQ(found->line, 1);
    EXPECT_EQ(found->column, 3);
    const auto count = std::count_if(path.diagnostics.begin(), path.diagnostics.end(),
                                     [](const Diagnostic& d) { return d.code == "nc_block_not_modelled"; });
    EXPECT_EQ(count, 2);
    EXPECT_TRUE(pathOf("G0 X44 Z3 ; G1 Z-17\n", "linuxcnc").diagnostics.empty());  // a comment
}

TEST(Dialect, CallInTheSameProgramIsOfHaas)
{
    const std::string text = "G0 X50. Z2.\nM97 P700 L2\nG1 Z-5. F.2\nM30\nN700 G0 U-2.\nM99\n";
    const Toolpath own = pathOf(text, "haas");
    EXPECT_EQ(own.words_understood, own.words);
    ASSERT_EQ(own.moves.size(), 4U);
    EXPECT_DOUBLE_EQ(own.moves.back().x_mm, 23);
    for (const char* key : {"fanuc", "fanuc_b", "fanuc_c"}) {
        const Toolpath path = pathOf(text, key);
        const Diagnostic* const found = diagnosticOf(path, "nc_block_not_modelled");
        ASSERT_TRUE(found) << key;
        EXPECT_EQ(found->line, 2);
        EXPECT_FALSE(isKnown(path.moves.back().x_mm)) << key << ": where the call leads is not known";
        EXPECT_TRUE(diagnosticOf(pathOf("M97\n", key), "nc_word_not_modelled")) << key;
    }
}

/// Fanuc and Haas programs of one kind each, with numbers of a generator.
class Generated {
public:
    explicit Generated(unsigned seed) : numbers_(seed) {}

    std::string program()
    {
        const int system = pick(0, 3);  // A, B, Haas, C
        const bool isLater = system == 1 || system == 3;
        std::string text = pick(0, 1) ? "%\n" : "";
        text += (pick(0, 3) ? "O" : ":") + std::to_string(pick(1, 9999)) + (pick(0, 1) ? "(PART)\n" : "\n");
        text += system == 3 ? "G71 " : "G21 ";
        text += isLater ? "G90 G95\n" : "G40 G99\n";
        if (system == 2) text += "G53 G0 X0. Z-200.\n";
        text += "T0" + std::to_string(pick(1, 9)) + "0" + std::to_string(pick(1, 9)) + "\n";
        if (pick(0, 1)) text += (isLater ? "G92 S" : "G50 S") + std::to_string(pick(500, 4000)) + "\n";
        text += "G97 S" + std::to_string(pick(300, 3000)) + " M3\nG0 X80. Z2.\n";
        for (int i = pick(1, 12); i > 0; --i) text += cut(system);
        return text + "M30\n";
    }

    /// The same program as others write it.
    std::string disguised(const std::string& text)
    {
        static constexpr const char* remarks[]{
            "",         "(G90 G94 T1 M6)", "; g7 g90 g94 t2 m6 g43", "(O100 SUB)", ";", "( G64 P0.01 )", "  ",
            "; #<r>=1", "(T0303)"};
        const bool hasEnds = pick(0, 1), isSmall = pick(0, 1);
        std::string result;
        for (std::size_t at = 0; at < text.size();) {
            const std::size_t end = text.find('\n', at);
            while (pick(0, 5) == 0) result += std::string(remarks[pick(0, 8)]) + "\n";
            std::string line = text.substr(at, end - at);
            if (isSmall)
                for (char& c : line) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
            result += line + (hasEnds ? ";\n" : "\n");
            at = end + 1;
        }
        return result;
    }

private:
    int pick(int least, int most) { return std::uniform_int_distribution(least, most)(numbers_); }
    std::string number(int least, int most)
    {
        return std::to_string(pick(least, most)) + "." + std::to_string(pick(0, 9));
    }
    std::string cut(int system)
    {
        switch (pick(0, 4)) {
            case 0:
                return "G0 X" + number(20, 70) + " Z2.\nG1 Z-" + number(1, 40) + " F0." + std::to_string(pick(1, 4)) +
                       "\n";
            case 1: return "G1 U-" + number(0, 3) + " W-" + number(0, 3) + " F.2\n";
            case 2: return "G0 X" + number(20, 70) + " Z0.\nG3 U4. W-2. R2. F.1\nG0 Z2.\n";
            case 3: {
                static constexpr const char* cycles[]{"G90", "G77", "G90", "G20"};
                return "G0 X80. Z2.\n" + std::string(cycles[system]) + " X" + number(20, 70) + " Z-" + number(1, 40) +
                       " F.2\nG0 Z3.\n";
            }
            default: return "G4 X" + number(0, 2) + "\n";
        }
    }

    std::mt19937 numbers_;
};

TEST(Dialect, WhatOthersWriteAroundAProgramTellsNothing)
{
    const std::set<std::string> expected{"fanuc", "fanuc_b", "fanuc_c", "haas"};
    std::set<std::string> seen;
    for (unsigned seed = 0; seed < 200; ++seed) {
        Generated generated(seed);
        const std::string text = generated.program();
        const Toolpath path = pathOf(text);
        ASSERT_FALSE(path.has_errors) << text << path.diagnostics.front().code;
        ASSERT_TRUE(expected.contains(path.parameters.dialect)) << path.parameters.dialect << "\n" << text;
        seen.insert(path.parameters.dialect);
        for (int i = 0; i < 3; ++i) {
            const std::string other = generated.disguised(text);
            const Toolpath again = pathOf(other);
            ASSERT_EQ(again.parameters.dialect, path.parameters.dialect) << other;
            ASSERT_EQ(movesOf(again), movesOf(path)) << other;
            ASSERT_EQ(again.words_understood, path.words_understood) << other;
        }
    }
    EXPECT_EQ(seen, expected);
}

}  // namespace
}  // namespace lathelier::gcode
