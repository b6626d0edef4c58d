// Changes of single words and blocks: the rest of the program and its moves are unchanged.
#include <gtest/gtest.h>

#include "engine/gcode/gcode_codes.h"
#include "engine/gcode/rewriter.h"
#include "tests/engine/core/code_of_error.h"
#include "tests/engine/gcode/run_program.h"

namespace lathelier::gcode {
namespace {

struct Read {
    Program program;
    Toolpath path;

    explicit Read(const std::string& text)
        : program(readProgram(text, controlNamed("fanuc"))), path(findToolpath(program))
    {
    }
};

TEST(Rewriter, ReplacesAnX)
{
    const Read read("N70 G0 X28. Z2. M8 (IN)\r\nG1 Z-280. F0.2\r\nX36.");
    Rewriter rewriter(read.program, read.path);
    rewriter.setX(0, 13.9694135);
    const RewrittenProgram out = rewriter.write();
    EXPECT_EQ(out.text, "N70 G0 X27.939 Z2. M8 (IN)\r\nG1 Z-280. F0.2\r\nX36.");
    EXPECT_EQ(out.blocks_changed, 1);
    EXPECT_EQ(out.blocks_added, 0);
    ASSERT_EQ(out.changes.size(), 1u);
    EXPECT_EQ(out.changes[0].line, 1);
}

TEST(Rewriter, SplitsABlock)
{
    const Read read("G0 X28. Z2.\nN80 G01 Z-280. F0.2 M8 (ROUGH PASS)\nX36.\n");
    Rewriter rewriter(read.program, read.path);
    rewriter.split(1, {{{14, 0}, {}}, {{13.98, -140}, {}}, {{13.995, -280}, {}}});
    const RewrittenProgram out = rewriter.write();
    EXPECT_EQ(out.text, "G0 X28. Z2.\nN80 G01 Z0. F0.2 M8 (ROUGH PASS)\nX27.96 Z-140.\nX27.99 Z-280.\nX36.\n");
    EXPECT_EQ(out.blocks_added, 2);
    const Toolpath moves = pathOf(out.text, "fanuc");
    ASSERT_EQ(moves.moves.size(), 5u);
    EXPECT_NEAR(moves.moves[3].x_mm, 13.995, 1e-12);
    EXPECT_EQ(moves.moves[3].feed_mm_rev, 0.2);
}

TEST(Rewriter, IncrementsFollow)
{
    const Read read("G0 X30. Z2.\nG1 Z-10. F.1\nU4. W-5.\nU2.\n");
    Rewriter rewriter(read.program, read.path);
    rewriter.setX(0, 14.95);
    const RewrittenProgram out = rewriter.write();
    EXPECT_EQ(out.text, "G0 X29.9 Z2.\nG1 Z-10. F.1\nU4.1 W-5.\nU2.\n");
    EXPECT_NEAR(pathOf(out.text, "fanuc").moves.back().x_mm, 18, 1e-9);
}

TEST(Rewriter, WritesWhatTheShiftedZeroNeeds)
{
    const Read read("G0 X28. Z2.\nG52 X-2. Z-5.\nN80 G01 X30. Z-280. F0.2\nG52 X0. Z0.\nX36.\n");
    EXPECT_DOUBLE_EQ(read.path.moves[1].x_mm, 14);
    Rewriter rewriter(read.program, read.path);
    rewriter.split(2, {{{13.9, -100}, {}}, {{14, -285}, {}}});
    const RewrittenProgram out = rewriter.write();
    EXPECT_EQ(out.text, "G0 X28. Z2.\nG52 X-2. Z-5.\nN80 G01 X29.8 Z-95. F0.2\nX30. Z-280.\nG52 X0. Z0.\nX36.\n");
    const Toolpath moves = pathOf(out.text, "fanuc");
    EXPECT_NEAR(moves.moves[1].x_mm, 13.9, 1e-12);
    EXPECT_NEAR(moves.moves[1].z_mm, -100, 1e-12);
}

TEST(Rewriter, AWordThatTurnsTheSpindleIsKept)
{
    const Read read("G0 X28. Z2.\nG01 Z-280. F0.2 M3 S900\nX36.\n");
    Rewriter rewriter(read.program, read.path);
    EXPECT_FALSE(rewriter.refusal(1));
    rewriter.split(1, {{{13.98, -140}, {}}, {{14, -280}, {}}});
    EXPECT_EQ(rewriter.write().text, "G0 X28. Z2.\nG01 X27.96 Z-140. F0.2 M3 S900\nX28. Z-280.\nX36.\n");
}

TEST(Rewriter, RefusesWhatItCannotKeep)
{
    const auto refused = [](const std::string& text, std::size_t block) {
        const Read read(text);
        Rewriter rewriter(read.program, read.path);
        EXPECT_TRUE(rewriter.refusal(block)) << text;
        rewriter.setX(block, 10);
        EXPECT_EQ(codeOfError([&] { rewriter.write(); }), errors::ncBlockNotRewritable) << text;
    };
    refused("G0 X30. Z2.\nG42 G1 X20. Z0. F.1\nZ-5.\nG40 X50.\n", 2);
    refused("G0 X50. Z2.\nG71 U2. R1.\nG71 P1 Q2 U.4 W.1 F.2\nN1 G0 X20.\nG1 Z-9.\nN2 X50.\n", 4);
    refused("O1\nG0 X50. Z2.\nM98 P2\nM98 P2\nM30\nO2\nG0 X40.\nM99\n", 6);
    refused("#1=20.\nG0 X#1 Z2.\n", 1);
    refused("G0 X50. Z2.\nG90 X40. Z-5. F.1\n", 1);
    EXPECT_EQ(codeOfError([] {
                  const Read read("G0 X20. Z0.\nG1 Z-5. F.1\nG2 X24. Z-7. R2.\n");
                  Rewriter rewriter(read.program, read.path);
                  rewriter.setX(1, 9.98);
                  rewriter.write();
              }),
              errors::ncBlockNotRewritable);
}

}  // namespace
}  // namespace lathelier::gcode
