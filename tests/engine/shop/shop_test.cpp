// A shop: its tables, the one that is chosen, and what follows from it for a part.
#include <gtest/gtest.h>

#include "engine/cam/job_library.h"
#include "engine/cam/job_rules.h"
#include "engine/io/json/json_document.h"
#include "engine/shop/bar_sizes.h"
#include "engine/shop/shop_codes.h"
#include "engine/shop/shop_file.h"
#include "engine/shop/shop_job.h"

namespace lathelier::shop {
namespace {

/// A row of a shaft or of a bore.
template <class Row>
Row straight(double length_mm, double diameter_mm)
{
    Row row;
    row.length_mm = length_mm;
    row.start_diameter_mm = row.end_diameter_mm = diameter_mm;
    return row;
}

/// Half of it as thick as the other half.
Shaft stepped(double length_mm, double diameter_mm)
{
    Shaft part;
    part.name = "pin";
    part.segments = {straight<ShaftSegment>(length_mm / 2, diameter_mm / 2),
                     straight<ShaftSegment>(length_mm / 2, diameter_mm)};
    return part;
}

std::string codeOf(const std::function<void()>& work)
{
    try {
        work();
    } catch (const Error& error) {
        return error.code().key;
    }
    return {};
}

TEST(BarSizes, NextOneIsTaken)
{
    EXPECT_EQ(barFor_mm(30), 30);
    EXPECT_EQ(barFor_mm(30.001), 32);
    EXPECT_EQ(barFor_mm(1), 10);
    EXPECT_FALSE(barFor_mm(250.1));
    EXPECT_TRUE(std::is_sorted(barDiameters_mm().begin(), barDiameters_mm().end()));
}

TEST(ShopLibrary, EveryChoiceOfTheBuiltInOneMakesAJob)
{
    const ShopLibrary& library = shopLibrary();
    ASSERT_FALSE(library.lathes.empty());
    for (const auto& lathe : library.lathes)
        for (const auto& tools : library.tool_sets)
            for (const auto& material : library.materials) {
                ShopChoice choice;
                choice.lathe = lathe.key;
                choice.tools = tools.key;
                choice.material = material.key;
                const Shaft part = stepped(80, 28);
                const cam::Job job = cam::withLibrary(jobOf(shopOf(choice), part));
                EXPECT_NO_THROW(cam::checkTools(job)) << tools.key;
                EXPECT_NO_THROW(cam::checkUses(job)) << tools.key;
                EXPECT_NO_THROW(cam::checkStock(job, part));
                EXPECT_EQ(job.max_rpm, lathe.value.max_rpm);
                EXPECT_EQ(job.cutting.material, material.value.name);
                EXPECT_FALSE(material.source.empty());
            }
}

TEST(ShopJob, BarChuckAndBladeFollowFromThePart)
{
    const cam::Job job = jobOf(shopOf({}), stepped(80, 29));
    EXPECT_EQ(job.stock.diameter_mm, 32);  // 29 + 2 is 31, the next listed bar is 32
    EXPECT_EQ(job.stock.face_allowance_mm, 1);
    EXPECT_TRUE(job.part_off);  // a blade of 35 mm reaches beyond the axis of a bar of 32 mm
    EXPECT_EQ(job.setup.chuck_face_z_mm, 80 + 5 + 3);
    EXPECT_FALSE(job.setup.tailstock);  // mean diameter 21.75, 3.7 times as long

    const cam::Job thick = jobOf(shopOf({}), stepped(80, 88));
    EXPECT_EQ(thick.stock.diameter_mm, 90);
    EXPECT_FALSE(thick.part_off);  // 45 mm to the axis
    EXPECT_EQ(thick.setup.chuck_face_z_mm, 80 + 5);
}

TEST(ShopJob, SlenderPartsGetTheTailstockUnlessTheyAreBored)
{
    Shaft part = stepped(240, 24);
    EXPECT_TRUE(jobOf(shopOf({}), part).setup.tailstock);
    ShopChoice without;
    without.tailstock.clear();
    EXPECT_FALSE(jobOf(shopOf(without), part).setup.tailstock);
    part.bores.push_back({ShaftEnd::Free, {straight<BoreSegment>(20, 8)}});
    EXPECT_FALSE(jobOf(shopOf({}), part).setup.tailstock);
}

TEST(ShopJob, SetUpHasTheSpringsAndTheFinishingTool)
{
    const Shop shop = shopOf({});
    const cam::Job job = jobOf(shop, stepped(240, 24));
    const deflection::TurningSetup setup = setupOf(shop, job).setup;
    EXPECT_EQ(setup.tool.corner_radius_mm, 0.4);
    EXPECT_EQ(setup.tool.entering_angle_deg, 93);
    EXPECT_EQ(setup.chuck.radial_N_mm, 14850);
    EXPECT_EQ(setup.material.cutting.K_tc_N_mm2, 1748.5);
    EXPECT_EQ(setup.material.elastic.elastic_modulus_MPa, 210000);
    ASSERT_TRUE(setup.tailstock);
    EXPECT_EQ(setup.tailstock->radial_N_mm, 5500);
    ASSERT_TRUE(chuckFaceOf(shop).springs());
    EXPECT_EQ(chuckFaceOf(shop).springs()->radial_N_mm, 14850);
}

TEST(ShopJob, TheBarOfTheSetUpEndsAtTheChuckFace)
{
    const Shop shop = shopOf({});
    const cam::Job job = jobOf(shop, stepped(80, 29));
    const deflection::HeldSetup held = setupOf(shop, job);
    ASSERT_TRUE(held.stock);
    EXPECT_DOUBLE_EQ(held.stock->length_mm(), 1 + 80 + 5 + 3);  // face, part, clearance, blade
    EXPECT_EQ(held.stock->segments.front().start_diameter_mm, 32);
    EXPECT_EQ(held.setup.z_zero_mm, 1);
    const deflection::TurningSetup of_stock = setupOfStock(shop, stepped(240, 24));
    EXPECT_EQ(of_stock.z_zero_mm, 0);
    EXPECT_TRUE(of_stock.tailstock);
    EXPECT_FALSE(setupOfStock(shop, stepped(80, 29)).tailstock);
}

TEST(ShopJob, AnEndTooThinForTheCentreHoleHasNoTailstock)
{
    // 120 mm of 10 mm: 12 times as long as thick; the end of 6.9 mm leaves less than 1 mm around a hole of 5 mm.
    Shaft part;
    part.segments = {straight<ShaftSegment>(5, 6.9), straight<ShaftSegment>(115, 10)};
    EXPECT_FALSE(jobOf(shopOf({}), part).setup.tailstock);
    part.segments.front() = straight<ShaftSegment>(5, 7.1);
    EXPECT_TRUE(jobOf(shopOf({}), part).setup.tailstock);
}

TEST(ShopJob, WhatDoesNotFitIsRefused)
{
    EXPECT_EQ(codeOf([] { jobOf(shopOf({}), stepped(80, 260)); }), errors::partLargerThanBars.key);
    EXPECT_EQ(codeOf([] { jobOf(shopOf({}), stepped(1200, 60)); }), errors::partLargerThanLathe.key);
    ShopChoice small;
    small.lathe = "small";
    EXPECT_EQ(codeOf([&] { jobOf(shopOf(small), stepped(80, 165)); }), errors::partLargerThanLathe.key);
    EXPECT_EQ(codeOf([] { jobOf(shopOf({}), Shaft{}); }), "shaft_empty");
    ShopChoice unknown;
    unknown.chuck = "nowhere";
    EXPECT_EQ(codeOf([&] { shopOf(unknown); }), errors::shopEntryUnknown.key);
}

TEST(ShopJob, BuiltInEntriesAreAssumedAndOwnOnesAreNot)
{
    constexpr UsedEntries all{true, true, true, true, true};
    Notes of_built_in, of_own, notes;
    noteAssumed(shopOf({}), all, of_built_in);
    noteAssumed(shopOf({}), all, of_built_in);
    EXPECT_EQ(of_built_in.size(), 5U);  // each once
    const StatedShop own = readShop(
        R"({"choice": {"lathe": "hall 3"}, "lathes": [{"key": "hall 3", "max_rpm": 2500, "source": "its plate"}]})",
        notes);
    EXPECT_TRUE(notes.empty());
    const Shop shop = own.shop();
    EXPECT_EQ(shop.lathe.value.max_rpm, 2500);
    EXPECT_EQ(shop.lathe.value.name, "hall 3");
    noteAssumed(shop, all, of_own);
    EXPECT_EQ(of_own.size(), 4U);
}

TEST(ShopFile, IsReadAsItIsWritten)
{
    Notes notes;
    StatedShop stated;
    stated.choice.material = "42crmo4";
    stated.choice.tailstock.clear();
    ShopEntry<Chuck> chuck;
    chuck.key = "collet";
    chuck.source = "tap test";
    chuck.value.springs.radial_N_mm = 23456.789;
    stated.own.chucks.push_back(chuck);
    stated.own.tool_sets = {shopLibrary().tool_sets.front()};
    stated.choice.chuck = "collet";
    const StatedShop read = readShop(shopText(stated), notes);
    EXPECT_TRUE(notes.empty());
    EXPECT_EQ(read.choice, stated.choice);
    EXPECT_EQ(shopText(read), shopText(stated));
    EXPECT_EQ(read.shop().chuck.value.springs.radial_N_mm, 23456.789);
    EXPECT_FALSE(read.shop().tailstock);
}

TEST(ShopFile, AnEntryThatIsAsBuiltInStaysAssumed)
{
    StatedShop stated;
    stated.own.chucks = {*std::find_if(shopLibrary().chucks.begin(), shopLibrary().chucks.end(),
                                       [](const auto& entry) { return entry.key == "papers"; })};
    Notes notes;
    EXPECT_TRUE(readShop(shopText(stated), notes).shop().chuck.is_assumed);
    stated.own.chucks.front().value.springs.radial_N_mm += 1;
    EXPECT_FALSE(readShop(shopText(stated), notes).shop().chuck.is_assumed);
}

TEST(ShopFile, FaultsHaveTheirPlace)
{
    Notes notes;
    const auto lineOf = [&](const std::string& json) -> std::int64_t {
        try {
            readShop(json, notes);
        } catch (const Error& error) {
            const Value* const line = find(error.values(), "line");
            return line ? std::get<std::int64_t>(*line) : 0;
        }
        return -1;
    };
    EXPECT_EQ(lineOf("{\n\"lathes\": [\n{\"key\": \"a\", \"max_rpm\": -5, \"source\": \"\"}]}"), 3);
    EXPECT_EQ(lineOf("{\n\"lathes\": [\n{\"key\": \"a\", \"source\": \"\"}]}"), 3);  // max_rpm is required
    EXPECT_EQ(lineOf("[]"), 1);
    EXPECT_EQ(lineOf("{\"springs\": {\"radial_N_mm\": 14850}}"), 1);  // another kind of file
    EXPECT_EQ(lineOf("{\"choice\": {\"lathe\": 5}}"), 1);
    notes.clear();
    readShop("{\"choice\": {\"lathee\": \"small\"}}", notes);
    ASSERT_EQ(notes.size(), 1U);
    EXPECT_STREQ(notes.front().code.key, "unknown_key");
}

}  // namespace
}  // namespace lathelier::shop
