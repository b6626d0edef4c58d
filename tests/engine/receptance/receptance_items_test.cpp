// Shafts, spindles and responses as items of the project: round trip, and rejection of other values.
#include <gtest/gtest.h>

#include <limits>

#include "../../scratch_folder.h"
#include "../core/code_of_error.h"
#include "engine/core/frf_item.h"
#include "engine/core/item_codes.h"
#include "engine/core/item_numbers.h"
#include "engine/project/project.h"
#include "engine/receptance/spindle/spindle_item.h"
#include "engine/shaft/shaft_item.h"
#include "made_spindle.h"

namespace lathelier::receptance {
namespace {

Shaft drilled()
{
    Shaft shaft = newPart();
    shaft.name = "drilled";
    shaft.segments[1].bore_diameter_mm = 5;
    shaft.segments[2].arc_radius_mm = -200;
    shaft.segments[2].role = "groove";
    return shaft;
}

Frf response()
{
    Frf frf;
    frf.name = "tip";
    frf.frequency_hz = {0, 100, 200};
    frf.value = {{1, 0}, {2, -1}, {-1, -0.5}};
    return frf;
}

TEST(Items, OfShaftsComeBack)
{
    Shaft shaft = drilled();
    EXPECT_EQ(shaftOf(lathelier::toValues(shaft)), shaft);
    shaft.material.reset();
    EXPECT_EQ(shaftOf(lathelier::toValues(shaft)), shaft);
    shaft.segments.clear();
    EXPECT_EQ(shaftOf(lathelier::toValues(shaft)), std::nullopt);
    EXPECT_EQ(shaftOf({}), std::nullopt);
    EXPECT_EQ(shaftOf({{"segments", std::string("three")}}), std::nullopt);
}

TEST(Items, OfResponsesComeBack)
{
    Frf frf = response();
    for (const bool coherent : {false, true}) {
        if (coherent) frf.coherence = {1, 0.99, 0.5};
        const auto back = frfOf(lathelier::toValues(frf));
        ASSERT_TRUE(back);
        EXPECT_EQ(back->name, "tip");
        EXPECT_EQ(back->quantity, FrfQuantity::Receptance);
        EXPECT_EQ(back->frequency_hz, frf.frequency_hz);
        EXPECT_EQ(back->value, frf.value);
        EXPECT_EQ(back->coherence, frf.coherence);
    }
}

TEST(Items, ThatAreNoResponsesAreRefused)
{
    const Values good = lathelier::toValues(response());
    const auto with = [&good](const char* key, Value value) {
        Values changed = good;
        set(changed, key, std::move(value));
        return frfOf(changed);
    };
    EXPECT_TRUE(with("real_mm_N", std::vector<std::int64_t>{1, 2, 3}));
    EXPECT_FALSE(with("real_mm_N", std::vector<double>{1, 2}));
    EXPECT_FALSE(with("real_mm_N", std::vector<double>{1, 2, std::numeric_limits<double>::quiet_NaN()}));
    EXPECT_FALSE(with("frequency_hz", std::vector<double>{0, 100, 100}));
    EXPECT_FALSE(with("frequency_hz", std::vector<double>{-1, 100, 200}));
    EXPECT_FALSE(with("coherence", std::vector<double>{1}));
    EXPECT_FALSE(frfOf({}));
}

TEST(Items, OfSpindlesComeBack)
{
    for (const SpindleReceptance& spindle : {springs(), SpindleReceptance{livelySpindle(50, 400, 17)}}) {
        EXPECT_EQ(spindleOf(toValues(spindle)), spindle);
        Values broken = toValues(spindle);
        set(broken, broken.back().first, std::string("unknown"));
        EXPECT_EQ(spindleOf(broken), std::nullopt);
        broken.pop_back();
        EXPECT_EQ(spindleOf(broken), std::nullopt);
    }
}

TEST(Items, LiveThroughTheProjectFile)
{
    project::Project project;
    project.items["shaft"].kind = shaftItem;
    project.items["shaft"].values = lathelier::toValues(drilled());
    project.items["tip"].kind = frfItem;
    project.items["tip"].values = lathelier::toValues(response());
    const SpindleReceptance table{livelySpindle(50, 400, 17)};
    project.items["machine"].kind = spindleItem;
    project.items["machine"].values = toValues(table);
    project.items["springs"].kind = spindleItem;
    project.items["springs"].values = toValues(springs());

    const ScratchFolder folder;
    const std::string path = (folder / "items.lathelier").string();
    project::writeProject(path, project);
    const project::Project back = project::readProject(path).project;
    EXPECT_EQ(shaftOf(back.items.at("shaft").values), drilled());
    const auto tip = frfOf(back.items.at("tip").values);
    ASSERT_TRUE(tip);
    EXPECT_EQ(tip->value, response().value);
    EXPECT_EQ(spindleOf(back.items.at("machine").values), table);
    EXPECT_EQ(spindleOf(back.items.at("springs").values), springs());
}

TEST(Items, OfTooManyLinesAreRefusedBeforeAProjectHoldsThem)
{
    Frf frf;
    frf.frequency_hz.resize(mostItemNumbers + 1);
    frf.value.resize(mostItemNumbers + 1);
    EXPECT_EQ(codeOfError([&frf] { lathelier::toValues(frf); }), errors::linesTooMany);
    SpindleTable table;
    table.frequency_hz.resize(mostItemNumbers + 1);
    EXPECT_EQ(codeOfError([&table] { toValues(SpindleReceptance{table}); }), errors::linesTooMany);
}

}  // namespace
}  // namespace lathelier::receptance
