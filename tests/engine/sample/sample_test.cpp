#include "engine/sample/sample.h"
#include "engine/sample/sample_files.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <map>
#include <numbers>
#include <utility>

#include "engine/core/parallel.h"
#include "engine/core/random.h"
#include "engine/io/file.h"
#include "engine/project/project.h"
#include "tests/scratch_folder.h"

namespace lathelier {
namespace {

using std::numbers::pi;

double volume_mm3(const Scan& mesh)
{
    double six = 0;
    for (const auto& [a, b, c] : mesh.triangles)
        six += mesh.points_mm[a].dot(mesh.points_mm[b].cross(mesh.points_mm[c]));
    return six / 6;
}

bool isClosed(const Scan& mesh)
{
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
    for (const auto& [a, b, c] : mesh.triangles) {
        ++edges[{a, b}];
        ++edges[{b, c}];
        ++edges[{c, a}];
    }
    for (const auto& [edge, count] : edges)
        if (count != 1 || !edges.contains({edge.second, edge.first})) return false;
    return true;
}

TEST(Random, NormalHasTheMomentsOfTheNormalDistribution)
{
    double sum = 0, square = 0, fourth = 0;
    constexpr int n = 400000;
    for (int i = 0; i < n; ++i) {
        const double x = randomNormal(3, 5, static_cast<std::uint64_t>(i));
        sum += x;
        square += x * x;
        fourth += x * x * x * x;
    }
    EXPECT_NEAR(sum / n, 0, 0.006);
    EXPECT_NEAR(square / n, 1, 0.01);
    EXPECT_NEAR(fourth / n, 3, 0.08);
}

TEST(Sample, MeshesAreClosedAndHaveTheRightVolume)
{
    const Scan shaft = sample::shaftMesh(sample::nominalShaft(), 720);
    EXPECT_TRUE(isClosed(shaft));
    const double chamfer = pi * 5 / 3 * (16.9 * 16.9 + 16.9 * 11.9 + 11.9 * 11.9);
    const double solid = pi * (15 * 15 * 98 + 18.5 * 18.5 * 10 + 16.9 * 16.9 * 70) + chamfer;
    EXPECT_NEAR(volume_mm3(shaft) / solid, 1, 2e-5);

    const Scan bracket = sample::bracketMesh();
    EXPECT_TRUE(isClosed(bracket));
    const double walls = 12 * (100 * 80 + 80 * 78) - 12 * pi * (8 * 8 + 12.5 * 12.5 + 18 * 18);
    EXPECT_NEAR(volume_mm3(bracket) / walls, 1, 2e-4);
}

TEST(Sample, ScanLiesOnTheShaftWithTheNoiseAskedFor)
{
    const sample::ShaftModel shaft = sample::copiedShaft();
    sample::ScannerModel scanner;
    scanner.scan_T_part = Eigen::Translation3d(0.5, -0.3, 2) * Eigen::AngleAxisd(0.01, Eigen::Vector3d::UnitX());
    scanner.frame_T_scan =
        Eigen::Translation3d(10, 5, -3) * Eigen::AngleAxisd(0.15, Eigen::Vector3d(1, 2, 3).normalized());
    const Scan scan = sample::scanShaft(shaft, scanner);
    EXPECT_NEAR(static_cast<double>(scan.points_mm.size()), 732000, 1500);
    const Eigen::Isometry3d part_T_frame = (scanner.frame_T_scan * scanner.scan_T_part).inverse();
    double sum = 0, square = 0;
    int n = 0;
    for (const Eigen::Vector3d& point : scan.points_mm) {
        const Eigen::Vector3d p = part_T_frame * point;
        for (const auto& [from, to] : {std::pair{0.5, 97.5}, {98.5, 107.5}, {108.5, 177.5}})
            if (p.z() > from && p.z() < to) {
                const double off = std::hypot(p.x(), p.y()) - radius_mm(shaft, p.z());
                sum += off;
                square += off * off;
                ++n;
            }
    }
    EXPECT_NEAR(sum / n, 0, 0.0004);
    EXPECT_NEAR(std::sqrt(square / n), 0.05, 0.0004);
    EXPECT_GT(n, 700000);
}

TEST(Sample, DropoutsSpuriousPointsAndMissingEnds)
{
    sample::ScannerModel scanner;
    scanner.angle_step_deg = 3.6;
    const double all = static_cast<double>(sample::scanShaft(sample::nominalShaft(), scanner).points_mm.size());
    scanner.dropout_share = 0.3;
    const double left = static_cast<double>(sample::scanShaft(sample::nominalShaft(), scanner).points_mm.size());
    EXPECT_NEAR(left / all, 0.7, 0.02);
    scanner.spurious_share = 0.02;
    const double more = static_cast<double>(sample::scanShaft(sample::nominalShaft(), scanner).points_mm.size());
    EXPECT_NEAR(more / left, 1.02, 1e-4);
    scanner = {};
    scanner.angle_step_deg = 3.6;
    scanner.part_z_to_mm = 140;
    for (const Eigen::Vector3d& p : sample::scanShaft(sample::nominalShaft(), scanner).points_mm) EXPECT_LE(p.z(), 140);
}

TEST(Sample, SameBitsForOneAndTwoThreads)
{
    sample::ScannerModel scanner;
    scanner.angle_step_deg = 3.6;
    scanner.dropout_share = 0.1;
    scanner.spurious_share = 0.01;
    const Scan two = sample::scanShaft(sample::copiedShaft(), scanner);
    const Scan bracket = sample::scanBracket(20000, 0.05, Eigen::Isometry3d::Identity(), 3);
    const ThreadLimit limit(1);
    ASSERT_EQ(threadsAllowed(), 1u);
    EXPECT_EQ(two.points_mm, sample::scanShaft(sample::copiedShaft(), scanner).points_mm);
    EXPECT_EQ(bracket.points_mm, sample::scanBracket(20000, 0.05, Eigen::Isometry3d::Identity(), 3).points_mm);
}

TEST(Sample, WritesAProjectWhoseSourcesAreUnchanged)
{
    const ScratchFolder folder;
    const std::vector<std::string> files = sample::writeSample(folder.string(), 4);
    ASSERT_EQ(files.size(), sample::sampleFileNames().size());
    const project::ProjectFile read = project::readProject(files.back());
    EXPECT_TRUE(read.project.panels.at("roundness").inputs.at("record").synthetic);
    EXPECT_TRUE(project::checkSources(read.project).empty());
    EXPECT_TRUE(read.project.panels.at("compare").inputs.at("copy").synthetic);
    EXPECT_TRUE(read.project.panels.at("recognise").inputs.at("scan").synthetic);
    const io::FileBytes cloud(files[0]);
    EXPECT_TRUE(cloud.view().starts_with("ply\nformat binary_little_endian 1.0\ncomment unit mm\ncomment synthetic"));
    EXPECT_GT(cloud.view().size(), 8700000u);
    const std::string first(cloud.view());
    sample::writeSample(folder.string(), 4);
    EXPECT_EQ(io::FileBytes(files[0]).view(), first);
}

}  // namespace
}  // namespace lathelier
