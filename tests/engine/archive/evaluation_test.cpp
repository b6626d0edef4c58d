#include "engine/archive/evaluation.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "engine/archive/archive_codes.h"

namespace lathelier::archive {
namespace {

Evaluation sampleEvaluation(const std::string& folder)
{
    Evaluation made;
    made.task = "compare";
    made.recipe_sha256 = "r";
    made.version = "1";
    made.inputs = {{"copy", {folder + "/copy_1.ply", 12, "abc"}}};
    made.verdict = Verdict::Fail;
    made.characteristics = {{"answer", "mm", 0.06, 0.002, -0.05, 0.05, Verdict::Fail}};
    made.result = Json{
        {"inputs", {{{"path", folder + "/copy_1.ply"}}}},
        {"parameters", {{"reference", folder + "/copy_1.ply"}}},
        {"rmse_mm",
         0.1}}.dump();
    return made;
}

TEST(Evaluation, is_the_same_read_back_from_its_line)
{
    const Evaluation made = sampleEvaluation("/a");
    const std::string line = toJson(made).dump();
    EXPECT_EQ(line.find('\n'), std::string::npos);
    EXPECT_EQ(toJson(evaluationFrom(line)).dump(), line);
}

TEST(Evaluation, key_is_that_of_the_content_and_not_of_the_place)
{
    const Evaluation made = sampleEvaluation("/a");
    EXPECT_EQ(made.key(), sampleEvaluation("/b/c").key());
    Evaluation other = made;
    other.inputs.front().file.sha256 = "abd";
    EXPECT_NE(made.key(), other.key());
    other = made;
    other.version = "2";
    EXPECT_NE(made.key(), other.key());
}

TEST(Evaluation, canonical_form_does_not_depend_on_the_folder)
{
    EXPECT_EQ(canonicalOf(sampleEvaluation("/a")).dump(), canonicalOf(sampleEvaluation("/b/c")).dump());
    EXPECT_NE(canonicalOf(sampleEvaluation("/a")).dump().find("copy_1.ply"), std::string::npos);
}

TEST(Evaluation, altered_content_is_refused)
{
    std::string line = toJson(sampleEvaluation("/a")).dump();
    line.replace(line.find("\"abc\""), 5, "\"abd\"");
    try {
        evaluationFrom(line);
        FAIL() << "it was taken";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), errors::evaluationAltered);
    }
}

TEST(Evaluation, odd_lines_are_refused_with_their_place)
{
    for (const char* line : {"", "{", "[]", "{}", "{\"key\": 1}", "null"}) {
        SCOPED_TRACE(line);
        EXPECT_THROW(evaluationFrom(line), Error);
    }
}

}  // namespace
}  // namespace lathelier::archive
