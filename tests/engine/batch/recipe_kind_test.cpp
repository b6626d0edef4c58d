#include "engine/batch/recipe_kind.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "engine/batch/batch_codes.h"
#include "engine/batch/recipe_file.h"
#include "engine/io/input_files.h"
#include "tests/engine/batch/number_task.h"

namespace lathelier::batch {
namespace {

class RecipeKind : public ::testing::Test {
protected:
    io::FileFacts factsOf(const Recipe& recipe)
    {
        writeRecipe(path_, recipe);
        return factsOfFile();
    }

    io::FileFacts factsOfFile() const
    {
        io::InputFiles inputs;
        Notes notes;
        io::FileFacts facts = kind_.facts({path_, inputs.open(path_), {}, inputs, {}}, notes);
        EXPECT_TRUE(notes.empty());
        return facts;
    }

    ScratchFolder scratch_;
    std::string path_ = (scratch_ / "recipe.json").string();
    io::FileKind kind_ = recipeFiles(numberTasks());
};

TEST_F(RecipeKind, is_told_by_its_head)
{
    writeRecipe(path_, numberRecipe(scratch_));
    EXPECT_EQ(io::findKind({&kind_}, path_).likeness, io::Likeness::Certain);
    const std::string head = textOf(path_).substr(0, 200);  // the inputs do not end in it
    EXPECT_EQ(kind_.sniff(path_, head, {}), io::Likeness::Certain);
    EXPECT_EQ(kind_.sniff(path_, R"({"schema": "lathelier-dossier", "steps": [], "verdict": "pass"})", {}),
              io::Likeness::No);
    EXPECT_EQ(kind_.sniff(path_, R"({"task": "number", "version": "1"})", {}), io::Likeness::No);
    EXPECT_EQ(kind_.sniff(path_, "1 2 3\n", {}), io::Likeness::No);
}

TEST_F(RecipeKind, facts_name_the_task_what_varies_and_what_all_parts_share)
{
    Recipe recipe = numberRecipe(scratch_);
    RecipeFile second = recipe.inputs.front().files.front();
    second.path = (scratch_ / "named.txt").string();
    second.sha256[0] = second.sha256[0] == 'a' ? 'b' : 'a';
    recipe.inputs.front().files.push_back(second);
    const io::FileFacts facts = factsOf(recipe);
    EXPECT_EQ(facts.path, path_);
    EXPECT_EQ(facts.format, "recipe");
    const std::string reference = (scratch_ / "reference.txt").string();
    const Rows shared{{{{{"role", "reference"}, {"path", reference}, {"sha256", io::fileSha256(reference)}}},
                       {{{"role", "reference"}, {"path", second.path}, {"sha256", second.sha256}}}}};
    const Values expected{
        {"schema_version", std::int64_t{1}},   {"program_version", recipe.version},      {"task", "number"},
        {"recipe_sha256", identityOf(recipe)}, {"varied", Rows{{{{{"role", "part"}}}}}}, {"fixed_inputs", shared}};
    EXPECT_EQ(facts.details, expected);
}

TEST_F(RecipeKind, facts_name_the_shop)
{
    Recipe recipe = numberRecipe(scratch_);
    recipe.shop.name = "built-in";
    const Rows named{{{{{"name", "built-in"}}}}};
    const io::FileFacts built_in = factsOf(recipe);
    ASSERT_TRUE(find(built_in.details, "shop"));
    EXPECT_EQ(*find(built_in.details, "shop"), Value(named));

    recipe.shop = {{(scratch_ / "shop.json").string(), std::string(64, 'c')}, {}};
    const Rows of_file{{{{{"path", recipe.shop.file.path}, {"sha256", recipe.shop.file.sha256}}}}};
    const io::FileFacts own = factsOf(recipe);
    ASSERT_TRUE(find(own.details, "shop"));
    EXPECT_EQ(*find(own.details, "shop"), Value(of_file));
}

TEST_F(RecipeKind, what_is_refused_has_its_file_and_place)
{
    Json json = toJson(numberRecipe(scratch_), scratch_.string());
    json["task"] = "unheard";
    writeText(path_, json.dump(1));
    try {
        factsOfFile();
        FAIL() << "not refused";
    } catch (const Error& error) {
        EXPECT_EQ(error.code().key, errors::recipeTaskUnknown.key);
        ASSERT_TRUE(find(error.values(), "path") && find(error.values(), "line"));
        EXPECT_EQ(*find(error.values(), "path"), Value(path_));
        EXPECT_EQ(*find(error.values(), "line"), Value(std::int64_t{4}));
    }
}

}  // namespace
}  // namespace lathelier::batch
