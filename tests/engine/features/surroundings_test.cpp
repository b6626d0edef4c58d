// Chuck jaws, a centre and clusters of stray points are told from a part, and what is seen of the part is right.
#include "engine/features/scene/surroundings/surroundings.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "engine/features/features_codes.h"
#include "engine/features/recognition.h"
#include "engine/features/report/recognized_rows.h"
#include "engine/features/scene/surroundings/loose_clusters.h"
#include "engine/features/scene/surroundings/plane_shares.h"
#include "engine/features/scene/surroundings/point_cubes.h"
#include "made_scan.h"
#include "made_scene.h"

namespace lathelier::features {
namespace {

using Eigen::Vector3d;

std::int64_t pointsOfKind(const Recognition& result, const std::string& kind)
{
    std::int64_t points = 0;
    for (const SceneGroup& group : result.scene) points += group.kind == kind ? group.points : 0;
    return points;
}

/// The paper's shaft up to jaws at z 155: three cylinders, an end that is not seen, nothing invented.
void expectShaftToTheJaws(const Recognition& r)
{
    ASSERT_EQ(r.segments.size(), 3U);
    EXPECT_NEAR(r.segments[0].start_diameter_mm, 30, 3e-3);
    EXPECT_NEAR(r.segments[1].start_diameter_mm, 37, 3e-3);
    EXPECT_NEAR(r.segments[2].start_diameter_mm, 33.8, 3e-3);
    EXPECT_NEAR(r.segments[1].z_end_mm - r.segments[1].z_start_mm, 10, 0.05);
    EXPECT_LT(r.segments[2].z_end_mm, 155.5);
    EXPECT_GT(r.segments[2].z_end_mm, 152);
    EXPECT_TRUE(r.marks.empty());
    EXPECT_TRUE(r.bores.empty());
    EXPECT_TRUE(r.gaps.empty());
    EXPECT_FALSE(r.length_mm);
    EXPECT_FALSE(r.complete);
    EXPECT_EQ(r.ends[1].closed_by, "data");
    EXPECT_NE(r.ends[0].closed_by, "data");
    EXPECT_TRUE(contains(r.notes, notes::endNotSeen));
    EXPECT_TRUE(contains(r.notes, notes::sceneCut));
}

/// The paper's shaft with jaws at z 155 that hide the rest of it.
Scan inJaws(std::uint64_t seed, const MadeScene& scene)
{
    const sample::ScannerModel scanner = askew(seed);
    Scan scan = scanShaft(sample::nominalShaft(), scanner);
    scan.normals.clear();
    scene.addTo(scan, scanner.scan_T_part, [](const Vector3d& p) { return p.z() > 154.7; });
    return scan;
}

TEST(Surroundings, AChuckWithJawsIsCutUnasked)
{
    MadeScene scene(21);
    scene.jaws(155, 16.9);
    scene.chuck(195, 25, 60);
    const Scan scan = inJaws(21, scene);
    const Recognition r = recognize(scan, {});
    expectShaftToTheJaws(r);
    EXPECT_NEAR(static_cast<double>(pointsOfKind(r, "clamp")), static_cast<double>(scene.points.size()), 3000);
    RecognitionParameters stated;
    stated.length_mm = 183;
    const Recognition closed = recognize(scan, stated);
    EXPECT_TRUE(closed.complete);
    ASSERT_TRUE(closed.length_mm);
    EXPECT_NEAR(*closed.length_mm, 183, 1e-9);
}

TEST(Surroundings, JawsWithoutAChuckAreCutUnasked)
{
    MadeScene scene(22);
    scene.jaws(155, 16.9);
    expectShaftToTheJaws(recognize(inJaws(22, scene), {}));
}

TEST(Surroundings, AChuckSeenFromOneSideIsCut)
{
    MadeScene scene(23);
    scene.jaws(155, 16.9);
    scene.chuck(195, 25, 60);
    std::erase_if(scene.points, [](const Vector3d& p) { return p.y() < 0; });
    expectShaftToTheJaws(recognize(inJaws(23, scene), {}));
}

/// Jaws of this width hide what is nearer to the axis than 12 mm: the last of the chamfer.
TEST(Surroundings, AShaftIsSeenBetweenJawsButNotItsEnd)
{
    const sample::ScannerModel scanner = askew(24);
    Scan scan = scanShaft(sample::nominalShaft(), scanner);
    scan.normals.clear();
    MadeScene scene(24);
    scene.jaws(155, 16.9);
    scene.addTo(scan, scanner.scan_T_part, [](const Vector3d& p) { return isUnderJaws(p, 154.5); });
    const Recognition r = recognize(scan, {});
    ASSERT_EQ(r.segments.size(), 4U);
    EXPECT_NEAR(r.segments[2].start_diameter_mm, 33.8, 6e-3);
    EXPECT_NEAR(r.segments[3].half_angle_deg, -45, 1);
    EXPECT_FALSE(r.length_mm);
    EXPECT_FALSE(r.complete);
}

TEST(Surroundings, ACentreInAnEndIsCut)
{
    constexpr double density = 38;  // per mm²: of the shaft
    const sample::ScannerModel scanner = askew(25);
    Scan scan = scanShaft(sample::nominalShaft(), scanner);
    scan.normals.clear();
    MadeScene scene(25);
    scene.centre(0, 3, 15, density);
    scene.cylinder({0, 0, -45}, {0, 0, 30}, 3 + 15 / std::numbers::sqrt3, density);
    scene.addTo(scan, scanner.scan_T_part);
    const Recognition r = recognize(scan, {});
    ASSERT_EQ(r.segments.size(), 4U);
    EXPECT_NEAR(r.segments[0].start_diameter_mm, 30, 3e-3);
    ASSERT_TRUE(r.length_mm);
    EXPECT_NEAR(*r.length_mm, 183, 0.06);
    EXPECT_NEAR(static_cast<double>(pointsOfKind(r, "clamp")), static_cast<double>(scene.points.size()), 500);
}

/// Around the paper's shaft: off its surface, on it, beside a shoulder, beyond an end, and in the metal on the axis.
MadeScene fiveClusters(std::uint64_t seed)
{
    MadeScene scene(seed);
    scene.cluster({15 + 6, 0, 40}, 0.8, 500);
    scene.cluster({0, 15, 70}, 0.6, 400);
    scene.cluster({-16, 0, 98}, 1.0, 600);
    scene.cluster({4, 3, -3}, 1.2, 300);
    scene.cluster({0.5, -0.5, 140}, 0.9, 500);
    return scene;
}

TEST(Surroundings, ClustersAreCutUnasked)
{
    for (const std::uint64_t seed : {std::uint64_t{31}, std::uint64_t{32}}) {
        const sample::ScannerModel scanner = askew(seed);
        Scan scan = scanShaft(sample::nominalShaft(), scanner);
        scan.normals.clear();
        fiveClusters(seed).addTo(scan, scanner.scan_T_part);
        const Recognition r = recognize(scan, {});
        ASSERT_EQ(r.segments.size(), 4U);
        EXPECT_NEAR(r.segments[0].start_diameter_mm, 30, 3e-3);
        EXPECT_NEAR(r.segments[0].z_end_mm, 98, 0.05);
        EXPECT_NEAR(r.segments[1].z_end_mm - r.segments[1].z_start_mm, 10, 0.05);
        EXPECT_TRUE(r.complete);
        EXPECT_TRUE(r.marks.empty());
        EXPECT_TRUE(r.bores.empty());
        EXPECT_FALSE(contains(r.notes, notes::boreNotSeen));
        EXPECT_TRUE(contains(r.notes, notes::sceneCut));
        EXPECT_GT(pointsOfKind(r, "clutter"), 2000);
        EXPECT_LT(pointsOfKind(r, "clutter"), 2350);
    }
}

TEST(Surroundings, NothingIsCutWhereAllIsToBeKept)
{
    const sample::ScannerModel scanner = askew(33);
    Scan scan = scanShaft(sample::nominalShaft(), scanner);
    scan.normals.clear();
    fiveClusters(33).addTo(scan, scanner.scan_T_part);
    RecognitionParameters keep;
    keep.scene = SceneUse::Keep;
    const Recognition r = recognize(scan, keep);
    EXPECT_TRUE(r.scene.empty());
    EXPECT_FALSE(contains(r.notes, notes::sceneCut));
}

TEST(Surroundings, PartsOfThePartStay)
{
    // A spline of six high teeth, a square head, a flange with a disc behind it, a tube: sheets, not jaws or clusters.
    for (const int kind : {0, 1, 2, 3}) {
        MadeScene part(40);
        part.cylinder({0, 0, 0}, {0, 0, 60}, 15);
        part.face(0, 0, 15);
        if (kind == 0)
            for (int tooth = 0; tooth < 6; ++tooth) {
                const double angle = tooth * std::numbers::pi / 3;
                const Vector3d out(std::cos(angle), std::sin(angle), 0), across(-out.y(), out.x(), 0);
                part.box(14.5 * out - 3 * across + Vector3d(0, 0, 60), 4 * out, 6 * across, {0, 0, 25});
            }
        if (kind == 0) part.cylinder({0, 0, 60}, {0, 0, 25}, 15);
        if (kind == 1) part.box({-13, -13, 60}, {26, 0, 0}, {0, 26, 0}, {0, 0, 16});
        if (kind == 2) {
            part.face(60, 15, 40);
            part.cylinder({0, 0, 60}, {0, 0, 10}, 40);
            part.face(70, 40, 60);
            part.cylinder({0, 0, 70}, {0, 0, 20}, 60);
            part.face(90, 0, 60);
        }
        if (kind == 3) {
            part.face(60, 8, 15);
            part.cylinder({0, 0, 20}, {0, 0, 40}, 8);
            part.face(20, 0, 8);
        }
        Scan scan;
        scan.points_mm = part.points;
        RecognitionParameters keep;
        keep.scene = SceneUse::Keep;
        try {
            EXPECT_EQ(toJson(recognize(scan, {})).dump().size(), toJson(recognize(scan, keep)).dump().size()) << kind;
        } catch (const Error& error) {
            EXPECT_THROW(recognize(scan, keep), Error) << kind << error.code().key;
        }
    }
}

TEST(LooseClusters, AreCloudsAndNotSheetsTubesOrCorners)
{
    MadeScene made(50, 0.03);
    made.cluster({0, 0, 0}, 0.5, 300);
    made.cluster({30, 0, 0}, 1.2, 200);
    made.cluster({0, 60, 0}, 4, 3000);
    const std::vector<LooseCluster> found = findClusters(made.points, 0.03);
    ASSERT_EQ(found.size(), 3U);
    EXPECT_LT(found[0].middle_mm.norm(), 0.2);
    EXPECT_TRUE(found[2].thin);
    MadeScene sheets(51, 0.05);
    sheets.box({0, 0, 0}, {12, 0, 0}, {0, 9, 0}, {0, 0, 7});
    sheets.cylinder({50, 0, 0}, {0, 0, 12}, 3, 8);
    sheets.cylinder({80, 0, 0}, {0, 0, 6}, 2, 20);
    sheets.face(-40, 0, 20);
    EXPECT_TRUE(findClusters(sheets.points, 0.05).empty());
}

TEST(PlaneShares, CountPlanesAcrossAndAlongTheAxis)
{
    MadeScene box(60, 0.02);
    box.box({20, 5, 0}, {30, 0, 0}, {0, 18, 0}, {0, 0, 25});
    EXPECT_GT(planesShare(box.points, 0.08, 0.02), 0.9);
    MadeScene ball(61, 0.02);
    ball.cluster({0, 0, 0}, 10, 3000);
    EXPECT_LT(planesShare(ball.points, 0.08, 0.02), 0.1);
    EXPECT_EQ(planesShare({}, 0.08, 0.02), 0);
}

TEST(PointCubes, GroupNeighbours)
{
    const std::vector<Vector3d> points{{0, 0, 0}, {5, 5, 5}, {0.9, 0.9, 0.9}, {1.1, 1.1, 1.1}, {5.2, 5, 5}};
    const PointCubes cubes(points, 1);
    ASSERT_EQ(cubes.size(), 3U);
    EXPECT_EQ(cubes.count(0), 2U);
    const auto groups = cubes.groups([](std::size_t) { return true; });
    ASSERT_EQ(groups.size(), 2U);
    EXPECT_EQ(groups[0], (std::vector<std::size_t>{0, 2}));
    EXPECT_EQ(groups[1], (std::vector<std::size_t>{1}));
    EXPECT_EQ(PointCubes({}, 1).size(), 0U);
}

}  // namespace
}  // namespace lathelier::features
