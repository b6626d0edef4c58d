#include "engine/trajectory/stacked_sections.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/report/colours.h"

namespace lathelier::trajectory {

namespace {

constexpr std::size_t angles = 360;
constexpr double usualMagnification = 1000;
constexpr double mostOfRadius = 0.5;  // largest drawn deviation relative to the radius

double positiveAngle(double angle_rad)
{
    const double turn = 2 * std::numbers::pi;
    const double rest = std::fmod(angle_rad, turn);
    return rest < 0 ? rest + turn : rest;
}

/// Deviations of closed points at even angles about a centre: linear between neighbours in angle.
std::vector<double> radiiAtEvenAngles(const std::vector<Eigen::Vector2d>& points_mm, const Eigen::Vector2d& centre_mm)
{
    std::vector<std::pair<double, double>> polar;
    for (const Eigen::Vector2d& point : points_mm) {
        const Eigen::Vector2d arm = point - centre_mm;
        polar.emplace_back(positiveAngle(std::atan2(arm.y(), arm.x())), arm.norm());
    }
    std::sort(polar.begin(), polar.end());
    std::vector<double> radii(angles, 0);
    if (polar.empty()) return radii;
    std::size_t next = 0;
    for (std::size_t i = 0; i < angles; ++i) {
        const double angle = 2 * std::numbers::pi * static_cast<double>(i) / angles;
        while (next < polar.size() && polar[next].first < angle) ++next;
        const auto& [a, ra] = polar[(next + polar.size() - 1) % polar.size()];
        const auto& [b, rb] = polar[next % polar.size()];
        const double span = positiveAngle(b - a);
        const double share = span > 0 ? positiveAngle(angle - a) / span : 0;
        radii[i] = ra + share * (rb - ra);
    }
    return radii;
}

/// The least-squares line through the centres of the sections, at each of them.
std::vector<Eigen::Vector2d> axisOf(const trajectory::TrajectoryResult& result)
{
    const auto count = static_cast<double>(result.sections.size());
    double mean_z = 0;
    Eigen::Vector2d mean = Eigen::Vector2d::Zero();
    for (const trajectory::TrajectorySection& section : result.sections) {
        mean_z += section.z_mm / count;
        mean += section.roundness.circles.LSCI.centre_mm / count;
    }
    double squares = 0;
    Eigen::Vector2d products = Eigen::Vector2d::Zero();
    for (const trajectory::TrajectorySection& section : result.sections) {
        const double away = section.z_mm - mean_z;
        squares += away * away;
        products += away * (section.roundness.circles.LSCI.centre_mm - mean);
    }
    const bool has_slope = std::isfinite(squares) && squares > 0;
    std::vector<Eigen::Vector2d> axis;
    for (const trajectory::TrajectorySection& section : result.sections)
        axis.emplace_back(has_slope ? Eigen::Vector2d(mean + (section.z_mm - mean_z) / squares * products) : mean);
    return axis;
}

double roundedDown(double value)
{
    const double power = std::pow(10, std::floor(std::log10(value)));
    const double lead = value / power;
    return (lead >= 5 ? 5 : lead >= 2 ? 2 : 1) * power;
}

}  // namespace

std::size_t StackedSections::vertexAt(std::size_t section, double angle_deg) const
{
    const auto step = static_cast<std::size_t>(std::lround(angle_deg / 360 * static_cast<double>(angles)));
    return section * angles + step % angles;
}

StackedSections stackedSections(const trajectory::TrajectoryResult& result, bool form_only,
                                std::optional<double> magnification)
{
    StackedSections stack;
    stack.angles = angles;
    const std::size_t count = result.sections.size();
    if (count < 2) return stack;
    double mean_mm = 0;
    for (const trajectory::TrajectorySection& section : result.sections)
        mean_mm += section.roundness.circles.LSCI.radius_mm;
    mean_mm /= static_cast<double>(count);

    const std::vector<Eigen::Vector2d> axis_mm = axisOf(result);
    std::vector<std::vector<double>> deviation(count);
    double reach_mm = 1e-7;
    for (std::size_t i = 0; i < count; ++i) {
        const form::RoundnessResult& form = result.sections[i].roundness;
        const form::FittedCircle& circle = form.circles.LSCI;
        deviation[i] = radiiAtEvenAngles(form.evaluated_mm, form_only ? circle.centre_mm : axis_mm[i]);
        for (double& radius : deviation[i]) {
            radius -= form_only ? circle.radius_mm : mean_mm;
            reach_mm = std::max(reach_mm, std::abs(radius));
        }
    }
    stack.limit_um = report::niceLimit(1000 * reach_mm);
    stack.magnification =
        magnification.value_or(std::clamp(roundedDown(mostOfRadius * mean_mm / reach_mm), 1.0, usualMagnification));

    // z is scaled relative to the diameter, so that neither a long bar nor a disc becomes unreadable.
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const trajectory::TrajectorySection& section : result.sections) {
        low = std::min(low, section.z_mm);
        high = std::max(high, section.z_mm);
    }
    const bool known = std::isfinite(low) && std::isfinite(high) && high > low;
    auto scan = std::make_shared<Scan>();
    auto values = std::make_shared<std::vector<float>>();
    for (std::size_t i = 0; i < count; ++i) {
        const double z_mm = known ? result.sections[i].z_mm : static_cast<double>(i) * mean_mm / 5;
        for (std::size_t k = 0; k < angles; ++k) {
            const double angle = 2 * std::numbers::pi * static_cast<double>(k) / angles;
            const double radius = mean_mm + stack.magnification * deviation[i][k];
            scan->points_mm.emplace_back(radius * std::cos(angle), radius * std::sin(angle), z_mm);
            values->push_back(static_cast<float>(1000 * deviation[i][k]));
        }
    }
    stack.length_mm = known ? high - low : static_cast<double>(count - 1) * mean_mm / 5;
    // Orientation of the triangles: outward for increasing angle and z.
    const bool rises = scan->points_mm.back().z() > scan->points_mm.front().z();
    for (std::size_t i = 0; i + 1 < count; ++i)
        for (std::size_t k = 0; k < angles; ++k) {
            const auto a = static_cast<std::uint32_t>(i * angles + k);
            const auto b = static_cast<std::uint32_t>(i * angles + (k + 1) % angles);
            const auto c = static_cast<std::uint32_t>(a + angles), d = static_cast<std::uint32_t>(b + angles);
            if (rises) {
                scan->triangles.push_back({a, b, d});
                scan->triangles.push_back({a, d, c});
            } else {
                scan->triangles.push_back({a, d, b});
                scan->triangles.push_back({a, c, d});
            }
        }
    stack.scan = scan;
    stack.deviation_um = values;
    return stack;
}

}  // namespace lathelier::trajectory
