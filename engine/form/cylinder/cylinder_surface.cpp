#include "engine/form/cylinder/cylinder_surface.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "engine/core/parallel.h"
#include "engine/core/units.h"
#include "engine/form/cylinder/axis_frame.h"

namespace lathelier::form {
namespace {

constexpr std::size_t surfacePointsPerTask = 65536;
constexpr std::size_t mostRows = 200;
constexpr std::size_t pointsOfCell = 4;  ///< mean points per cell for sparse clouds

/// True for a point far outside the zone that holds all points evaluated: one that was left out (phantom_points.h).
bool isLeftOut(const FittedCylinder& cylinder, const Eigen::Vector3d& onAxis)
{
    constexpr double farFromZone = 10;  // widths of the zone
    const double width = cylinder.outer_radius_mm - cylinder.inner_radius_mm;
    const double distance = onAxis.head<2>().norm();
    return width > 0 && std::max(cylinder.inner_radius_mm - distance, distance - cylinder.outer_radius_mm) >
                            farFromZone * width + 1e-3;
}

double angleOf(const Eigen::Vector3d& onAxis)
{
    const double angle = std::atan2(onAxis.y(), onAxis.x()) * 180 / std::numbers::pi;
    return angle < 0 ? angle + 360 : angle;
}

void makeGrid(CylinderSurface& surface, double length_mm, std::size_t points, std::size_t sections)
{
    const auto unrolledCells = std::sqrt(static_cast<double>(std::max<std::size_t>(points / pointsOfCell, 1)));
    if (sections > 1 && sections <= mostRows) {
        surface.z_count = static_cast<int>(sections);
        surface.z_step_mm = length_mm / static_cast<double>(sections - 1);
        surface.z_start_mm = -0.5 * surface.z_step_mm;
    } else {
        surface.z_count = std::clamp(static_cast<int>(unrolledCells), 1, static_cast<int>(mostRows));
        surface.z_step_mm = std::max(length_mm, 1e-9) / surface.z_count;
        surface.z_start_mm = 0;
    }
    const double ofRow = static_cast<double>(points) / surface.z_count / static_cast<double>(pointsOfCell);
    surface.angle_count = std::clamp(static_cast<int>(ofRow), 12, 360);
}

/// First harmonic of the row's cells: centre of the least-squares circle (limaçon, exact for small offsets).
void findCentre(CylinderSurface& surface, std::size_t row)
{
    const auto angles = static_cast<std::size_t>(surface.angle_count);
    Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
    Eigen::Vector3d right = Eigen::Vector3d::Zero();
    std::size_t there = 0;
    for (std::size_t j = 0; j < angles; ++j) {
        const float value = surface.mean_um[row * angles + j];
        if (std::isnan(value)) continue;
        const double angle = 2 * std::numbers::pi * (static_cast<double>(j) + 0.5) / static_cast<double>(angles);
        const Eigen::Vector3d basis(1, std::cos(angle), std::sin(angle));
        normal += basis * basis.transpose();
        right += static_cast<double>(value) * basis;
        ++there;
    }
    const bool enough = 2 * there > angles;
    const Eigen::Vector3d fit =
        enough ? Eigen::Vector3d(normal.ldlt().solve(right)) : Eigen::Vector3d(notANumber, notANumber, notANumber);
    surface.mean_row_um[row] = there == 0 ? notANumber : enough ? fit[0] : right[0] / static_cast<double>(there);
    surface.centre_x_um[row] = fit[1];
    surface.centre_y_um[row] = fit[2];
}

}  // namespace

CylinderSurface surfaceAbout(const FittedCylinder& cylinder, std::span<const Eigen::Vector3d> points_mm,
                             std::size_t sections, const Progress& progress)
{
    CylinderSurface surface;
    surface.cylinder = cylinder;
    const AxisFrame frame(cylinder.axis_direction);
    surface.axis_T_points.linear() = frame.local_R_world;
    surface.axis_T_points.translation() = -frame.toLocal(cylinder.axis_point_mm);
    double lowest = std::numeric_limits<double>::infinity();
    double highest = -lowest;
    for (const Eigen::Vector3d& point : points_mm) {
        if (isLeftOut(cylinder, surface.axis_T_points * point)) continue;
        const double z = surface.axis_T_points.matrix().row(2).head<3>().dot(point) + surface.axis_T_points(2, 3);
        lowest = std::min(lowest, z);
        highest = std::max(highest, z);
    }
    if (!(lowest <= highest)) return surface;
    surface.axis_T_points.pretranslate(Eigen::Vector3d(0, 0, -lowest));
    progress.report(0.2);

    makeGrid(surface, highest - lowest, points_mm.size(), sections);
    const auto rows = static_cast<std::size_t>(surface.z_count), angles = static_cast<std::size_t>(surface.angle_count);
    surface.deviation_mm.resize(points_mm.size());
    constexpr auto none = std::numeric_limits<std::uint32_t>::max();
    std::vector<std::uint32_t> cells(points_mm.size());
    parallelFor(
        points_mm.size(), surfacePointsPerTask, progress.part(0.2, 0.7), [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) {
                const Eigen::Vector3d p = surface.axis_T_points * points_mm[i];
                cells[i] = none;
                if (isLeftOut(cylinder, p)) continue;
                surface.deviation_mm[i] = static_cast<float>(p.head<2>().norm() - cylinder.radius_mm);
                const auto row = std::clamp<std::ptrdiff_t>(
                    static_cast<std::ptrdiff_t>((p.z() - surface.z_start_mm) / surface.z_step_mm), 0,
                    surface.z_count - 1);
                const auto column = std::clamp<std::ptrdiff_t>(
                    static_cast<std::ptrdiff_t>(angleOf(p) / 360 * surface.angle_count), 0, surface.angle_count - 1);
                cells[i] = static_cast<std::uint32_t>(row * surface.angle_count + column);
            }
        });
    std::vector<double> sums(rows * angles, 0);
    std::vector<std::uint32_t> counts(rows * angles, 0);
    surface.lowest_um.assign(rows, notANumber);
    surface.highest_um.assign(rows, notANumber);
    for (std::size_t i = 0; i < points_mm.size(); ++i) {
        if (cells[i] == none) continue;
        const double deviation_um = um_per_mm * static_cast<double>(surface.deviation_mm[i]);
        sums[cells[i]] += deviation_um;
        ++counts[cells[i]];
        const std::size_t row = cells[i] / angles;
        surface.lowest_um[row] = std::fmin(surface.lowest_um[row], deviation_um);
        surface.highest_um[row] = std::fmax(surface.highest_um[row], deviation_um);
    }
    surface.mean_um.resize(rows * angles);
    for (std::size_t k = 0; k < sums.size(); ++k)
        surface.mean_um[k] = counts[k] ? static_cast<float>(sums[k] / counts[k]) : static_cast<float>(notANumber);
    surface.mean_row_um.resize(rows);
    surface.centre_x_um.resize(rows);
    surface.centre_y_um.resize(rows);
    for (std::size_t row = 0; row < rows; ++row) {
        surface.z_mm.push_back(surface.z_start_mm + (static_cast<double>(row) + 0.5) * surface.z_step_mm);
        findCentre(surface, row);
    }
    progress.report(1);
    return surface;
}

