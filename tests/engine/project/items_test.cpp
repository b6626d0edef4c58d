// Items of a project, and a project file of every format version.
#include <gtest/gtest.h>

#include "engine/project/migration.h"
#include "engine/project/project.h"
#include "engine/project/project_json.h"
#include "engine/shaft/shaft.h"

namespace lathelier {
namespace {

std::string keptProject(int version)
{
    return LATHELIER_SOURCE_DIR "/tests/data/projects/version_" + std::to_string(version) + ".lathelier";
}

TEST(ProjectVersions, EachHasAFileThatIsRead)
{
    for (int version = 1; version <= project::projectVersion; ++version) {
        SCOPED_TRACE(version);
        const project::Project project = project::readProject(keptProject(version)).project;
        EXPECT_EQ(project.title, "Journal 40 h6");
        EXPECT_EQ(*find(project.panels.at("compare").parameters, "tolerance_mm"), Value(0.05));
        EXPECT_TRUE(project.panels.at("compare").inputs.at("copy").synthetic);
        EXPECT_EQ(project.report, std::vector<std::string>{"compare"});
        EXPECT_EQ(project::parseProject(project::toJsonText(project, "/scans"), "/scans"), project);
    }
}

TEST(ProjectVersions, TheFourthHasATitleBlock)
{
    const project::Project project = project::readProject(keptProject(4)).project;
    EXPECT_EQ(*find(project.title_block, "drawing"), Value(std::string("LT-0042 B")));
    EXPECT_TRUE(project::readProject(keptProject(3)).project.title_block.empty());
}

TEST(ProjectVersions, TheSixthHasTheKeysOfTheCommandLine)
{
    const project::Project former = project::readProject(keptProject(5)).project;
    const project::Project present = project::readProject(keptProject(6)).project;
    EXPECT_EQ(former.panels.at("lobes").parameters, present.panels.at("lobes").parameters);
    EXPECT_NE(find(present.panels.at("lobes").parameters, "mode"), nullptr);
    EXPECT_EQ(former.panels.at("shaft").parameters, present.panels.at("shaft").parameters);
    EXPECT_NE(find(present.panels.at("shaft").parameters, "library_material"), nullptr);
    EXPECT_EQ(former.panels.at("speed").parameters, present.panels.at("speed").parameters);
    EXPECT_EQ(*find(present.panels.at("speed").parameters, "range_m_min"), Value(std::vector<Interval>{{120, 400}}));
}

TEST(ProjectVersions, TheSeventhHasPartsAndAShop)
{
    const project::Project project = project::readProject(keptProject(7)).project;
    EXPECT_EQ(project.place, 1U);
    EXPECT_EQ(project.name, "Journal");
    ASSERT_EQ(project.others.size(), 1U);
    EXPECT_EQ(project.others[0].name, "Pin 12");
    EXPECT_EQ(project.others[0].panels.count("recognise"), 1U);
    EXPECT_EQ(*find(project.shop, "machine"), Value(std::string("lathe_small")));
    const project::Project former = project::readProject(keptProject(6)).project;
    EXPECT_TRUE(former.others.empty());
    EXPECT_EQ(former.panels, project.panels);
    EXPECT_EQ(former.items, project.items);
    EXPECT_EQ(former.views, project.views);
    EXPECT_EQ(former.title_block, project.title_block);
}

TEST(ProjectItems, AreReadByTheirDescription)
{
    const project::Project project = project::readProject(keptProject(2)).project;
    ASSERT_EQ(project.items.count("drawn shaft"), 1U);
    const project::Item& item = project.items.at("drawn shaft");
    EXPECT_EQ(item.kind, "shaft");
    EXPECT_EQ(item.origin.panel, "shaft");
    const Shaft shaft = fromValues<Shaft>(item.values);
    ASSERT_EQ(shaft.segments.size(), 2U);
    EXPECT_EQ(shaft.segments[1].role, "collar");
    EXPECT_FALSE(shaft.material);
    EXPECT_EQ(project.panels.at("compare").inputs.at("reference").item, "drawn shaft");
}

TEST(ProjectItems, KnowWhetherTheirOriginChanged)
{
    project::Project project;
    project::PanelState& panel = project.panels["shaft"];
    panel.parameters = {{"bore_mm", 5.0}};
    panel.inputs["scan"] = {.path = "/scans/a.ply", .import = {}, .sha256 = "ab", .synthetic = false};
    project::Item item{"shaft", toValues(Shaft{}), project::originOf(project, "shaft", "0.1.0")};
    EXPECT_EQ(item.origin.inputs, std::vector<std::string>{"ab"});
    EXPECT_FALSE(project::isOutdated(project, item));
    project.panels["shaft"].inputs["scan"].path = "/elsewhere/a.ply";  // the same content
    EXPECT_FALSE(project::isOutdated(project, item));
    project.panels["shaft"].parameters = {{"bore_mm", 6.0}};
    EXPECT_TRUE(project::isOutdated(project, item));
    item.origin.panel.clear();  // made by no panel
    EXPECT_FALSE(project::isOutdated(project, item));
}

}  // namespace
}  // namespace lathelier
