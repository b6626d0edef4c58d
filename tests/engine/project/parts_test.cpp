// The list of parts: one is shown, none is lost or changed by showing another.
#include "engine/project/parts.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>

namespace lathelier {
namespace {

using project::Project;

/// Parts "0", "1"… each with a parameter that names it; the last is shown.
Project projectOf(std::size_t count)
{
    Project project;
    project.name = "0";
    for (std::size_t i = 1; i < count; ++i) project::addPart(project, std::to_string(i));
    for (project::Part* part : project::partsOf(project)) part->panels["compare"].parameters = {{"of", part->name}};
    return project;
}

void isWhole(const Project& project)
{
    RC_ASSERT(project.place <= project.others.size());
    for (const project::Part* part : project::partsOf(project))
        if (const auto panel = part->panels.find("compare"); panel != part->panels.end())
            RC_ASSERT(*find(panel->second.parameters, "of") == Value(part->name));
}

TEST(Parts, ShowingAnotherKeepsTheOrder)
{
    Project project = projectOf(3);
    EXPECT_EQ(project::partNames(project), (std::vector<std::string>{"0", "1", "2"}));
    EXPECT_EQ(project.place, 2U);
    const Project before = project;
    for (const std::size_t index : {0U, 1U, 2U, 1U, 0U}) {
        project::showPart(project, index);
        EXPECT_EQ(project.name, std::to_string(index));
        EXPECT_EQ(project::partNames(project), project::partNames(before));
    }
    project::showPart(project, 7);  // there is none
    EXPECT_EQ(project.name, "0");
    project::showPart(project, 2);
    EXPECT_EQ(project, before);
}

TEST(Parts, ANewOneIsEmptyAndShownUnderANameOfItsOwn)
{
    Project project = projectOf(2);
    project.shop = {{"machine", std::string("m")}};
    project::addPart(project, "1");
    EXPECT_EQ(project.name, "1 (2)");
    EXPECT_TRUE(project.panels.empty());
    EXPECT_EQ(project.shop.size(), 1U);  // of the project, not of a part
    project::renamePart(project, 0, "1");
    EXPECT_EQ(project::partNames(project), (std::vector<std::string>{"1 (3)", "1", "1 (2)"}));
    project::renamePart(project, 1, "1");  // its own name
    EXPECT_EQ(project::partNames(project)[1], "1");
}

TEST(Parts, InPlaceOfARemovedOneItsNeighbourIsShown)
{
    Project project = projectOf(3);
    project::showPart(project, 1);
    project::removePart(project, 1);
    EXPECT_EQ(project.name, "2");
    project::removePart(project, 1);  // the last in the list
    EXPECT_EQ(project.name, "0");
    EXPECT_EQ(project.place, 0U);
    project::removePart(project, 0);
    EXPECT_EQ(project::partNames(project), std::vector<std::string>{""});
    EXPECT_TRUE(project.panels.empty());
}

TEST(Parts, NoSequenceOfStepsMixesThem)
{
    rc::check([] {
        Project project = projectOf(4);
        std::vector<std::string> names = project::partNames(project);
        for (const int step : *rc::gen::container<std::vector<int>>(rc::gen::inRange(0, 40))) {
            const auto index = static_cast<std::size_t>(step % 10);
            if (step < 20) {
                project::showPart(project, index);
            } else if (names.size() > 1 && index < names.size()) {
                project::removePart(project, index);
                names.erase(names.begin() + static_cast<std::ptrdiff_t>(index));
            }
            isWhole(project);
            RC_ASSERT(project::partNames(project) == names);
        }
    });
}

}  // namespace
}  // namespace lathelier
