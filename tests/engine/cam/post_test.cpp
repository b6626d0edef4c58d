// Posts as data, and the program text of moves.
#include "engine/cam/post/post.h"

#include <gtest/gtest.h>

#include "engine/cam/post/program_writer.h"
#include "tests/engine/cam/plan_data.h"

namespace lathelier::cam {
namespace {

Operation smallOperation()
{
    Operation operation;
    operation.kind = OperationKind::Finish;
    operation.tool = 2;
    operation.cutting_speed_m_min = 190;
    MoveList moves(Eigen::Vector2d(0, 0));
    moves.rapid({-2, 22});
    moves.rapidX(10);
    moves.line({5, 10}, 0.1);
    CurvePiece arc;  // a quarter outward, convex
    arc.from = {5, 10};
    arc.centre = {5, 9};
    arc.radius_mm = 1;
    arc.to = {6, 9};
    moves.follow({arc}, 0.1);
    operation.moves = moves.taken();
    return operation;
}

TEST(Post, BuiltInOnesAreReadAndWrittenBack)
{
    const std::vector<std::string> expected{"fanuc_a", "fanuc_b", "grbl", "haas", "linuxcnc", "sinumerik"};
    EXPECT_EQ(postNames(), expected);
    for (const std::string& name : postNames()) {
        const Post post = postNamed(name);
        EXPECT_EQ(post.name, name);
        Notes notes;
        EXPECT_EQ(readPost(postText(post), notes), post) << name;
        EXPECT_TRUE(notes.empty());
    }
}

TEST(Post, WritesWordsOfItsControl)
{
    const std::vector<Operation> operations{smallOperation()};
    const ProgramHead head{"TITLE", 100, 3000, false, {}};
    const std::string fanuc = writeProgram(postNamed("fanuc_a"), head, operations).text;
    EXPECT_NE(fanuc.find("N30 T0202\n"), std::string::npos) << fanuc;
    EXPECT_NE(fanuc.find("G50 S3000\n"), std::string::npos);
    EXPECT_NE(fanuc.find(" G0 X44. Z2.\n"), std::string::npos);
    EXPECT_NE(fanuc.find(" G1 Z-5. F0.1\n"), std::string::npos);
    EXPECT_NE(fanuc.find(" G3 X18. Z-6. I-1. K0.\n"), std::string::npos);
    const std::string other = writeProgram(postNamed("sinumerik"), head, operations).text;
    EXPECT_NE(other.find(" G3 X18 Z-6 CR=1\n"), std::string::npos) << other;
    EXPECT_NE(other.find("T=\"T2\" D1"), std::string::npos);
    const std::string radius = writeProgram(postNamed("grbl"), head, operations).text;
    EXPECT_NE(radius.find("\nG3 X9 Z-6 I-1 K0\n"), std::string::npos) << radius;
    // 190 m/min at a diameter of 20 mm, limited by 3000: 3000 · 0.1.
    EXPECT_NE(radius.find("S3000 M3"), std::string::npos);
    EXPECT_NE(radius.find("F300"), std::string::npos);
}

TEST(Post, CountsFromWhatWasWritten)
{
    Operation operation = smallOperation();
    operation.moves.clear();
    MoveList moves(Eigen::Vector2d(0, 0));
    moves.rapid({-2, 20.00017});
    moves.line({0.00049, 20.00017}, 0.1);
    CurvePiece arc;
    arc.from = {0.00049, 20.00017};
    arc.centre = {0.00049, 19.00017};
    arc.radius_mm = 1;
    arc.to = {1.00049, 19.00017};
    moves.follow({arc}, 0.1);
    operation.moves = moves.taken();
    const std::string text = writeProgram(postNamed("fanuc_a"), {"T", 1, 3000, false, {}}, {operation}).text;
    // X40.000 was written, the centre is 1.00017 - 0.00017 below that.
    EXPECT_NE(text.find("X38. Z-1. I-1. K0."), std::string::npos) << text;
}

TEST(Post, CommentsHoldNothingThatEndsThem)
{
    const Post post = postNamed("fanuc_a");
    EXPECT_EQ(commentText(post, "a (b) Ø30\nG0 X0 %"), "A [B] D30 G0 X0  ");
    EXPECT_LE(commentText(post, std::string(500, 'x')).size(), 60U);
    const std::string text =
        writeProgram(post, {"x)\nG0 X0 (", 100, 3000, false, {"c)\nG1 Z5"}}, {smallOperation()}).text;
    EXPECT_EQ(text.find("\nG0 X0"), std::string::npos);
    EXPECT_EQ(text.find("\nG1 Z5"), std::string::npos);
}

TEST(Post, BadFilesAreRefusedWithTheirPlace)
{
    const auto refused = [](const std::string& from, const std::string& to) -> std::pair<std::string, std::int64_t> {
        std::string text = postText(postNamed("fanuc_a"));
        const std::size_t at = text.find(from);
        EXPECT_NE(at, std::string::npos) << from;
        text.replace(at, from.size(), to);
        try {
            Notes notes;
            readPost(text, notes);
        } catch (const Error& error) {
            const Value* line = find(error.values(), "line");
            return {error.code().key, line ? std::get<std::int64_t>(*line) : 0};
        }
        return {"", 0};
    };
    EXPECT_EQ(refused("\"decimals\": 3", "\"decimals\": 2").first, "key_out_of_range");
    EXPECT_GT(refused("\"decimals\": 3", "\"decimals\": 2").second, 1);
    EXPECT_EQ(refused("\"arc\": \"ik\"", "\"arc\": \"kk\"").first, "malformed");
    EXPECT_EQ(refused("{tool2}{tool2}", "{tool3}").first, "malformed");
    EXPECT_EQ(refused("\"rapid\": \"G0\"", "\"rapid\": \"\"").first, "malformed");
    EXPECT_EQ(refused("\"rapid\"", "\"rapids\"").first, "key_missing");
    EXPECT_EQ(refused("\"G0\"", "\"G0\\nM30\"").first, "malformed");
}

TEST(Post, CyclesOfNoTemplatesAreThoseOfTheControl)
{
    std::string text = postText(postNamed("fanuc_b"));
    const auto replace = [&text](const std::string& from, const std::string& to) {
        const std::size_t at = text.find(from);
        ASSERT_NE(at, std::string::npos) << from;
        text.replace(at, from.size(), to);
    };
    replace("\"cycles\": \"none\"", "\"cycles\": \"g71_g70\"");
    replace("\"rough_cycle\"", "\"x_rough\"");
    Notes notes;
    EXPECT_EQ(readPost(text, notes).rough_cycle.size(), 2U);
    replace("\"dialect\": \"fanuc_b\"", "\"dialect\": \"fanuc_c\"");  // there G71 selects millimetres
    EXPECT_THROW(readPost(text, notes), Error);
}

/// M1 stands where the tool before is retracted, before each further tool only; G54 with the modes, and once.
TEST(Post, OptionalStopsAndWorkOffset)
{
    Operation first = smallOperation(), second = smallOperation();
    first.tool = 1;
    ProgramHead head{"T", 1, 3000, false, {}};
    head.has_optional_stops = head.states_offset = true;
    const std::string fanuc = writeProgram(postNamed("fanuc_a"), head, {first, second}).text;
    EXPECT_NE(fanuc.find("N20 G54\nN30 G28 U0. W0.\nN40 T0101\n"), std::string::npos) << fanuc;
    const std::size_t stop = fanuc.find(" M1\n");
    ASSERT_NE(stop, std::string::npos) << fanuc;
    EXPECT_EQ(fanuc.find(" M1\n", stop + 1), std::string::npos);
    EXPECT_EQ(fanuc.substr(fanuc.rfind('N', stop - 2) - 15, 15).find("G28 U0. W0.") != std::string::npos, true)
        << fanuc;
    EXPECT_LT(stop, fanuc.find("T0202"));
    const std::string siemens = writeProgram(postNamed("sinumerik"), head, {first, second}).text;
    EXPECT_EQ(siemens.find("G54"), siemens.rfind("G54")) << siemens;
    EXPECT_THROW(writeProgram(postNamed("grbl"), head, {first, second}), Error);
    Post bare = postNamed("fanuc_a");
    bare.work_offset.clear();
    EXPECT_THROW(statedOffset(bare), Error);
}

}  // namespace
}  // namespace lathelier::cam
