#include "engine/batch/recipe_file.h"

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "engine/batch/batch_codes.h"
#include "engine/io/file.h"
#include "engine/io/json/json_strict.h"
#include "engine/io/relative_path.h"
#include "engine/task/task_fields.h"

namespace lathelier::batch {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t mostInputsOfRecipe = 1000;
constexpr std::size_t digestLength = 64;

[[noreturn]] void refuseMember(const io::JsonCursor& member, const std::string& key, const Value& expected)
{
    const io::JsonPlace here = member.place();
    throw Error(errors::recipeMemberUnknown,
                {{"line", here.line}, {"column", here.column}, {"key", key}, {"expected", expected}});
}

/// Only these members.
void requireMembers(const io::JsonCursor& object, const std::vector<std::string>& known)
{
    io::requireMembers(object, known, errors::recipeMemberUnknown);
}

Values described(const io::JsonCursor& object, const std::vector<FieldInfo>& fields, const Value& expected)
{
    return io::strictValuesOf(object, fields, expected, errors::recipeMemberUnknown);
}

std::string digestFrom(const io::JsonCursor& member)
{
    std::string digest = member.string();
    const auto is_hex = [](char c) { return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'f'); };
    if (digest.size() != digestLength || !std::all_of(digest.begin(), digest.end(), is_hex))
        member.reject(LT_TEXT("Engine", "a SHA-256 of 64 hexadecimal digits"));
    return digest;
}

RecipeFile fileFrom(const io::JsonCursor& object, const std::string& folder)
{
    const io::JsonCursor path = object.at("path", LT_TEXT("Engine", "the path of a file"));
    if (path.string().empty()) path.reject(LT_TEXT("Engine", "the path of a file"));
    return {io::openablePath(folder, path.string()), digestFrom(object.at("sha256", LT_TEXT("Engine", "a SHA-256")))};
}

const task::Task& taskFrom(const io::JsonCursor& member, const Tasks& tasks)
{
    const std::string key = member.string();
    std::string known;
    for (const task::Task* task : tasks) {
        if (task->key == key) return *task;
        known += (known.empty() ? "" : ", ") + task->key;
    }
    const io::JsonPlace here = member.place();
    throw Error(errors::recipeTaskUnknown,
                {{"line", here.line}, {"column", here.column}, {"found", key}, {"known", known}});
}

/// The input of a role that may stand at this place of a recipe.
const task::Input& inputFrom(const task::Task& task, const std::string& role, bool of_part,
                             const io::JsonCursor& member)
{
    std::string known;
    for (const task::Input& input : task.inputs) {
        if (input.is_of_part != of_part || !input.takes_files) continue;
        if (input.role == role) return input;
        known += (known.empty() ? "" : " | ") + input.role;
    }
    refuseMember(member, role, known);
}

FixedInput fixedFrom(const io::JsonCursor& object, const std::string& role, const task::Task& task,
                     const std::string& folder)
{
    requireMembers(object, {"path", "sha256", "reading", "files"});
    FixedInput input;
    input.role = role;
    input.files.push_back(fileFrom(object, folder));
    if (const auto others = object.member("files"))
        others->items(mostInputsOfRecipe, [&](const io::JsonCursor& other) {
            requireMembers(other, {"path", "sha256"});
            input.files.push_back(fileFrom(other, folder));
        });
    if (const auto reading = object.member("reading"))
        input.reading = described(*reading, task::readingFields(task), LT_TEXT("Engine", "a reading option"));
    return input;
}

std::vector<std::string> variedFrom(const io::JsonCursor& list, const task::Task& task)
{
    std::vector<std::string> stated;
    list.items(mostInputsOfRecipe, [&](const io::JsonCursor& item) {
        const std::string role = item.string();
        inputFrom(task, role, true, item);
        if (std::find(stated.begin(), stated.end(), role) != stated.end())
            item.reject(LT_TEXT("Engine", "each role once"));
        stated.push_back(role);
    });
    if (stated.empty()) list.reject(LT_TEXT("Engine", "at least one role"));
    std::vector<std::string> varied;
    for (const task::Input& input : task.inputs)
        if (std::find(stated.begin(), stated.end(), input.role) != stated.end()) varied.push_back(input.role);
    return varied;
}

RecipeShop shopFrom(const io::JsonCursor& object, const std::string& folder)
{
    requireMembers(object, {"path", "sha256", "name"});
    RecipeShop shop;
    if (const auto name = object.member("name"))
        shop.name = name->string();
    else
        shop.file = fileFrom(object, folder);
    if (!shop.isGiven()) object.reject(LT_TEXT("Engine", "a name, or path and sha256"));
    return shop;
}

