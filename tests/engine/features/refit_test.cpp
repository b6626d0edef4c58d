// Rows of a recognition changed by hand and fitted again.
#include "engine/features/refit/refit.h"

#include <gtest/gtest.h>

#include <cmath>

#include "engine/features/nominal/accepted_sizes.h"
#include "engine/features/refit/refit_codes.h"
#include "engine/shaft/shaft_rules.h"
#include "made_scan.h"

namespace lathelier::features {
namespace {

using What = RowChange::What;

const Recognition& features()
{
    static const Recognition result = recognize(scanShaft(featurePart(), askew(5)), {});
    return result;
}

std::string codeOf(const std::vector<RowChange>& changes)
{
    try {
        refit(scannedTableOne(), changes);
    } catch (const Error& error) {
        return error.code().key;
    }
    return {};
}

TEST(Refit, WithoutChangesNothingMoves)
{
    const Recognition again = refit(scannedTableOne(), {});
    EXPECT_EQ(again.shaft, scannedTableOne().shaft);
    EXPECT_EQ(again.notes.size(), scannedTableOne().notes.size());
}

TEST(Refit, ADeletedChamferLeavesItsCylinder)
{
    const Recognition again = refit(scannedTableOne(), {{What::Delete, 4}});
    ASSERT_EQ(again.segments.size(), 3U);
    EXPECT_NEAR(again.segments[2].start_diameter_mm, 33.8, 2e-3);
    EXPECT_NEAR(again.segments[2].z_end_mm, 183, 0.06);
    EXPECT_NEAR(*again.length_mm, *scannedTableOne().length_mm, 1e-3);
    EXPECT_TRUE(again.complete);
    EXPECT_TRUE(contains(again.notes, notes::rowsChangedByHand));
    EXPECT_NO_THROW(checkShaft(again.shaft));
}

TEST(Refit, ASplitRowIsMergedAgain)
{
    const Recognition split = refit(scannedTableOne(), {{What::Split, 1, 40}});
    ASSERT_EQ(split.segments.size(), 5U);
    EXPECT_NEAR(split.segments[0].z_end_mm, 40, 0.05);
    EXPECT_NEAR(split.segments[0].start_diameter_mm, 30, 3e-3);
    EXPECT_NEAR(split.segments[1].start_diameter_mm, 30, 3e-3);
    EXPECT_GT(*split.segments[0].uncertainty.z_end_um, 50);  // as a person points
    for (const RecognizedRow& row : split.segments) {
        ASSERT_TRUE(row.uncertainty.start_diameter_um);
        EXPECT_GT(*row.uncertainty.start_diameter_um, 0);
    }
    const Recognition merged = refit(scannedTableOne(), {{What::Split, 1, 40}, {What::Merge, 1}});
    ASSERT_EQ(merged.segments.size(), 4U);
    for (std::size_t i = 0; i < 4; ++i) {
        EXPECT_NEAR(merged.segments[i].start_diameter_mm, scannedTableOne().segments[i].start_diameter_mm, 2e-4);
        EXPECT_NEAR(merged.segments[i].z_end_mm, scannedTableOne().segments[i].z_end_mm, 2e-3);
    }
}

TEST(Refit, RowsOfTwoDiametersBecomeOneMeanCylinder)
{
    const Recognition merged = refit(scannedTableOne(), {{What::Merge, 1}});  // over the shoulder from ⌀30 to ⌀37
    ASSERT_EQ(merged.segments.size(), 3U);
    EXPECT_GT(merged.segments[0].start_diameter_mm, 30);
    EXPECT_LT(merged.segments[0].start_diameter_mm, 31.5);
    EXPECT_GT(merged.segments[0].residual_um, 200);  // and the residual shows the misfit
    EXPECT_NEAR(merged.segments[0].z_end_mm, 108, 0.05);
}

TEST(Refit, KindsChange)
{
    ASSERT_EQ(features().segments.size(), 10U);
    const Recognition cylinder = refit(features(), {{What::Cylinder, 5}});  // the taper between ⌀24 and ⌀28
    ASSERT_EQ(cylinder.segments.size(), 10U);
    EXPECT_EQ(cylinder.segments[4].kind, RowKind::Cylinder);
    EXPECT_NEAR(cylinder.segments[4].start_diameter_mm, 26, 0.3);
    const Recognition back = refit(features(), {{What::Cone, 3}});  // the fillet
    EXPECT_EQ(back.segments[2].kind, RowKind::Cone);
    const Recognition again = refit(features(), {{What::Cone, 3}, {What::Fillet, 3}});
    ASSERT_EQ(again.segments[2].kind, RowKind::Arc);
    EXPECT_NEAR(*again.segments[2].arc_radius_mm, -0.8, 0.06);
    EXPECT_NO_THROW(checkShaft(again.shaft));
}

TEST(Refit, WhatCannotBeIsRefused)
{
    EXPECT_EQ(codeOf({{What::Delete, 5}}), errors::rowNotThere.key);
    EXPECT_EQ(codeOf({{What::Delete, 0}}), errors::rowNotThere.key);
    EXPECT_EQ(codeOf({{What::Delete, -3}}), errors::rowNotThere.key);
    EXPECT_EQ(codeOf({{What::Merge, 4}}), errors::rowNotChangeable.key);
    EXPECT_EQ(codeOf({{What::Split, 1, 120}}), errors::rowNotChangeable.key);
    EXPECT_EQ(codeOf({{What::Split, 1, std::nan("")}}), errors::rowNotChangeable.key);
    EXPECT_EQ(codeOf({{What::Delete, 1}, {What::Delete, 1}, {What::Delete, 1}, {What::Delete, 1}}),
              errors::rowNotChangeable.key);
}

TEST(RowChanges, AreKeptAsText)
{
    const std::vector<RowChange> changes{{What::Delete, 3}, {What::Split, 2, 35.25}, {What::Fillet, 12}};
    EXPECT_EQ(textOf(changes), "delete:3,split:2@35.25,fillet:12");
    EXPECT_EQ(rowChanges(textOf(changes)), changes);
    EXPECT_TRUE(rowChanges("delete:0,merge,split:2,split:2@x,cone:1@3,:4,what:2,delete:9999999999999999999").empty());
    EXPECT_EQ(rowChanges(",delete:3,").size(), 1U);
}

TEST(RowChanges, AcceptedSizesKeepTheirRows)
{
    const std::vector<AcceptedSize> accepted{{1, "diameter_mm"}, {3, "z_mm"}, {4, "leg_mm"}};
    EXPECT_EQ(afterChange(accepted, {What::Delete, 3}), (std::vector<AcceptedSize>{{1, "diameter_mm"}, {3, "leg_mm"}}));
    EXPECT_EQ(afterChange(accepted, {What::Merge, 3}), (std::vector<AcceptedSize>{{1, "diameter_mm"}}));
    EXPECT_EQ(afterChange(accepted, {What::Split, 2, 9}),
              (std::vector<AcceptedSize>{{1, "diameter_mm"}, {4, "z_mm"}, {5, "leg_mm"}}));
    EXPECT_EQ(afterChange(accepted, {What::Cone, 1}), (std::vector<AcceptedSize>{{3, "z_mm"}, {4, "leg_mm"}}));
}

}  // namespace
}  // namespace lathelier::features
