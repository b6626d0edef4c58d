#include "engine/form/roundness/section_of_points.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "engine/core/core_codes.h"
#include "engine/core/error.h"

namespace lathelier::form {
namespace {

constexpr std::size_t leastSectionPoints = 12;
constexpr std::size_t pointsOfAngle = 20;
constexpr std::size_t sparse = 2000;  ///< sections with fewer points are used without averaging
constexpr std::size_t mostAngles = 720;
constexpr std::size_t leastAngles = 36;
constexpr std::size_t checkEvery = 65536;

double turnOf(const Eigen::Vector2d& place)
{
    const double turn = std::atan2(place.y(), place.x()) / (2 * std::numbers::pi);
    return turn < 0 ? turn + 1 : turn;
}

}  // namespace

Profile sectionOfPoints(std::span<const Eigen::Vector3d> points_mm, const Eigen::Isometry3d& axis_T_points,
                        const SectionCut& cut, const Progress& progress)
{
    std::vector<Eigen::Vector2d> inside;
    for (std::size_t i = 0; i < points_mm.size(); ++i) {
        if (i % checkEvery == 0) progress.check();
        const Eigen::Vector3d place = axis_T_points * points_mm[i];
        if (std::abs(place.z() - cut.z_mm) <= cut.width_mm / 2) inside.emplace_back(place.head<2>());
    }
    if (inside.size() < leastSectionPoints)
        throw Error(errors::tooFewPoints, {{"found", static_cast<std::int64_t>(inside.size())},
                                           {"minimum", static_cast<std::int64_t>(leastSectionPoints)}});
    Profile profile;
    if (inside.size() <= sparse) {
        std::stable_sort(inside.begin(), inside.end(),
                         [](const auto& a, const auto& b) { return turnOf(a) < turnOf(b); });
        profile.points_mm = std::move(inside);
        return profile;
    }
    const std::size_t angles = std::clamp(inside.size() / pointsOfAngle, leastAngles, mostAngles);
    struct Sum {
        double radius = 0, turn = 0;
        std::size_t count = 0;
    };
    std::vector<Sum> sums(angles);
    for (const Eigen::Vector2d& place : inside) {
        const double turn = turnOf(place);
        Sum& sum = sums[std::min(static_cast<std::size_t>(turn * static_cast<double>(angles)), angles - 1)];
        sum.radius += place.norm();
        sum.turn += turn;
        ++sum.count;
    }
    for (const Sum& sum : sums) {
        if (sum.count == 0) continue;
        const auto count = static_cast<double>(sum.count);
        const double angle = 2 * std::numbers::pi * sum.turn / count;
        profile.points_mm.emplace_back(sum.radius / count * std::cos(angle), sum.radius / count * std::sin(angle));
    }
    return profile;
}

}  // namespace lathelier::form
