// Blocks and words: the text is preserved, unsupported parts are reported with their positions.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "engine/core/error.h"
#include "engine/gcode/gcode_codes.h"
#include "engine/gcode/rewriter.h"
#include "tests/engine/core/code_of_error.h"
#include "tests/engine/gcode/run_program.h"

namespace lathelier::gcode {
namespace {

std::string again(const std::string& text, const char* control = "fanuc")
{
    Program program = readProgram(text, controlNamed(control));
    const Toolpath path = findToolpath(program);
    return Rewriter(program, path).write().text;
}

TEST(Reading, KeepsEveryByte)
{
    for (const char* text :
         {"G0 X1.\r\nZ2.\nX3.\rZ4.", "\xEF\xBB\xBF%\r\nO1\r\nG0X28.Z.5\r\n%", "G0 X28.000 (\xE9\xE4) Z+02.\n\n\n",
          "/2 N10G00X-.5Z1.;x\r\r\n", "garbage $$ && \n", "\n", "(open\n", "G0 X1.2.3\n"})
        EXPECT_EQ(again(text), text);
    EXPECT_EQ(again(keptProgram("contour_fanuc.nc")), keptProgram("contour_fanuc.nc"));
}

RC_GTEST_PROP(Reading, KeepsAnyText, (const std::vector<unsigned char>& bytes))
{
    std::string text = "G0 X1.\n";
    for (const unsigned char byte : bytes) text += byte == 0 ? 'X' : static_cast<char>(byte);
    for (const char* control : {"fanuc", "sinumerik", "linuxcnc"}) RC_ASSERT(again(text, control) == text);
}

TEST(Reading, BlocksAndWordsAreRangesOfTheText)
{
    const Program program = readProgram("N10 G01 X-28.5 (a)\r\nZ[1+2]", controlNamed("fanuc"));
    ASSERT_EQ(program.blocks.size(), 2u);
    ASSERT_EQ(program.words.size(), 5u);
    EXPECT_EQ(program.textOf(program.words[2]), "X-28.5");
    EXPECT_EQ(program.words[2].value, -28.5);
    EXPECT_EQ(program.valueOf(program.words[4]), "[1+2]");
    EXPECT_EQ(countWords(program), 4);
    EXPECT_EQ(program.wordOf(program.blocks[0], 'X'), &program.words[2]);
}

struct Malformed {
    const char* text;
    const char* code;
    std::int64_t line, column;
};

TEST(Reading, MalformedProgramsAreLocated)
{
    const Malformed all[] = {
        {"G0 X1. Z1.\nG1 X\n", "nc_number_missing", 2, 4},
        {"G0 X1. Z1.\n  G1 X1.2.3\n", "nc_number_missing", 2, 6},
        {"(\xC3\xA9\xC3\xA9) G0 X1. @5\n", "nc_character_unexpected", 1, 13},
        {"G0 X1. (open\nZ1.\n", "nc_comment_not_closed", 1, 8},
        {"G0 X10. Z0.\nG1 Z-5.\n", "nc_feed_missing", 2, 1},
        {"G0 X10. Z0. F.1\nG2 X20. Z-5.\n", "nc_arc_incomplete", 2, 1},
        {"G0 X10. Z0. F.1\nG2 X20. Z-5. R2.\n", "nc_arc_radius_too_small", 2, 1},
        {"G0 X10. Z0. F.1\nG2 X20. Z-5. I3. K0.\n", "nc_arc_end_off_circle", 2, 1},
        {"G0 X[1/0] Z1.\n", "nc_expression_malformed", 1, 9},
        {"G0 X[1+] Z1.\n", "nc_expression_malformed", 1, 8},
        {"G0 X1. Z1.\nGOTO 50\n", "nc_sequence_missing", 2, 1},
        {"#1=1\nWHILE[#1 GT 2]DO1\nM30\n", "nc_flow_unmatched", 2, 1},
        {"G0 X50. Z2.\nG71 U2. R1.\nG71 P10 Q20 U.4 F.2\nM30\n", "nc_sequence_missing", 3, 5},
        {"G0 X10. Z0. F.1\nG1 X20. ,R9.\nZ-1.\n", "nc_corner_impossible", 2, 1},
        {"G0 X10. U1. Z2.\n", "nc_words_conflict", 1, 9},
        {"#3000=1(STOP)\n", "nc_alarm", 1, 1},
    };
    for (const Malformed& expected : all) {
        const Toolpath path = pathOf(expected.text, "fanuc");
        const Diagnostic* found = diagnosticOf(path, expected.code);
        ASSERT_TRUE(found) << expected.text << (path.diagnostics.empty() ? "" : path.diagnostics.front().code);
        EXPECT_EQ(found->line, expected.line) << expected.text;
        EXPECT_EQ(found->column, expected.column) << expected.text;
        EXPECT_TRUE(path.has_errors) << expected.text;
        EXPECT_FALSE(found->block.empty());
    }
}

TEST(Reading, AllFaultsAreNamedNotTheFirstOnly)
{
    const Toolpath path = pathOf("G0 X1. Z1.\nG1 X\nG1 @\nG999\nY5.\n", "fanuc");
    EXPECT_TRUE(diagnosticOf(path, "nc_number_missing"));
    EXPECT_TRUE(diagnosticOf(path, "nc_character_unexpected"));
    EXPECT_TRUE(diagnosticOf(path, "nc_word_unknown"));
    EXPECT_TRUE(diagnosticOf(path, "nc_word_not_modelled"));
}

TEST(Reading, UnknownWordsAreWarnings)
{
    const Toolpath path = pathOf("G0 X10. Z2.\nG1 Z-5. F.1 B45.\nG321\nX50\n", "fanuc");
    EXPECT_FALSE(path.has_errors);
    EXPECT_EQ(path.words, 9);
    EXPECT_EQ(path.words_understood, 7);
    EXPECT_TRUE(diagnosticOf(path, "nc_integer_without_point"));
    EXPECT_DOUBLE_EQ(path.moves.back().x_mm, 25);
    ToolpathParameters micrometres;
    micrometres.integer_words = IntegerWords::Micrometre;
    EXPECT_DOUBLE_EQ(pathOf("G0 X50 Z2.\n", "fanuc", micrometres).moves.back().x_mm, 0.025);
}

TEST(Reading, TellsControls)
{
    const std::pair<const char*, const char*> all[] = {
        {"%\nO1\nG21 G99\nG28 U0.\nT0101\nG50 S2000\n", "fanuc"},
        {"G7 G18\nT1 M6 G43\nG96 D2500 S200 M3\n", "linuxcnc"},
        {"G21 G18 G90 G94 G40\nT1\nM0\nG0 X10 Z1\n", "linuxcnc"},
        {"N10 G90 DIAMON\nLIMS=3000\nG2 X1 Z1 CR=5\n", "sinumerik"},
        {"%\nO1\nG53 G0 X0. Z-250.\nT0101\nG50 S2000\n", "haas"},
        {"%\nO1\nG21 G90 G95\nT0101\nG92 S3000\n", "fanuc_b"},
        {";Cannot\ng1x1\n", "fanuc"},
    };
    for (const auto& [text, key] : all) EXPECT_EQ(readProgram(text).control->key, key) << text;
    for (const char* text : {"0 BEGIN PGM A MM\nL X+1 Z+2 FMAX\n", "$X.MIN%\nG00 X1 Z1\nNAT01\nG85 NLAP1 D4\n"})
        EXPECT_EQ(codeOfError([&] { readProgram(text); }), errors::ncDialectNotRead) << text;
}

TEST(Reading, LimitsEndQuickly)
{
    EXPECT_TRUE(diagnosticOf(pathOf("#1=0\nWHILE[1 EQ 1]DO1\n#1=#1+1\nEND1\n", "fanuc"), "nc_loop_limit"));
    EXPECT_TRUE(diagnosticOf(pathOf("N1 G0 X1. Z1.\nGOTO1\n", "fanuc"), "nc_loop_limit"));
    std::string longBody = "WHILE[1 EQ 1]DO1\n";
    for (int i = 0; i < 1000; ++i) longBody += "#1=#1+1\n";
    EXPECT_TRUE(diagnosticOf(pathOf("#1=0\n" + longBody + "END1\n", "fanuc"), "nc_block_limit"));
    EXPECT_TRUE(diagnosticOf(pathOf("O1\nM98P1\n", "fanuc"), "nc_nesting_too_deep"));
    EXPECT_TRUE(diagnosticOf(pathOf("o1 sub\no1 call\no1 endsub\no1 call\n", "linuxcnc"), "nc_nesting_too_deep"));
    EXPECT_TRUE(diagnosticOf(pathOf("A: R1=1\nGOTOB A\n", "sinumerik"), "nc_loop_limit"));
    EXPECT_TRUE(diagnosticOf(pathOf("G0 X" + std::string(5000, '[') + "\n", "fanuc"), "nc_expression_malformed"));
    EXPECT_TRUE(diagnosticOf(pathOf("G0 X9. Z9.\nN1 G70 P1 Q2\nN2 X5.\n", "fanuc"), "nc_cycle_incomplete"));
    const std::string longLine = "G0 X1. Z1. (" + std::string(100'000, 'x') + ")\n";
    EXPECT_FALSE(pathOf(longLine, "fanuc").has_errors);
}

}  // namespace
}  // namespace lathelier::gcode