void requireSchema(const io::JsonCursor& root)
{
    const io::JsonCursor schema = root.at("schema", std::string(recipeSchema));
    if (schema.string() != recipeSchema) schema.reject(std::string(recipeSchema));
    const io::JsonCursor version = root.at("schema_version", std::int64_t{recipeVersion});
    const std::int64_t found = version.integer();
    if (found < 1) version.reject(std::int64_t{recipeVersion});
    if (found <= recipeVersion) return;
    const io::JsonPlace here = version.place();
    throw Error(
        errors::recipeTooNew,
        {{"line", here.line}, {"column", here.column}, {"found", found}, {"maximum", std::int64_t{recipeVersion}}});
}

Json fileAsJson(const RecipeFile& file, const std::string& folder)
{
    return {{"path", io::relativePath(folder, file.path)}, {"sha256", file.sha256}};
}

}  // namespace

Json toJson(const Recipe& recipe, const std::string& folder)
{
    const std::vector<FieldInfo> reading = task::readingFields(*recipe.task);
    Json inputs = Json::object();
    for (const FixedInput& input : recipe.inputs) {
        Json& member = inputs[input.role] = fileAsJson(input.files.front(), folder);
        for (std::size_t i = 1; i < input.files.size(); ++i)
            member["files"].push_back(fileAsJson(input.files[i], folder));
        member["reading"] = io::objectOf(reading, input.reading);
    }
    Json json{{"schema", recipeSchema},
              {"schema_version", recipeVersion},
              {"task", recipe.task->key},
              {"program_version", recipe.version},
              {"inputs", std::move(inputs)},
              {"varied", recipe.varied},
              {"parameters", io::objectOf(task::questionFields(*recipe.task), recipe.parameters)},
              {"reading", io::objectOf(reading, recipe.reading)}};
    if (!recipe.shop.name.empty())
        json["shop"] = {{"name", recipe.shop.name}};
    else if (recipe.shop.isGiven())
        json["shop"] = fileAsJson(recipe.shop.file, folder);
    return json;
}

Json contentOf(const Recipe& recipe)
{
    Json json = toJson(recipe, "/");
    json.erase("program_version");
    for (auto& [role, input] : json["inputs"].items()) {
        input.erase("path");
        if (input.contains("files"))
            for (Json& file : input["files"]) file.erase("path");
    }
    if (json.contains("shop")) json["shop"].erase("path");
    // Sorted keys: the order of the fields may change from version to version.
    return Json::parse(nlohmann::json::parse(json.dump(-1, ' ', false, Json::error_handler_t::replace)).dump());
}

void writeRecipe(const std::string& path, const Recipe& recipe)
{
    io::writeFile(
        path,
        toJson(recipe, fs::path(path).parent_path().string()).dump(2, ' ', false, Json::error_handler_t::replace) +
            "\n");
}

Recipe readRecipe(const std::string& text, const std::string& folder, const Tasks& tasks)
{
    const io::JsonDocument document(text);
    const io::JsonCursor root = document.root();
    requireSchema(root);
    requireMembers(root, {"schema", "schema_version", "task", "program_version", "inputs", "varied", "parameters",
                          "reading", "shop"});
    Recipe recipe;
    recipe.task = &taskFrom(root.at("task", LT_TEXT("Engine", "the name of a command")), tasks);
    recipe.version = root.at("program_version", LT_TEXT("Engine", "a version")).string();
    std::vector<FixedInput> stated;
    if (const auto inputs = root.member("inputs"))
        inputs->members(mostInputsOfRecipe, [&](const std::string& role, const io::JsonCursor& member) {
            inputFrom(*recipe.task, role, false, member);
            stated.push_back(fixedFrom(member, role, *recipe.task, folder));
        });
    for (const task::Input& input : recipe.task->inputs)
        for (FixedInput& one : stated)
            if (one.role == input.role) recipe.inputs.push_back(std::move(one));
    recipe.varied = variedFrom(root.at("varied", LT_TEXT("Engine", "a list of roles")), *recipe.task);
    if (const auto parameters = root.member("parameters"))
        recipe.parameters =
            described(*parameters, task::questionFields(*recipe.task), LT_TEXT("Engine", "a parameter of the task"));
    if (const auto reading = root.member("reading"))
        recipe.reading = described(*reading, task::readingFields(*recipe.task), LT_TEXT("Engine", "a reading option"));
    if (const auto shop = root.member("shop")) recipe.shop = shopFrom(*shop, folder);
    return recipe;
}

LoadedRecipe loadRecipe(const std::string& path, const Tasks& tasks, const Progress& progress)
{
    try {
        const io::FileBytes bytes(path, progress);
        const std::string text(bytes.view());
        LoadedRecipe loaded{readRecipe(text, fs::absolute(path).lexically_normal().parent_path().string(), tasks),
                            {path, static_cast<std::int64_t>(text.size()), io::sha256(text, progress)}};
        return loaded;
    } catch (Error& error) {
        throw error.with("path", path);
    }
}

}  // namespace lathelier::batch
