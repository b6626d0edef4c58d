#include "engine/registration/registration_verification.h"

#include <Eigen/Geometry>
#include <array>
#include <map>
#include <numbers>
#include <vector>

#include "engine/core/units.h"
#include "engine/registration/compare.h"

namespace lathelier::registration {
namespace {

struct Corner {
    double z_mm;
    double radius_mm;
};

/// The shaft of these corners, as a closed mesh with `sides` around and rows at most 2 mm apart.
Scan turned(const std::vector<Corner>& corners, int sides)
{
    std::vector<Corner> rows;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        if (i > 0) {
            const Corner& a = corners[i - 1];
            const Corner& b = corners[i];
            const int cuts = static_cast<int>(std::hypot(b.z_mm - a.z_mm, b.radius_mm - a.radius_mm) / 2) + 1;
            for (int cut = 1; cut < cuts; ++cut) {
                const double t = static_cast<double>(cut) / cuts;
                rows.push_back({a.z_mm + t * (b.z_mm - a.z_mm), a.radius_mm + t * (b.radius_mm - a.radius_mm)});
            }
        }
        rows.push_back(corners[i]);
    }
    Scan mesh;
    for (const Corner& row : rows)
        for (int side = 0; side < sides; ++side) {
            const double angle = 2 * std::numbers::pi * side / sides;
            mesh.points_mm.emplace_back(row.radius_mm * std::cos(angle), row.radius_mm * std::sin(angle), row.z_mm);
        }
    const auto at = [sides](std::size_t row, int side) {
        return static_cast<std::uint32_t>(row * static_cast<std::size_t>(sides) +
                                          static_cast<std::size_t>(side % sides));
    };
    for (std::size_t row = 1; row < rows.size(); ++row)
        for (int side = 0; side < sides; ++side) {
            mesh.triangles.push_back({at(row - 1, side), at(row - 1, side + 1), at(row, side + 1)});
            mesh.triangles.push_back({at(row - 1, side), at(row, side + 1), at(row, side)});
        }
    return mesh;
}

/// The end faces run nearly to the axis, so that the mesh stays a plain grid.
std::vector<Corner> shaftCorners(double collar_oversize_mm)
{
    constexpr double tip_mm = 0.05;
    const double collar_mm = 18 + collar_oversize_mm;
    return {{0, tip_mm}, {0, 12}, {40, 12}, {40, collar_mm}, {52, collar_mm}, {52, 14}, {90, 14}, {90, tip_mm}};
}

Scan movedScan(Scan scan, const Eigen::Isometry3d& motion)
{
    for (Eigen::Vector3d& point : scan.points_mm) point = motion * point;
    return scan;
}

Eigen::Isometry3d otherPose()
{
    Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
    pose.translate(Eigen::Vector3d(4.0, -2.0, 5.0));
    pose.rotate(Eigen::AngleAxisd(0.17, Eigen::Vector3d(1, 2, 0.3).normalized()));
    return pose;
}

/// Each triangle in four; neighbours keep their common vertices.
Scan refined(const Scan& mesh)
{
    Scan result;
    result.points_mm = mesh.points_mm;
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
    const auto middle = [&](std::uint32_t a, std::uint32_t b) {
        const auto [place, is_new] =
            middles.try_emplace(std::minmax(a, b), static_cast<std::uint32_t>(result.points_mm.size()));
        if (is_new) result.points_mm.push_back((result.points_mm[a] + result.points_mm[b]) / 2);
        return place->second;
    };
    for (const auto& [a, b, c] : mesh.triangles) {
        const std::uint32_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
        result.triangles.insert(result.triangles.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
    }
    return result;
}

/// A small initial offset; a search over all poses would take seconds.
Eigen::Isometry3d nearPose(int set)
{
    Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
    pose.translate(Eigen::Vector3d(0.4, -0.3 - 0.2 * set, 0.5));
    pose.rotate(Eigen::AngleAxisd(0.02 + 0.01 * set, Eigen::Vector3d(1, 2, 0.3).normalized()));
    return pose;
}

/// A closed L with unequal legs: it has no rotational symmetry.
Scan angleSection()
{
    Scan mesh;
    for (const double z : {0.0, 25.0})
        for (const auto& [x, y] :
             {std::pair(0.0, 0.0), {60.0, 0.0}, {60.0, 12.0}, {15.0, 12.0}, {15.0, 40.0}, {0.0, 40.0}})
            mesh.points_mm.emplace_back(x, y, z);
    for (const auto& [a, b, c] : {std::array<std::uint32_t, 3>{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}}) {
        mesh.triangles.push_back({a, c, b});
        mesh.triangles.push_back({a + 6, b + 6, c + 6});
    }
    for (std::uint32_t a = 0; a < 6; ++a) {
        const std::uint32_t b = (a + 1) % 6;
        mesh.triangles.push_back({a, b, b + 6});
        mesh.triangles.push_back({a, b + 6, a + 6});
    }
    for (int times = 0; times < 2; ++times) mesh = refined(mesh);
    return mesh;
}

VerifyKind verifySelfComparison(const Progress& progress)
{
    VerifyTally tally("mesh_with_itself", LT_TEXT("Engine", "A mesh laid on itself"), unit::mm, 1e-6);
    const Scan part = angleSection();
    for (int set = 0; set < 2; ++set) {
        tally.nextSet();
        CompareParameters parameters;
        parameters.method = CompareMethod::Plane;
        parameters.symmetry = Symmetry::None;
        parameters.initial = InitialPose::Identity;
        const CompareResult result = compare(part, movedScan(part, nearPose(set)), parameters, progress.quiet());
        tally.take(result.statistics.rmse_mm);
    }
    return tally.done();
}

/// The mean deviation on the collar, whose oversize is known, by the points alone: facets would lie inside the circle.
VerifyKind verifyCollar(const Progress& progress)
{
    VerifyTally tally("known_deviation", LT_TEXT("Engine", "A collar with known oversize"), unit::mm, 1e-5);
    const auto points = [](double oversize_mm) {
        Scan scan = turned(shaftCorners(oversize_mm), 180);
        scan.triangles.clear();
        return scan;
    };
    const Scan reference = points(0);
    for (const double oversize_mm : {0.05, -0.03}) {
        tally.nextSet();
        const Scan copy = movedScan(points(oversize_mm), otherPose());
        const CompareResult result = compare(reference, copy, {}, progress.quiet());
        double sum = 0;
        int count = 0;
        for (std::size_t i = 0; i < copy.points_mm.size(); ++i) {
            const Eigen::Vector3d place = otherPose().inverse() * copy.points_mm[i];
            if (!result.used[i] || place.z() < 42 || place.z() > 50 || place.head<2>().norm() < 17) continue;
            sum += static_cast<double>(result.deviation_mm[i]);
            ++count;
        }
        tally.compare(count > 0 ? sum / count : std::nan(""), oversize_mm);
    }
    return tally.done();
}

}  // namespace

const VerifyPart& registrationVerification()
{
    static const VerifyPart part{"registration", {verifySelfComparison, verifyCollar}};
    return part;
}

}  // namespace lathelier::registration
