// Zones along the axis that a person excludes: what borders on them ends as a gap or as the data; rows of bores.
#include "engine/registration/excluded_zones.h"

#include <gtest/gtest.h>

#include "engine/features/features_codes.h"
#include "engine/features/outline/bore_rows.h"
#include "engine/features/recognition.h"
#include "engine/registration/registration_codes.h"
#include "made_scan.h"
#include "made_scene.h"

namespace lathelier::features {
namespace {

Scan tableOne(std::uint64_t seed = 71)
{
    Scan scan = scanShaft(sample::nominalShaft(), askew(seed));
    scan.normals.clear();
    return scan;
}

RecognitionParameters without(std::vector<Interval> zones)
{
    RecognitionParameters parameters;
    parameters.exclude_z_mm = std::move(zones);
    return parameters;
}

TEST(ExcludedZonesOfAShaft, InTheMiddleAreAGap)
{
    // Also around a shoulder, and narrower than what counts as a gap by itself.
    for (const auto& [from, to] : {std::pair(40.0, 60.0), std::pair(97.0, 99.0), std::pair(50.0, 50.8)}) {
        const Recognition r = recognize(tableOne(), without({{from, to}}));
        ASSERT_EQ(r.gaps.size(), 1U) << from;
        EXPECT_NEAR(r.gaps[0].z_start_mm, from, 0.2);
        EXPECT_NEAR(r.gaps[0].z_end_mm, to, 0.2);
        EXPECT_FALSE(r.complete);
        EXPECT_TRUE(contains(r.notes, notes::zonesExcluded));
        EXPECT_TRUE(contains(r.notes, notes::gapInData));
        EXPECT_NEAR(r.segments.front().start_diameter_mm, 30, 3e-3);
        ASSERT_TRUE(r.length_mm);
        EXPECT_NEAR(*r.length_mm, 183, 0.06);
    }
}

TEST(ExcludedZonesOfAShaft, AtAnEndHideIt)
{
    const Recognition r = recognize(tableOne(), without({{150, 300}}));
    EXPECT_EQ(r.segments.size(), 3U);
    EXPECT_NEAR(r.segments.back().z_end_mm, 150, 0.2);
    EXPECT_EQ(r.ends[1].closed_by, "data");
    EXPECT_FALSE(r.length_mm);
    EXPECT_TRUE(r.gaps.empty());
    const Recognition other = recognize(tableOne(), without({{0, 50}}));
    EXPECT_EQ(other.ends[0].closed_by, "data");
    EXPECT_NE(other.ends[1].closed_by, "data");
    EXPECT_NEAR(other.segments.front().z_end_mm, 48, 0.2);  // z of the table begins where the data left begin
}

TEST(ExcludedZonesOfAShaft, CountFromTheFreeEnd)
{
    RecognitionParameters parameters = without({{0, 60}});
    parameters.free_end = FreeEnd::Last;
    const Recognition r = recognize(tableOne(), parameters);
    EXPECT_NEAR(r.segments.front().start_diameter_mm, 33.8, 5e-3);
    EXPECT_NEAR(r.segments.front().z_end_mm, 15, 0.2);
}

TEST(ExcludedZonesOfAShaft, LeaveOutWhatSpoilsTheRest)
{
    // A collar that is no body of revolution, so large that all points give no axis that is accepted.
    const sample::ScannerModel scanner = askew(72);
    Scan scan = scanShaft(sample::nominalShaft(), scanner);
    scan.normals.clear();
    MadeScene scene(72);
    scene.box({-60, -30, 150}, {90, 0, 0}, {0, 55, 0}, {0, 0, 33},
              [](const Eigen::Vector3d& p) { return std::hypot(p.x(), p.y()) > 17; });
    scene.addTo(scan, scanner.scan_T_part);
    RecognitionParameters parameters = without({{148, 200}});
    parameters.scene = SceneUse::Keep;
    const Recognition r = recognize(scan, parameters);
    ASSERT_EQ(r.segments.size(), 3U);
    EXPECT_NEAR(r.segments[0].start_diameter_mm, 30, 3e-3);
    EXPECT_NEAR(r.segments[2].start_diameter_mm, 33.8, 3e-3);
}

TEST(ExcludedZonesOfAShaft, LeaveNothing)
{
    EXPECT_THROW(recognize(tableOne(), without({{0, 300}})), Error);
}

TEST(ExcludedZones, AtTheEndsIncludeWhatNoisePlacesBeyond)
{
    const registration::ExcludedZones zones({{0, 10}, {90, 100}}, 100);
    EXPECT_TRUE(zones.contains(-0.3));
    EXPECT_TRUE(zones.contains(10));
    EXPECT_FALSE(zones.contains(50));
    EXPECT_TRUE(zones.contains(100.4));
}

RecognizedRow boreRow(RowKind kind, double from, double to, double start_diameter, double end_diameter)
{
    RecognizedRow row;
    row.kind = kind;
    row.z_start_mm = from;
    row.z_end_mm = to;
    row.start_diameter_mm = start_diameter;
    row.end_diameter_mm = end_diameter;
    return row;
}

TEST(BoreRows, HaveAPositiveLengthWithinThePart)
{
    const auto cylinder = RowKind::Cylinder;
    // Beyond the part, reversed, across its end, of no length: the walls of clusters and of a chuck gave such rows.
    const std::vector<RecognizedRow> rows = rowsWithinPart(
        {boreRow(cylinder, -20, -5, 8, 8), boreRow(RowKind::Cone, -1, 1, 12, 10), boreRow(cylinder, 1, 30, 10, 10),
         boreRow(cylinder, 40, 35, 10, 10), boreRow(cylinder, 50, 50, 9, 9), boreRow(cylinder, 95, 140, 14, 14),
         boreRow(cylinder, 154, 160, 14, 14)},
        100);
    ASSERT_EQ(rows.size(), 3U);
    EXPECT_EQ(rows[0].z_start_mm, 0);
    EXPECT_DOUBLE_EQ(rows[0].start_diameter_mm, 11);
    EXPECT_EQ(rows[1].z_end_mm, 30);
    EXPECT_EQ(rows[2].z_end_mm, 100);
    for (const RecognizedRow& row : rows) EXPECT_GT(row.z_end_mm, row.z_start_mm);
    EXPECT_TRUE(rowsWithinPart({}, 100).empty());
}

}  // namespace
}  // namespace lathelier::features
