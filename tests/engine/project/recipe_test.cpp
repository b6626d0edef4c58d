#include "engine/project/recipe.h"

#include <gtest/gtest.h>

#include "engine/project/project_json.h"

namespace lathelier {
namespace {

TEST(Recipe, KeepsMethodAndMasterAndLeavesOutThePart)
{
    project::Project project;
    project.panels["compare"].inputs["reference"].path = "/scans/master.ply";
    project.panels["compare"].inputs["copy"].path = "/scans/part_17.ply";
    project.panels["compare"].parameters = {{"tolerance_mm", 0.05}};
    project.panels["spindle"].inputs["record"].path = "/records/a.csv";
    project.panels["spindle"].inputs["record.2"].path = "/records/b.csv";
    project.panels["spindle"].inputs["recorder"].path = "/records/recorder.csv";
    project.others.resize(1);
    project.others[0].panels["compare"].inputs["copy"].path = "/scans/next.ply";
    project.title_block = {{"part", std::string("Shaft")}, {"serial", std::string("17")}};
    const project::Project recipe = recipeOf(project, {{"compare", {"copy"}}, {"spindle", {"record"}}});
    EXPECT_TRUE(recipe.recipe);
    ASSERT_EQ(recipe.others.size(), 1u);
    EXPECT_TRUE(recipe.others[0].panels.at("compare").inputs.empty());
    EXPECT_EQ(recipe.panels.at("compare").inputs.count("reference"), 1u);
    EXPECT_EQ(recipe.panels.at("compare").inputs.count("copy"), 0u);
    EXPECT_EQ(*find(recipe.panels.at("compare").parameters, "tolerance_mm"), Value(0.05));
    EXPECT_EQ(recipe.panels.at("spindle").inputs.size(), 1u);
    EXPECT_EQ(find(recipe.title_block, "serial"), nullptr);
    EXPECT_NE(find(recipe.title_block, "part"), nullptr);
    EXPECT_EQ(project::parseProject(project::toJsonText(recipe, "/scans"), "/scans"), recipe);
}

}  // namespace
}  // namespace lathelier
