// Jobs and set-ups that are items of the project, as the files of its chain.
#include "engine/chain/of_project/project_chain.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "engine/cam/job_file.h"
#include "engine/cam/job_item.h"
#include "engine/chain/of_project/settled_chain.h"
#include "engine/deflection/setup_file.h"
#include "engine/io/file.h"
#include "engine/io/shaft/shaft_file.h"
#include "engine/shop/shop_file.h"
#include "engine/task/edited_segments.h"
#include "engine/walk/part_places.h"
#include "engine/walk/shop_supply.h"
#include "tests/scratch_folder.h"

namespace lathelier::chain {
namespace {

cam::Job barJob()
{
    cam::Job job;
    job.title = "pin";
    job.stock.diameter_mm = 40;
    job.setup.chuck_face_z_mm = 110;
    cam::JobTool tool;
    tool.number = 1;
    tool.insert = "CNMG 120408";
    tool.holder_name = "PCLNL 2525M12";
    tool.settle();
    job.tools = {tool};
    job.cutting.rough = {2, 0.25, 180, 0.3};
    job.cutting.finish = {0.1, 200};
    return job;
}

deflection::HeldSetup heldSetup()
{
    deflection::HeldSetup held;
    held.setup.material.cutting = {1748.5, 99.2, 703, 92.5};
    held.setup.tool.corner_radius_mm = 0.8;
    held.setup.tool.entering_angle_deg = 95;
    held.setup.chuck = {33000, 0, 6.87e7, 0};
    ShaftSegment bar;
    bar.length_mm = 110;
    bar.start_diameter_mm = bar.end_diameter_mm = 40;
    held.stock.emplace().segments = {bar};
    return held;
}

/// A project whose turning panel has a job and whose deflection panel has a set-up of its items.
project::Project itemsOnly(const std::string& folder)
{
    project::Project project;
    project.items["the job"] = {cam::jobItem, cam::valuesOf(barJob()), {}};
    project.items["the set-up"] = {deflection::setupItem, deflection::valuesOf(heldSetup()), {}};
    project.panels["turning"].inputs["job"].item = "the job";
    project.panels["deflection"].inputs["setup"].item = "the set-up";
    ChainSettings settings;
    settings.folder = folder;
    project.panels[chainKey].parameters = toValues(settings);
    return project;
}

void write(const AskedChain& asked)
{
    for (const MadeInput& made : asked.made) {
        std::filesystem::create_directories(std::filesystem::path(made.path).parent_path());
        io::writeFile(made.path, made.text);
    }
}

deflection::SetupFile setupAt(const std::string& path)
{
    io::InputFiles inputs;
    const Values reading;
    const Progress progress;
    return deflection::loadSetup({path, inputs.open(path), reading, inputs, progress});
}

TEST(ProjectChain, ItemsAreWrittenForTheChain)
{
    const ScratchFolder folder;
    const AskedChain asked = askedChain(itemsOnly(folder.string()));
    EXPECT_EQ(asked.question.shop, "built-in");  // makes what no panel gives
    project::Project with_shop = itemsOnly(folder.string());
    with_shop.shop = {{shop::shopTextKey, std::string("{}")}};
    EXPECT_EQ(askedChain(with_shop).question.shop_text, "{}");
    write(asked);
    Notes notes;
    const io::FileBytes job(asked.question.job);
    EXPECT_TRUE(cam::readJob(std::string(job.view()), notes) == barJob());
    const deflection::SetupFile setup = setupAt(asked.question.setup);
    ASSERT_TRUE(setup.stock);
    EXPECT_TRUE(*setup.stock == *heldSetup().stock);
    EXPECT_EQ(setup.setup.chuck.radial_N_mm, 33000);
    EXPECT_EQ(setup.setup.tool, heldSetup().setup.tool);
}

TEST(ProjectChain, ChangesOfTheSetUpKeepItsStock)
{
    const ScratchFolder folder;
    project::Project project = itemsOnly(folder.string());
    set(project.panels["deflection"].parameters, "changed_chuck_N_mm", 20000.0);
    Stores stores;
    const AskedChain asked = settled(askedChain(project), walk::Walk(project, {}, {}, nullptr), stores, {});
    write(asked);
    const deflection::SetupFile setup = setupAt(asked.question.setup);
    EXPECT_EQ(setup.setup.chuck.radial_N_mm, 20000);
    ASSERT_TRUE(setup.stock);
    EXPECT_TRUE(*setup.stock == *heldSetup().stock);
}

TEST(ProjectChain, AFormThatWasChangedFromAnItemIsTheJob)
{
    const ScratchFolder folder;
    project::Project project = itemsOnly(folder.string());
    cam::Job changed = barJob();
    changed.cutting.finish.cutting_speed_m_min = 150;
    project.panels["turning"].parameters = toValues(changed);
    set(project.panels["turning"].parameters, "job_of", std::string("item the job"));
    const AskedChain asked = askedChain(project);
    write(asked);
    Notes notes;
    const io::FileBytes job(asked.question.job);
    EXPECT_EQ(cam::readJob(std::string(job.view()), notes).cutting.finish.cutting_speed_m_min, 150);
}

/// The window's program is of the edited drawing; the chain's is of the same.
TEST(ProjectChain, AnEditedDrawingIsThatOfTheChain)
{
    const ScratchFolder folder;
    project::Project project;
    set(project.panels[chainKey].parameters, folderKey, folder.string());
    const std::vector<ShaftSegment> edited{{40, 20, 20, 0, {}, ""}, {30, 31, 31, 0, {}, ""}};
    set(project.panels["drawing"].parameters, task::segmentsKey, task::rowsOf(edited));
    auto stores = std::make_shared<Stores>();
    const walk::Walk walk(project, walk::partPlaces(), walk::supplyOf({}), stores);
    EXPECT_TRUE(askedChain(project).question.drawing.empty());
    const AskedChain asked = settled(askedChain(project), walk, *stores, {});
    ASSERT_FALSE(asked.question.drawing.empty());
    write(asked);
    const io::FileBytes drawn(asked.question.drawing);
    Notes notes;
    const Shaft shaft = io::readShaft(std::string(drawn.view()), notes);
    ASSERT_EQ(shaft.segments.size(), 2U);
    EXPECT_EQ(shaft.segments[1].start_diameter_mm, 31);
}

}  // namespace
}  // namespace lathelier::chain
