// Inputs that nobody gave, from the shop: which are filled, with what, and what is said of it.
#include "engine/shop/shop_fill.h"

#include <gtest/gtest.h>

#include "engine/cam/job_item.h"
#include "engine/cam/task/check_task.h"
#include "engine/cam/task/turn_task.h"
#include "engine/deflection/deflection_task.h"
#include "engine/deflection/setup_item.h"
#include "engine/deflection/toolpath_task.h"
#include "engine/gcode/program_item.h"
#include "engine/receptance/spindle/spindle_item.h"
#include "engine/receptance/task/modes_task.h"
#include "engine/receptance/task/shaft_task.h"
#include "engine/shaft/shaft_item.h"
#include "engine/shop/shop_codes.h"
#include "engine/shop/shop_job.h"
#include "engine/shop/shop_library.h"
#include "engine/stability/task/lobes_task.h"

namespace lathelier::shop {
namespace {

using Names = std::vector<std::string>;

Shaft pin(double length_mm = 80)
{
    Shaft part;
    part.name = "pin";
    ShaftSegment row;
    row.length_mm = length_mm;
    row.start_diameter_mm = row.end_diameter_mm = 29;
    part.segments = {row};
    return part;
}

project::PanelState withShaft(const char* role = "shaft")
{
    project::PanelState state;
    state.inputs[role].item = "pin";
    state.items[role] = {shaftItem, toValues(pin()), {}};
    return state;
}

/// What was noted, by the first word of each entry.
Names named(const Notes& notes)
{
    Names all;
    for (const Note& note : notes) {
        EXPECT_EQ(note.code, notes::ofShop);
        all.push_back(std::get<Text>(*find(note.values, "what")).english);
    }
    return all;
}

Names filled(project::PanelState& state, const task::Task& task, const Shaft* part = nullptr)
{
    Notes notes;
    fillFromShop(state, task, shopOf({}), part, notes);
    return named(notes);
}

TEST(ShopFill, TurningGetsJobMachineAndControl)
{
    project::PanelState state = withShaft();
    const Shaft part = pin();
    EXPECT_EQ(filled(state, cam::turnTask(), &part), (Names{"Lathe", "Chuck", "Set of tools", "Material"}));
    EXPECT_EQ(state.inputs.at("job").item, jobName);
    const auto job = cam::jobOf(state.items.at("job").values);
    ASSERT_TRUE(job);
    EXPECT_TRUE(*job == jobOf(shopOf({}), part));
    EXPECT_EQ(state.items.at("job").kind, cam::jobItem);
    EXPECT_EQ(state.items.at("spindle").kind, receptance::spindleItem);
    EXPECT_EQ(*find(state.parameters, "post"), Value(std::string("fanuc_a")));
    EXPECT_EQ(state.inputs.at("shaft").item, "pin");
}

TEST(ShopFill, WhatIsGivenStays)
{
    project::PanelState state = withShaft();
    state.inputs["job"].path = "job.json";
    state.inputs["spindle"].path = "spindle.json";
    set(state.parameters, "post", std::string("grbl"));
    const project::PanelState before = state;
    const Shaft part = pin();
    EXPECT_TRUE(filled(state, cam::turnTask(), &part).empty());
    EXPECT_TRUE(state == before);
}

TEST(ShopFill, ASpindleUsesTheChuckOnly)
{
    project::PanelState state = withShaft();
    EXPECT_EQ(filled(state, receptance::shaftTask()), Names{"Chuck"});
    const auto spindle = receptance::spindleOf(state.items.at("spindle").values);
    ASSERT_TRUE(spindle && spindle->springs());
    EXPECT_EQ(spindle->springs()->radial_N_mm, 14850);
    EXPECT_EQ(state.inputs.size(), 2U);
}

TEST(ShopFill, AShaftThatIsHeldOtherwiseGetsNoSpindle)
{
    project::PanelState state = withShaft();
    set(state.parameters, "hold", std::string("clamped"));
    EXPECT_TRUE(filled(state, receptance::shaftTask()).empty());
    EXPECT_EQ(state.inputs.count("spindle"), 0U);
}

TEST(ShopFill, AMeasuredResponseGetsNoSpindle)
{
    for (const task::Task* task : {&stability::lobesTask(), &receptance::modesTask()}) {
        project::PanelState state;
        state.inputs["frf"].path = "frf.csv";
        state.inputs["response"].path = "frf.csv";
        const project::PanelState before = state;
        EXPECT_TRUE(filled(state, *task).empty()) << task->key;
        EXPECT_TRUE(state == before) << task->key;
    }
    project::PanelState state = withShaft();
    EXPECT_EQ(filled(state, stability::lobesTask()), Names{"Chuck"});
    state = withShaft();
    EXPECT_EQ(filled(state, receptance::modesTask()), Names{"Chuck"});
}

TEST(ShopFill, ToolsOfTheFormAreTheJob)
{
    project::PanelState state = withShaft();
    Rows tools;
    tools.rows.push_back({toValues(shopOf({}).tools.value.tools.front())});
    set(state.parameters, "tools", tools);
    const Shaft part = pin();
    filled(state, cam::turnTask(), &part);
    EXPECT_EQ(state.inputs.count("job"), 0U);
    EXPECT_FALSE(wantsPart(state, cam::turnTask()));
}

TEST(ShopFill, WithoutAPartThereIsNoJob)
{
    project::PanelState state;
    EXPECT_TRUE(wantsPart(state, cam::checkTask()));
    EXPECT_TRUE(filled(state, cam::checkTask()).empty());
    EXPECT_TRUE(state.inputs.empty());
    const Shaft part = pin();
    EXPECT_EQ(filled(state, cam::checkTask(), &part), (Names{"Lathe", "Chuck", "Set of tools", "Material"}));
    EXPECT_FALSE(wantsPart(state, cam::checkTask()));
}

TEST(ShopFill, ASetUpBringsTheBarOfTheJob)
{
    project::PanelState state;
    state.inputs["program"].path = "p.nc";
    const Shaft part = pin(240);  // slender: held by the tailstock too
    EXPECT_EQ(filled(state, deflection::deflectionTask(), &part),
              (Names{"Chuck", "Tailstock", "Set of tools", "Material"}));
    const auto held = deflection::setupOf(state.items.at("setup").values);
    ASSERT_TRUE(held && held->stock);
    EXPECT_DOUBLE_EQ(held->stock->length_mm(), 1 + 240 + 5 + 3);
    EXPECT_EQ(held->setup.z_zero_mm, 1);
    ASSERT_TRUE(held->setup.tailstock);
    EXPECT_EQ(held->setup.tailstock->radial_N_mm, 5500);
    EXPECT_EQ(state.inputs.count("spindle"), 0U);  // the set-up states the chuck
}

TEST(ShopFill, AStockThatIsGivenKeepsItsZero)
{
    project::PanelState state = withShaft();
    const Shaft stock = pin();
    filled(state, deflection::deflectionTask(), &stock);
    const auto held = deflection::setupOf(state.items.at("setup").values);
    ASSERT_TRUE(held);
    EXPECT_FALSE(held->stock);
    EXPECT_EQ(held->setup.z_zero_mm, 0);
}

TEST(ShopFill, AProgramWithItsBarKeepsIt)
{
    gcode::ProgramItem program;
    program.text = "M30";
    program.stock = pin();
    project::PanelState state;
    state.inputs["program"].item = "planned";
    state.items["program"] = {gcode::programItem, gcode::toValues(program), {}};
    const Shaft part = pin();
    filled(state, deflection::deflectionTask(), &part);
    const auto held = deflection::setupOf(state.items.at("setup").values);
    ASSERT_TRUE(held);
    EXPECT_FALSE(held->stock);
}

TEST(ShopFill, AnEntryIsNotedOnceAndOwnOnesAreNot)
{
    Shop shop = shopOf({});
    shop.chuck.is_assumed = false;
    Notes notes;
    const Shaft part = pin();
    for (int run = 0; run < 2; ++run) {
        project::PanelState state = withShaft();
        fillFromShop(state, cam::turnTask(), shop, &part, notes);
    }
    EXPECT_EQ(named(notes), (Names{"Lathe", "Set of tools", "Material"}));
    for (const Note& note : notes) EXPECT_EQ(note.code.role, NoteRole::Assumed);
}

TEST(ShopFill, TasksThatTakeNoneAreLeftAlone)
{
    EXPECT_TRUE(takesShop(cam::turnTask()));
    EXPECT_TRUE(takesShop(stability::lobesTask()));
    EXPECT_TRUE(takesShop(deflection::toolpathTask()));
    task::Task other;
    other.inputs = {{"scan", "", "SCAN", {}, {}}};
    EXPECT_FALSE(takesShop(other));
    project::PanelState state;
    EXPECT_TRUE(filled(state, other).empty());
    EXPECT_TRUE(state == project::PanelState{});
}

TEST(ShopFill, APartThatDoesNotFitIsRefused)
{
    project::PanelState state = withShaft();
    const Shaft part = pin(1500);
    Notes notes;
    try {
        fillFromShop(state, cam::turnTask(), shopOf({}), &part, notes);
        ADD_FAILURE() << "1500 mm on a lathe of 1000 mm";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), errors::partLargerThanLathe);
    }
}

}  // namespace
}  // namespace lathelier::shop