Skin skinOf(const CylinderSurface& surface)
{
    const auto rows = static_cast<std::size_t>(surface.z_count), angles = static_cast<std::size_t>(surface.angle_count);
    const double radius_mm = surface.cylinder.radius_mm;
    const double end_mm = surface.z_start_mm + surface.z_step_mm * surface.z_count;
    Skin skin;
    skin.angle_count = surface.angle_count;
    const auto add = [&skin](double z_mm, double r_mm, const Eigen::Vector2d& normal) {
        skin.stations.push_back({z_mm, r_mm, normal});
    };
    add(surface.z_start_mm, 0, -Eigen::Vector2d::UnitX());
    add(surface.z_start_mm, radius_mm, -Eigen::Vector2d::UnitX());
    const std::size_t first = skin.stations.size();
    add(surface.z_start_mm, radius_mm, Eigen::Vector2d::UnitY());
    for (std::size_t row = 0; row < rows; ++row) add(surface.z_mm[row], radius_mm, Eigen::Vector2d::UnitY());
    add(end_mm, radius_mm, Eigen::Vector2d::UnitY());
    add(end_mm, radius_mm, Eigen::Vector2d::UnitX());
    add(end_mm, 0, Eigen::Vector2d::UnitX());
    skin.values.assign(skin.vertexCount(), static_cast<float>(notANumber));
    for (std::size_t station = first; station < first + rows + 2; ++station) {
        const std::size_t row = std::clamp<std::size_t>(station, first + 1, first + rows) - first - 1;
        for (std::size_t angle = 0; angle < angles; ++angle) {
            // A vertex lies between two cells.
            const double before = static_cast<double>(surface.mean_um[row * angles + (angle + angles - 1) % angles]);
            const double after = static_cast<double>(surface.mean_um[row * angles + angle]);
            const double mean = std::isnan(before) ? after : std::isnan(after) ? before : (before + after) / 2;
            skin.values[station * angles + angle] = static_cast<float>(mean / um_per_mm);
        }
    }
    skin.shift_mm = normalShift_mm(skin);
    return skin;
}

Eigen::Vector3d placeOnCylinder(const CylinderSurface& surface, double z_mm, double angle_deg)
{
    const double angle = angle_deg * std::numbers::pi / 180, radius = surface.cylinder.radius_mm;
    return surface.axis_T_points.inverse() * Eigen::Vector3d(radius * std::cos(angle), radius * std::sin(angle), z_mm);
}

Eigen::Vector2d placeAbout(const CylinderSurface& surface, const Eigen::Vector3d& point_mm)
{
    const Eigen::Vector3d onAxis = surface.axis_T_points * point_mm;
    return {onAxis.z(), angleOf(onAxis)};
}

}  // namespace lathelier::form
