#include "engine/batch/recipe.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "engine/batch/batch_codes.h"
#include "engine/batch/recipe_file.h"
#include "engine/io/io_codes.h"
#include "tests/engine/batch/number_task.h"

namespace lathelier::batch {
namespace {

using testing::HasSubstr;

template <class Work>
Error errorOf(const Work& work)
{
    try {
        work();
    } catch (const Error& error) {
        return error;
    }
    ADD_FAILURE() << "no error";
    return Error(ErrorCode{"none", ErrorKind::NoAnswer, {}}, {});
}

std::int64_t numberIn(const Error& error, const char* name)
{
    const Value* const value = find(error.values(), name);
    const auto* const number = value ? std::get_if<std::int64_t>(value) : nullptr;
    return number ? *number : -1;
}

Recipe reread(const Recipe& recipe, const ScratchFolder& folder)
{
    writeRecipe((folder / "recipe.json").string(), recipe);
    return loadRecipe((folder / "recipe.json").string(), numberTasks()).recipe;
}

TEST(Recipe, is_the_same_read_back)
{
    const ScratchFolder folder;
    const Recipe made = numberRecipe(folder, {{"factor", 2.5}, {"name", std::string("ünlü \"1\"")}});
    const Recipe read = reread(made, folder);
    EXPECT_EQ(read.task, &numberTask());
    EXPECT_EQ(read.varied, std::vector<std::string>{"part"});
    EXPECT_EQ(read.parameters, made.parameters);
    EXPECT_EQ(read.reading, made.reading);
    ASSERT_EQ(read.inputs.size(), 1U);
    EXPECT_EQ(read.inputs.front().files.front().path, made.inputs.front().files.front().path);
    EXPECT_EQ(identityOf(read), identityOf(made));
    EXPECT_EQ(toJson(read, folder.string()), toJson(made, folder.string()));
    EXPECT_EQ(toJson(made, folder.string())["parameters"]["limit"], 10.0);  // defaults too
    EXPECT_EQ(toJson(made, folder.string())["inputs"]["reference"]["path"], "reference.txt");
}

TEST(Recipe, identity_follows_content_and_question_and_nothing_else)
{
    const ScratchFolder folder;
    const Recipe made = numberRecipe(folder);
    const std::string identity = identityOf(made);
    Recipe same = made;
    same.version = "0.0";
    writeText(folder / "elsewhere" / "copy.txt", "0.5\n");
    same.inputs.front().files.front().path = (folder / "elsewhere" / "copy.txt").string();
    EXPECT_EQ(identityOf(same), identity);
    EXPECT_EQ(identityOf(numberRecipe(folder, {{"factor", std::int64_t{1}}})), identity);  // 1 is 1.0
    EXPECT_NE(identityOf(numberRecipe(folder, {{"factor", 1.5}})), identity);
    Recipe other = made;
    other.inputs.front().files.front().sha256[0] ^= 1;
    EXPECT_NE(identityOf(other), identity);
    other = made;
    set(other.reading, "unit", std::string("in"));
    EXPECT_NE(identityOf(other), identity);
    other = made;
    set(other.inputs.front().reading, "unit", std::string("in"));
    EXPECT_NE(identityOf(other), identity);
    other = made;
    other.shop.name = "built-in";
    EXPECT_NE(identityOf(other), identity);
    other = made;
    other.inputs.clear();
    EXPECT_NE(identityOf(other), identity);
}

TEST(Recipe, form_of_the_file_does_not_count)
{
    const ScratchFolder folder;
    const Recipe made = numberRecipe(folder);
    const std::string text = toJson(made, folder.string()).dump();
    EXPECT_EQ(identityOf(readRecipe(text, folder.string(), numberTasks())), identityOf(made));
    const std::string sorted = nlohmann::json::parse(text).dump(7);
    EXPECT_EQ(identityOf(readRecipe(sorted, folder.string(), numberTasks())), identityOf(made));
}

TEST(Recipe, changed_and_missing_inputs_are_named_with_their_digests)
{
    const ScratchFolder folder;
    const Recipe made = numberRecipe(folder);
    EXPECT_NO_THROW(requireUnchanged(made));
    writeText(folder / "reference.txt", "0.75\n");
    Error error = errorOf([&] { requireUnchanged(made); });
    EXPECT_EQ(error.code(), errors::recipeInputChanged);
    EXPECT_THAT(error.what(), HasSubstr(made.inputs.front().files.front().sha256));
    EXPECT_THAT(error.what(), HasSubstr("reference.txt"));
    EXPECT_NE(*find(error.values(), "found"), *find(error.values(), "expected"));
    std::filesystem::remove(folder / "reference.txt");
    error = errorOf([&] { requireUnchanged(made); });
    EXPECT_EQ(error.code(), errors::recipeInputMissing);
    EXPECT_EQ(error.code().kind, ErrorKind::InputRejected);
    EXPECT_THAT(error.what(), HasSubstr("reference.txt"));
}

TEST(Recipe, unknown_members_are_refused_by_name_and_place)
{
    const ScratchFolder folder;
    Json json = toJson(numberRecipe(folder), folder.string());
    json["parameters"]["facter"] = 2;
    Error error = errorOf([&] { readRecipe(json.dump(1), folder.string(), numberTasks()); });
    EXPECT_EQ(error.code(), errors::recipeMemberUnknown);
    EXPECT_EQ(*find(error.values(), "key"), Value(std::string("facter")));
    EXPECT_GT(numberIn(error, "line"), 10);
    EXPECT_GT(numberIn(error, "column"), 0);
    json["parameters"].erase("facter");
    json["colour"] = "red";
    error = errorOf([&] { readRecipe(json.dump(1), folder.string(), numberTasks()); });
    EXPECT_EQ(error.code(), errors::recipeMemberUnknown);
    EXPECT_THAT(error.what(), HasSubstr("colour"));
    json.erase("colour");
    json["inputs"]["part"] = json["inputs"]["reference"];
    error = errorOf([&] { readRecipe(json.dump(1), folder.string(), numberTasks()); });
    EXPECT_EQ(error.code(), errors::recipeMemberUnknown);
}

TEST(Recipe, values_are_checked_where_they_stand)
{
    const ScratchFolder folder;
    const Json good = toJson(numberRecipe(folder), folder.string());
    const auto codeOf = [&](const std::function<void(Json&)>& spoil) {
        Json json = good;
        spoil(json);
        const Error error = errorOf([&] { readRecipe(json.dump(1), folder.string(), numberTasks()); });
        EXPECT_GT(numberIn(error, "line"), 0) << error.what();
        return std::string(error.code().key);
    };
    EXPECT_EQ(codeOf([](Json& json) { json["parameters"]["factor"] = 1000; }), "key_out_of_range");
    EXPECT_EQ(codeOf([](Json& json) { json["parameters"]["factor"] = "much"; }), "malformed");
    EXPECT_EQ(codeOf([](Json& json) { json["task"] = "weigh"; }), "recipe_task_unknown");
    EXPECT_EQ(codeOf([](Json& json) { json["schema"] = "lathelier-project"; }), "malformed");
    EXPECT_EQ(codeOf([](Json& json) { json["schema_version"] = 2; }), "recipe_too_new");
    EXPECT_EQ(codeOf([](Json& json) { json["varied"] = Json::array(); }), "malformed");
    EXPECT_EQ(codeOf([](Json& json) { json["varied"] = {"part", "part"}; }), "malformed");
    EXPECT_EQ(codeOf([](Json& json) { json["varied"] = {"reference"}; }), "recipe_member_unknown");
    EXPECT_EQ(codeOf([](Json& json) { json["inputs"]["reference"]["sha256"] = "0"; }), "malformed");
    EXPECT_EQ(codeOf([](Json& json) { json["inputs"]["reference"]["reading"]["units"] = "mm"; }),
              "recipe_member_unknown");
    EXPECT_EQ(codeOf([](Json& json) { json.erase("task"); }), "key_missing");
}

TEST(Recipe, what_it_cannot_hold_is_refused)
{
    const ScratchFolder folder;
    project::PanelState state;
    EXPECT_EQ(errorOf([&] { recipeOf(numberTask(), state); }).code(), errors::recipeNothingVaries);
    state.inputs["part"].path = "any.txt";
    state.inputs["reference"].item = "nominal";
    const Error item = errorOf([&] { recipeOf(numberTask(), state); });
    EXPECT_EQ(item.code(), errors::recipeHoldsNoItem);
    EXPECT_THAT(item.what(), HasSubstr("nominal"));
    state.inputs.erase("reference");
    set(state.parameters, "name", folder.string());
    const Error place = errorOf([&] { recipeOf(numberTask(), state); });
    EXPECT_EQ(place.code(), errors::recipeNamesPlace);
    EXPECT_THAT(place.what(), HasSubstr("--name"));
}

}  // namespace
}  // namespace lathelier::batch
