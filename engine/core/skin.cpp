#include "engine/core/skin.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/core/parallel.h"

namespace lathelier {
namespace {

constexpr double smoothCorner_rad = 20 * std::numbers::pi / 180;

Eigen::Vector2d normalOf(const Eigen::Vector2d& from, const Eigen::Vector2d& to)
{
    const Eigen::Vector2d way = (to - from).normalized();
    return {-way.y(), way.x()};
}

/// Fills the unknown (NaN) values of a column linearly over the length of the meridian between the known ones, those
/// beyond the first and the last as these; all unknown: 0.
void fillUnknown(std::vector<double>& values, const std::vector<double>& length_mm)
{
    constexpr std::size_t none = std::numeric_limits<std::size_t>::max();
    std::size_t before = none;
    for (std::size_t i = 0; i < values.size();) {
        if (!std::isnan(values[i])) {
            before = i++;
            continue;
        }
        std::size_t after = i;
        while (after < values.size() && std::isnan(values[after])) ++after;
        for (; i < after; ++i) {
            if (before == none && after == values.size())
                values[i] = 0;
            else if (before == none)
                values[i] = values[after];
            else if (after == values.size())
                values[i] = values[before];
            else {
                const double whole_mm = length_mm[after] - length_mm[before];
                const double share = whole_mm > 0 ? (length_mm[i] - length_mm[before]) / whole_mm : 0.5;
                values[i] = values[before] + share * (values[after] - values[before]);
            }
        }
    }
}

std::vector<double> lengthsAlong(const std::vector<SkinStation>& stations)
{
    std::vector<double> length_mm(stations.size());
    for (std::size_t i = 1; i < stations.size(); ++i)
        length_mm[i] = length_mm[i - 1] + std::hypot(stations[i].z_mm - stations[i - 1].z_mm,
                                                     stations[i].radius_mm - stations[i - 1].radius_mm);
    return length_mm;
}

Eigen::Vector2d directionOf(const Skin& skin, std::size_t column)
{
    const double angle = 2 * std::numbers::pi * static_cast<double>(column) / skin.angle_count;
    return {std::cos(angle), std::sin(angle)};
}

/// Normals of a displaced surface, from its triangles. Where neighbouring stations make an edge, each keeps its own.
void addNormals(Scan& mesh)
{
    std::vector<Eigen::Vector3d> sums(mesh.points_mm.size(), Eigen::Vector3d::Zero());
    for (const auto& corners : mesh.triangles) {
        const Eigen::Vector3d& a = mesh.points_mm[corners[0]];
        const Eigen::Vector3d twice_area = (mesh.points_mm[corners[1]] - a).cross(mesh.points_mm[corners[2]] - a);
        for (const std::uint32_t corner : corners) sums[corner] += twice_area;
    }
    mesh.normals.reserve(sums.size());
    for (const Eigen::Vector3d& sum : sums)
        mesh.normals.push_back(sum.isZero() ? Eigen::Vector3f::UnitZ() : sum.normalized().cast<float>().eval());
}

}  // namespace

double Skin::largestRadius() const
{
    double radius_mm = 0;
    for (const SkinStation& station : stations) radius_mm = std::max(radius_mm, station.radius_mm);
    return radius_mm;
}

std::vector<SkinStation> stationsAlong(const std::vector<Eigen::Vector2d>& line_mm, double step_mm)
{
    std::vector<Eigen::Vector2d> line;
    for (const Eigen::Vector2d& place : line_mm)
        if (line.empty() || (place - line.back()).norm() > 1e-9) line.push_back(place);
    std::vector<SkinStation> stations;
    const auto add = [&stations](const Eigen::Vector2d& place, const Eigen::Vector2d& normal) {
        stations.push_back({place.x(), place.y(), normal});
    };
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
        const Eigen::Vector2d normal = normalOf(line[i], line[i + 1]);
        const Eigen::Vector2d before = i > 0 ? normalOf(line[i - 1], line[i]) : normal;
        const bool is_smooth = before.dot(normal) > std::cos(smoothCorner_rad);
        if (i > 0 && is_smooth) stations.back().normal = (before + normal).normalized();
        if (i == 0 || !is_smooth) add(line[i], normal);
        const double length_mm = (line[i + 1] - line[i]).norm();
        const auto parts = std::max(1L, std::lround(std::ceil(length_mm / step_mm)));
        for (long part = 1; part <= parts; ++part)
            add(line[i] + (line[i + 1] - line[i]) * static_cast<double>(part) / static_cast<double>(parts), normal);
    }
    return stations;
}

std::vector<Eigen::Vector3f> normalShift_mm(const Skin& skin)
{
    const auto columns = static_cast<std::size_t>(skin.angle_count);
    const std::vector<double> length_mm = lengthsAlong(skin.stations);
    std::vector<Eigen::Vector3f> shift_mm(skin.vertexCount());
    parallelFor(columns, 8, {}, [&](std::size_t begin, std::size_t end) {
        std::vector<double> across(skin.stations.size()), along(skin.stations.size());
        for (std::size_t column = begin; column < end; ++column) {
            for (std::size_t row = 0; row < skin.stations.size(); ++row) {
                const SkinStation& station = skin.stations[row];
                const auto value = static_cast<double>(skin.values[row * columns + column]);
                constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
                across[row] = station.isFace() ? unknown : value / station.normal.y();
                along[row] = station.isFace() ? value / station.normal.x() : unknown;
            }
            fillUnknown(across, length_mm);
            fillUnknown(along, length_mm);
            const Eigen::Vector2d direction = directionOf(skin, column);
            for (std::size_t row = 0; row < skin.stations.size(); ++row) {
                const double radial = skin.stations[row].radius_mm > 0 ? across[row] : 0;
                shift_mm[row * columns + column] =
                    Eigen::Vector3d(radial * direction.x(), radial * direction.y(), along[row]).cast<float>();
            }
        }
    });
    // The vertices of a place on the axis stay there, and together.
    for (std::size_t row = 0; row < skin.stations.size(); ++row) {
        if (skin.stations[row].radius_mm > 0) continue;
        const auto first = shift_mm.begin() + static_cast<std::ptrdiff_t>(row * columns);
        const auto last = first + static_cast<std::ptrdiff_t>(columns);
        Eigen::Vector3f mean = Eigen::Vector3f::Zero();
        for (auto shift = first; shift != last; ++shift) mean += *shift / static_cast<float>(columns);
        std::fill(first, last, mean);
    }
    return shift_mm;
}

