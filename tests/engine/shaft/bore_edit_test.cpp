// Edits of bores: resulting rows, and depths from the mouth.
#include "engine/shaft/bore_edit.h"

#include <gtest/gtest.h>

#include "engine/shaft/shaft_codes.h"
#include "engine/shaft/shaft_rules.h"

namespace lathelier {
namespace {

ShaftBores stepped()
{
    return {{ShaftEnd::Free, {{10, 20, 20, {}, ""}, {15, 12, 12, {}, ""}}}};
}

TEST(BoreEdit, ABoreIsAddedAndGrowsInward)
{
    ShaftBores bores = addBoreRow({}, ShaftEnd::Chuck, 8, 20);
    ASSERT_EQ(bores.size(), 1U);
    EXPECT_EQ(bores[0].from, ShaftEnd::Chuck);
    EXPECT_EQ(bores[0].segments[0].start_diameter_mm, 8);
    bores = addBoreRow(std::move(bores), ShaftEnd::Chuck, 30, 5);
    ASSERT_EQ(bores[0].segments.size(), 2U);
    EXPECT_EQ(bores[0].segments[1].start_diameter_mm, 8);  // that of the bottom
    EXPECT_EQ(addBoreRow(std::move(bores), ShaftEnd::Free, 6, 5).size(), 2U);
}

TEST(BoreEdit, ARowIsInsertedAndDeleted)
{
    const ShaftBores longer = insertBoreRow(stepped(), 0, 0);
    ASSERT_EQ(longer[0].segments.size(), 3U);
    EXPECT_EQ(longer[0].segments[1].start_diameter_mm, 20);
    EXPECT_EQ(deleteBoreRow(longer, 0, 1), stepped());
    EXPECT_TRUE(deleteBoreRow(deleteBoreRow(stepped(), 0, 0), 0, 0).empty());
}

TEST(BoreEdit, DiametersAndDepths)
{
    EXPECT_EQ(setBoreDiameter(stepped(), 0, 1, 11)[0].segments[1].end_diameter_mm, 11);
    EXPECT_EQ(setBoreDepth(stepped(), 0, 1, 30)[0].segments[1].length_mm, 20);
    EXPECT_EQ(setBoreDepth(stepped(), 0, 0, 7)[0].segments[0].length_mm, 7);
    try {
        setBoreDepth(stepped(), 0, 1, 10);
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), errors::shaftRowWrong);
    }
}

TEST(BoreEdit, EveryFormIsOneThatAShaftMayHave)
{
    for (const RowForm form :
         {RowForm::Cylinder, RowForm::Cone, RowForm::Chamfer, RowForm::Round, RowForm::Fillet, RowForm::Groove}) {
        Shaft shaft;
        shaft.segments = {{60, 40, 40, 0, {}, ""}};
        shaft.bores = {{ShaftEnd::Free, {{10, 20, 20, {}, ""}, {2, 20, 20, {}, ""}, {8, 12, 12, {}, ""}}}};
        shaft.bores = changeBoreForm(std::move(shaft.bores), 0, 1, form);
        EXPECT_NO_THROW(checkShaft(shaft)) << static_cast<int>(form);
        EXPECT_EQ(shaft.bores[0].segments[1].length_mm, 2);
    }
    EXPECT_EQ(changeBoreForm(stepped(), 0, 0, RowForm::Chamfer)[0].segments[0].role, "chamfer");
}

}  // namespace
}  // namespace lathelier
