#include "engine/batch/recipe_kind.h"

#include <filesystem>

#include "engine/batch/recipe_file.h"
#include "engine/io/json/json_head.h"

namespace lathelier::batch {
namespace {

io::Likeness likeRecipe(const std::string&, std::string_view head, const Values&)
{
    const std::vector<std::string> keys = io::keysOfHead(head);
    // These stand first in a recipe that was saved: its inputs may be longer than the head.
    return io::hasKey(keys, "schema") && io::hasKey(keys, "task") && io::hasKey(keys, "program_version")
               ? io::Likeness::Certain
               : io::Likeness::No;
}

Rows variedRows(const Recipe& recipe)
{
    Rows rows;
    rows.rows.reserve(recipe.varied.size());
    for (const std::string& role : recipe.varied) rows.rows.push_back({{{"role", role}}});
    return rows;
}

Rows fixedRows(const Recipe& recipe)
{
    Rows rows;
    for (const FixedInput& input : recipe.inputs)
        for (const RecipeFile& file : input.files)
            rows.rows.push_back({{{"role", input.role}, {"path", file.path}, {"sha256", file.sha256}}});
    return rows;
}

Rows shopRow(const RecipeShop& shop)
{
    if (!shop.name.empty()) return {{{{{"name", shop.name}}}}};
    return {{{{{"path", shop.file.path}, {"sha256", shop.file.sha256}}}}};
}

io::FileFacts recipeFacts(const io::FileToRead& file, const Tasks& tasks)
{
    Recipe recipe;
    try {
        const std::string folder = std::filesystem::path(file.path).parent_path().string();
        recipe = readRecipe(std::string(file.bytes), folder, tasks);
    } catch (Error& error) {
        throw error.with("path", file.path);
    }
    io::FileFacts facts;
    facts.path = file.path;
    facts.format = "recipe";
    facts.encoding = "utf-8";
    facts.details = {{"schema_version", std::int64_t{recipeVersion}},
                     {"program_version", recipe.version},
                     {"task", recipe.task->key},
                     {"recipe_sha256", identityOf(recipe)},
                     {"varied", variedRows(recipe)},
                     {"fixed_inputs", fixedRows(recipe)}};
    if (recipe.shop.isGiven()) facts.details.emplace_back("shop", shopRow(recipe.shop));
    return facts;
}

}  // namespace

io::FileKind recipeFiles(const Tasks& tasks)
{
    return {"recipe",
            LT_TEXT("Engine", "Recipes"),
            "*.json",
            {},
            {},
            likeRecipe,
            [tasks](const io::FileToRead& file, Notes&) { return recipeFacts(file, tasks); }};
}

}  // namespace lathelier::batch