double readableFactor(double most)
{
    if (!(most > 1)) return 1;
    const double power = std::pow(10.0, std::floor(std::log10(most)));
    for (const double factor : {5.0, 2.0})
        if (factor * power <= most) return factor * power;
    return power;
}

Eigen::Vector3d vertexOf(const Skin& skin, std::size_t vertex, double factor)
{
    const auto columns = static_cast<std::size_t>(skin.angle_count);
    const SkinStation& station = skin.stations[vertex / columns];
    const Eigen::Vector2d direction = directionOf(skin, vertex % columns);
    Eigen::Vector3d place(station.radius_mm * direction.x(), station.radius_mm * direction.y(), station.z_mm);
    if (skin.shift_mm.empty()) return place;
    const Eigen::Vector3d shift = factor * skin.shift_mm[vertex].cast<double>();
    return place + shift;
}

Scan meshOf(const Skin& skin, double factor, const Eigen::Isometry3d& frame_T_axis)
{
    const auto columns = static_cast<std::size_t>(skin.angle_count);
    const std::size_t rows = skin.stations.size();
    Scan mesh;
    mesh.points_mm.resize(skin.vertexCount());
    parallelFor(mesh.points_mm.size(), 16384, {}, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) mesh.points_mm[i] = frame_T_axis * vertexOf(skin, i, factor);
    });
    mesh.triangles.reserve(2 * rows * columns);
    const auto add = [&](std::size_t a, std::size_t b, std::size_t c) {
        mesh.triangles.push_back(
            {static_cast<std::uint32_t>(a), static_cast<std::uint32_t>(b), static_cast<std::uint32_t>(c)});
    };
    for (std::size_t row = 0; row + 1 < rows; ++row) {
        const std::size_t next = row + 1;
        const SkinStation& from = skin.stations[row];
        const SkinStation& to = skin.stations[next];
        if (from.z_mm == to.z_mm && from.radius_mm == to.radius_mm) continue;  // the two sides of an edge
        for (std::size_t column = 0; column < columns; ++column) {
            const std::size_t beside = (column + 1) % columns;
            if (from.radius_mm > 0) add(row * columns + column, row * columns + beside, next * columns + column);
            if (to.radius_mm > 0) add(row * columns + beside, next * columns + beside, next * columns + column);
        }
    }
    addNormals(mesh);
    return mesh;
}

Eigen::Vector3d placeOn(const Skin& skin, const MeshPlace& place)
{
    Eigen::Vector3d found = Eigen::Vector3d::Zero();
    for (std::size_t i = 0; i < 3; ++i)
        found += place.weights[static_cast<Eigen::Index>(i)] * vertexOf(skin, place.corners[i], 0);
    return found;
}

std::size_t nearestVertex(const Skin& skin, const Eigen::Vector3d& axis_place_mm)
{
    const double radius_mm = axis_place_mm.head<2>().norm();
    std::size_t nearest = 0;
    double least = HUGE_VAL;
    for (std::size_t row = 0; row < skin.stations.size(); ++row) {
        const double away =
            std::hypot(skin.stations[row].z_mm - axis_place_mm.z(), skin.stations[row].radius_mm - radius_mm);
        if (away >= least) continue;
        least = away;
        nearest = row;
    }
    const double turn = std::atan2(axis_place_mm.y(), axis_place_mm.x()) / (2 * std::numbers::pi) + 1;
    const auto column = std::lround(turn * skin.angle_count) % skin.angle_count;
    return nearest * static_cast<std::size_t>(skin.angle_count) + static_cast<std::size_t>(column);
}

Eigen::Vector3d displacedPlace(const Skin& skin, const Eigen::Vector3d& axis_place_mm, double factor)
{
    if (skin.shift_mm.empty()) return axis_place_mm;
    const std::size_t vertex = nearestVertex(skin, axis_place_mm);
    const Eigen::Vector3d shift = factor * skin.shift_mm[vertex].cast<double>();
    const double radius_mm = axis_place_mm.head<2>().norm();
    if (!(radius_mm > 0)) return axis_place_mm + shift;
    const Eigen::Vector2d there = directionOf(skin, vertex % static_cast<std::size_t>(skin.angle_count));
    const Eigen::Vector2d here = axis_place_mm.head<2>() / radius_mm;
    const double across = shift.head<2>().dot(there), about = shift.y() * there.x() - shift.x() * there.y();
    Eigen::Vector3d place = axis_place_mm;
    place.head<2>() += across * here + about * Eigen::Vector2d(-here.y(), here.x());
    place.z() += shift.z();
    return place;
}

}  // namespace lathelier
