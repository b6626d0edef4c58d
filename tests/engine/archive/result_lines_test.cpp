// Lines of results: what is read, and where what cannot be read stands.
#include "engine/archive/result_lines.h"

#include "tests/engine/archive/archive_fixture.h"

namespace lathelier::archive {
namespace {

std::string lineOf(int number)
{
    return toJson(partEvaluation(number)).dump() + "\n";
}

std::int64_t lineOfError(const std::string& text, const std::string& code)
{
    try {
        readResultLines(text);
    } catch (const Error& error) {
        EXPECT_EQ(error.code().key, code);
        const Value* line = find(error.values(), "line");
        return line ? std::get<std::int64_t>(*line) : -1;
    }
    ADD_FAILURE() << "it was read";
    return -1;
}

TEST(ResultLines, are_evaluations_and_recipes)
{
    const ResultLines lines =
        readResultLines("{\"recipe\": {\"name\": \"seat\"}, \"sha256\": \"ab\"}\r\n\n" + lineOf(1) + lineOf(2) + "   ");
    ASSERT_EQ(lines.evaluations.size(), 2u);
    EXPECT_EQ(toJson(lines.evaluations[1]), toJson(partEvaluation(2)));
    ASSERT_EQ(lines.recipes.size(), 1u);
    EXPECT_EQ(lines.recipes[0].sha256, "ab");
    EXPECT_EQ(lines.recipes[0].content, R"({"name":"seat"})");
    EXPECT_TRUE(readResultLines("").evaluations.empty());
}

TEST(ResultLines, an_export_is_read_again)
{
    const ScratchFolder scratch;
    Archive archive = Archive::open(scratch / "a", Access::Create);
    archive.add(partEvaluations(0, 4), inspector, partRecipes());
    const ResultLines lines = readResultLines(linesOf(archive, false));
    EXPECT_EQ(lines.evaluations.size(), 4u);
    EXPECT_EQ(lines.recipes.size(), 1u);
    Archive other = Archive::open(scratch / "b", Access::Create);
    other.add(lines.evaluations, {}, lines.recipes);
    EXPECT_EQ(linesOf(other, true), linesOf(archive, true));
}

TEST(ResultLines, errors_have_their_line)
{
    EXPECT_EQ(lineOfError(lineOf(1) + "{oops}\n" + lineOf(2), "malformed"), 2);
    EXPECT_EQ(lineOfError(lineOf(1) + "\n{}\n", "key_missing"), 3);
    std::string altered = lineOf(2);
    altered.replace(altered.find("compare"), 7, "compari");
    EXPECT_EQ(lineOfError(lineOf(1) + altered, "evaluation_altered"), 2);
    EXPECT_EQ(lineOfError(lineOf(1) + lineOf(2).substr(0, 50), "line_torn"), 2);
    std::string whole = lineOf(2);
    whole.pop_back();  // complete, but nobody can know
    EXPECT_EQ(lineOfError(lineOf(1) + whole, "line_torn"), 2);
    EXPECT_EQ(lineOfError("{\"recipe\": {}}\n", "key_missing"), 1);
    EXPECT_EQ(lineOfError("{\"recipe\": 3, \"sha256\": \"a\"}\n", "malformed"), 1);
}

}  // namespace
}  // namespace lathelier::archive
