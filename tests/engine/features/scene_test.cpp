// What is not the part is cut off before recognition, and nothing of the part.
#include "engine/features/scene/scene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "engine/core/random.h"
#include "engine/features/features_codes.h"
#include "engine/features/recognition.h"
#include "engine/features/report/recognized_rows.h"
#include "made_scan.h"
#include "made_scene.h"

namespace lathelier::features {
namespace {

using Eigen::Vector3d;

const SceneGroup* groupOf(const std::vector<SceneGroup>& groups, const std::string& kind)
{
    const auto found = std::find_if(groups.begin(), groups.end(), [&](const auto& one) { return one.kind == kind; });
    return found == groups.end() ? nullptr : &*found;
}

std::int64_t countOf(const std::vector<SceneGroup>& groups, const std::string& kind)
{
    return std::count_if(groups.begin(), groups.end(), [&](const auto& one) { return one.kind == kind; });
}

/// The paper's shaft: three diameters and what the scene must leave of them.
void expectTableOne(const Recognition& r, double diameter_mm = 3e-3)
{
    ASSERT_EQ(r.segments.size(), 4U);
    EXPECT_NEAR(r.segments[0].start_diameter_mm, 30, diameter_mm);
    EXPECT_NEAR(r.segments[1].start_diameter_mm, 37, diameter_mm);
    EXPECT_NEAR(r.segments[2].start_diameter_mm, 33.8, diameter_mm);
    EXPECT_NEAR(r.segments[1].z_end_mm - r.segments[1].z_start_mm, 10, 0.05);
}

/// Standing on its free end on a disc of radius 150 mm, a bolt beside it.
Scan onTurntable(const sample::ScannerModel& scanner)
{
    Scan scan = scanShaft(sample::nominalShaft(), scanner);
    MadeScene scene(scanner.seed);
    scene.face(0, 15.2, 150);
    scene.cylinder({80, 30, 0}, {0, 0, 25}, 6);
    scene.addTo(scan, scanner.frame_T_scan * scanner.scan_T_part);
    return scan;
}

RecognitionParameters with(SceneUse use)
{
    RecognitionParameters parameters;
    parameters.scene = use;
    return parameters;
}

TEST(Scene, ATurntableIsCutOffUnasked)
{
    const Scan scan = onTurntable(askew(3));
    const Recognition r = recognize(scan, {});
    expectTableOne(r);
    ASSERT_TRUE(r.length_mm);
    EXPECT_NEAR(*r.length_mm, 183, 0.06);
    EXPECT_NEAR(r.segments[0].z_end_mm, 98, 0.05);  // from the plane that it stands on
    const SceneGroup *part = groupOf(r.scene, "part"), *table = groupOf(r.scene, "turntable");
    ASSERT_TRUE(part && table);
    EXPECT_TRUE(part->kept);
    EXPECT_EQ(part->reason, "body_of_revolution");
    EXPECT_FALSE(table->kept);
    EXPECT_NEAR(static_cast<double>(table->points), 4 * M_PI * (150 * 150 - 15.2 * 15.2), 6000);
    EXPECT_NEAR(table->max_mm.x() - table->min_mm.x(), 300, 1);
    const SceneGroup* bolt = groupOf(r.scene, "clutter");  // the largest; stray points are another
    ASSERT_TRUE(bolt);
    EXPECT_NEAR(static_cast<double>(bolt->points), 4 * 2 * M_PI * 6 * 25, 200);
    std::int64_t all = 0;
    for (const SceneGroup& group : r.scene) all += group.points;
    EXPECT_EQ(all, static_cast<std::int64_t>(scan.points_mm.size()));
    const auto note =
        std::find_if(r.notes.begin(), r.notes.end(), [](const Note& n) { return n.code == notes::sceneCut; });
    ASSERT_NE(note, r.notes.end());
    EXPECT_EQ(*find(note->values, "cut_points"), Value(all - part->points));
    EXPECT_EQ(*find(note->values, "turntable_points"), Value(table->points));
    EXPECT_EQ(toJson(r)["scene"][0]["kind"], "part");
    EXPECT_EQ(toJson(r)["scene"][0]["min_mm"].size(), 3U);
}

TEST(Scene, AnywhereInSpace)
{
    sample::ScannerModel scanner = askew(4);
    scanner.frame_T_scan = Eigen::Isometry3d(Eigen::Translation3d(300, -50, 700) *
                                             Eigen::AngleAxisd(1.1, Vector3d(1, 2, 0.3).normalized()));
    const Recognition r = recognize(onTurntable(scanner), {});
    expectTableOne(r);
    EXPECT_NE(groupOf(r.scene, "turntable"), nullptr);
}

TEST(Scene, VBlocksAreCutWhenAsked)
{
    const sample::ScannerModel scanner = askew(6);
    Scan scan = scanShaft(sample::nominalShaft(), scanner);
    MadeScene scene(6);
    scene.vBlock(40, 15);
    scene.vBlock(140, 16.9);
    scene.addTo(scan, scanner.scan_T_part, [](const Vector3d& p) {
        const bool over_block = (p.z() > 39 && p.z() < 66) || (p.z() > 139 && p.z() < 166);
        return over_block && p.y() < -std::abs(p.x()) * 0.7;
    });
    const Recognition r = recognize(scan, with(SceneUse::Cut));
    expectTableOne(r, 6e-3);
    EXPECT_EQ(countOf(r.scene, "clamp"), 2);
    EXPECT_EQ(groupOf(r.scene, "turntable"), nullptr);
    EXPECT_TRUE(recognize(scan, with(SceneUse::Keep)).scene.empty());
}

TEST(Scene, JawsAboutAnEndAreCutWhenAsked)
{
    const sample::ScannerModel scanner = askew(7);
    Scan scan = scanShaft(sample::nominalShaft(), scanner);
    MadeScene scene(7);
    scene.jaws(155, 16.9);
    scene.addTo(scan, scanner.scan_T_part, [](const Vector3d& p) { return isUnderJaws(p, 154.5); });
    const Recognition r = recognize(scan, with(SceneUse::Cut));
    expectTableOne(r, 6e-3);
    EXPECT_EQ(countOf(r.scene, "clamp"), 3);
    EXPECT_NEAR(r.segments[3].half_angle_deg, -45, 1);  // the chamfer between the jaws
}

TEST(Scene, AScanOfThePartAloneIsUntouched)
{
    const Scan scan = scanShaft(sample::nominalShaft(), askew(8));
    const std::string kept = toJson(recognize(scan, with(SceneUse::Keep))).dump();
    EXPECT_EQ(toJson(recognize(scan, with(SceneUse::Auto))).dump(), kept);
    EXPECT_EQ(toJson(recognize(scan, with(SceneUse::Cut))).dump(), kept);
    // With stray points all about it.
    sample::ScannerModel dirty = askew(9);
    dirty.spurious_share = 0.02;
    dirty.dropout_share = 0.25;
    const Scan poor = scanShaft(featurePart(), dirty);
    EXPECT_TRUE(findScene(poor.points_mm, SceneUse::Auto).groups.empty());
}

TEST(Scene, AFlangesFaceIsNoTurntable)
{
    for (const double thick : {3.0, 14.0}) {
        MadeScene flange(11);
        flange.face(0, 0, 100);
        flange.cylinder({0, 0, 0}, {0, 0, thick}, 100);
        flange.face(thick, 20, 100);
        flange.cylinder({0, 0, thick}, {0, 0, 60}, 20);
        flange.face(thick + 60, 0, 20);
        for (const SceneUse use : {SceneUse::Auto, SceneUse::Cut})
            EXPECT_TRUE(findScene(flange.points, use).groups.empty()) << thick;
    }
}

TEST(Scene, ShouldersStayWhereAPartIsHeldByItsEnd)
{
    // A flange of radius 60 in the middle of a shaft, jaws at its end: only the jaws go.
    MadeScene part(12);
    part.cylinder({0, 0, 0}, {0, 0, 50}, 15);
    part.face(50, 15, 60);
    part.cylinder({0, 0, 50}, {0, 0, 12}, 60);
    part.face(62, 20, 60);
    part.cylinder({0, 0, 62}, {0, 0, 80}, 20);
    const std::size_t own = part.points.size();
    part.jaws(112, 20);
    const Scene scene = findScene(part.points, SceneUse::Cut);
    EXPECT_EQ(countOf(scene.groups, "clamp"), 3);
    ASSERT_FALSE(scene.kept.empty());
    std::size_t lost = 0, lost_elsewhere = 0;
    for (std::size_t i = 0; i < own; ++i) {
        if (scene.kept[i]) continue;
        ++lost;
        lost_elsewhere += part.points[i].z() < 108;
    }
    EXPECT_EQ(lost_elsewhere, 0U);
    EXPECT_GT(lost, 0U);  // points at the contact of the jaws cannot be assigned
}

TEST(Scene, AMillionPointsGiveTheSameTwice)
{
    const Scan scan = onTurntable(askew(13));
    ASSERT_GT(scan.points_mm.size(), 1000000U);
    const Scene first = findScene(scan.points_mm, SceneUse::Auto);
    const Scene again = findScene(scan.points_mm, SceneUse::Auto);
    EXPECT_EQ(first.kept, again.kept);
}

TEST(Scene, FlyingPointsAreCutBeforeAPartIsRefused)
{
    sample::ScannerModel scanner;
    scanner.seed = 4;
    Scan scan = scanShaft(sample::nominalShaft(), scanner);
    const std::size_t flying = scan.points_mm.size() / 100;
    for (std::size_t i = 0; i < flying; ++i)
        scan.points_mm.emplace_back(500 * randomUniform(9, 0, i) - 250, 500 * randomUniform(9, 1, i) - 250,
                                    500 * randomUniform(9, 2, i) - 250);
    scan.normals.clear();
    const Recognition found = recognize(scan, with(SceneUse::Auto));
    expectTableOne(found);
    EXPECT_EQ(found.parameters.scene, SceneUse::Auto);
}

}  // namespace
}  // namespace lathelier::features
