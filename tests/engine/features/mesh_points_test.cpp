// Meshes of turned parts: corners lie on the surface, facets inside it.
#include "engine/features/walls/mesh_points.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "engine/features/features_codes.h"
#include "engine/features/recognition.h"
#include "made_scan.h"

namespace lathelier::features {
namespace {

/// Sides of a polygon in a circle of this radius whose chords lie so far inside it.
int sidesFor(double sagitta_mm, double radius_mm = 18.5)
{
    return static_cast<int>(std::ceil(M_PI / std::acos(1 - sagitta_mm / radius_mm)));
}

void moveTo(Scan& mesh, const Eigen::Isometry3d& pose)
{
    for (Eigen::Vector3d& point : mesh.points_mm) point = pose * point;
}

TEST(MeshPoints, ACoarseMeshGivesTheDiametersOfItsCorners)
{
    for (const double sagitta : {0.1, 0.01, 0.001}) {
        Scan mesh = sample::shaftMesh(sample::nominalShaft(), sidesFor(sagitta));
        moveTo(mesh, askew(1).scan_T_part);
        const Recognition r = recognize(mesh, {});
        ASSERT_EQ(r.segments.size(), 4U) << sagitta;
        const double diameters[] = {30, 37, 33.8, 33.8}, edges[] = {98, 108, 178, 183};
        for (std::size_t i = 0; i < 4; ++i) {
            EXPECT_NEAR(r.segments[i].start_diameter_mm, diameters[i], 5e-3) << sagitta << ' ' << i;
            EXPECT_NEAR(r.segments[i].z_end_mm, edges[i], 0.02) << sagitta << ' ' << i;
        }
        EXPECT_NEAR(r.segments[3].end_diameter_mm, 23.8, 0.02) << sagitta;
        const auto note =
            std::find_if(r.notes.begin(), r.notes.end(), [](const Note& n) { return n.code == notes::facetsRounded; });
        ASSERT_NE(note, r.notes.end()) << sagitta;
        const auto* said = std::get_if<double>(find(note->values, "sagitta_mm"));
        ASSERT_NE(said, nullptr);
        EXPECT_LT(*said, 1.05 * sagitta);
        EXPECT_GT(*said, 0.7 * sagitta);
    }
}

TEST(MeshPoints, AFineMeshIsTakenAsItIs)
{
    const Scan mesh = sample::shaftMesh(sample::nominalShaft(), 1000);
    const auto samples = registration::drawSamples(mesh, 60000);
    const auto points = flatPoints(mesh, samples);
    EXPECT_EQ(points, registration::sampleSurface(mesh, 60000).points_mm);
    const RoundedPoints round = roundedPoints(mesh, samples, registration::fitRevolution(points));
    EXPECT_TRUE(round.points.empty());
    EXPECT_LT(round.sagitta_mm, 5e-4);
}

TEST(MeshPoints, RoundedOnesLieOnConesAndFlatsStayFlat)
{
    // A cylinder of radius 20 and length 50 in 60 steps, of which ten are one flat.
    Scan mesh;
    std::vector<double> turns;
    for (int k = 0; k <= 50; ++k) turns.push_back(2 * M_PI * k / 60);
    for (const double z : {0.0, 50.0})
        for (const double turn : turns) mesh.points_mm.emplace_back(20 * std::cos(turn), 20 * std::sin(turn), z);
    const auto n = static_cast<std::uint32_t>(turns.size());
    for (std::uint32_t k = 0; k < n; ++k) {
        const std::uint32_t next = (k + 1) % n;
        mesh.triangles.push_back({k, next, n + next});
        mesh.triangles.push_back({k, n + next, n + k});
    }
    const auto samples = registration::drawSamples(mesh, 20000);
    registration::RevolutionFit fit;  // about z
    const RoundedPoints round = roundedPoints(mesh, samples, fit);
    ASSERT_EQ(round.points.size(), samples.size());
    EXPECT_NEAR(round.sagitta_mm, 20 * (1 - std::cos(M_PI / 60)), 1e-9);
    const double apart = 20 * std::cos(M_PI / 6);  // of the flat from the axis
    for (std::size_t i = 0; i < samples.size(); ++i) {
        const Eigen::Vector3d& p = round.points[i];
        if (samples[i].triangle >= 100)
            EXPECT_NEAR(p.head<2>().dot(Eigen::Vector2d(std::cos(-M_PI / 6), std::sin(-M_PI / 6))), apart, 1e-9);
        else
            EXPECT_NEAR(p.head<2>().norm(), 20, 1e-9);
    }
}

}  // namespace
}  // namespace lathelier::features
