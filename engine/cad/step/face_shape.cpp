#include "engine/cad/step/face_shape.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace lathelier::cad {

using Eigen::Vector3d;

double angleOf_deg(const Vector3d& direction)
{
    return restOfTurn_deg(std::atan2(direction.y(), direction.x()) * 180 / std::numbers::pi, 360);
}

double restOfTurn_deg(double angle_deg, double turn_deg)
{
    constexpr double rounding_deg = 1e-9;
    const double rest = std::fmod(angle_deg, turn_deg);
    const double result = rest < 0 ? rest + turn_deg : rest;
    return turn_deg - result < rounding_deg ? 0 : result;
}

bool FaceShape::isPlaneAlong() const
{
    return kind == SurfaceKind::Plane && std::abs(axis.z()) < alignedAngle;
}

bool FaceShape::isPlaneAcross() const
{
    return kind == SurfaceKind::Plane && areParallel(axis, Vector3d::UnitZ());
}

Span spanOf(const FaceShape& face, const Vector3d& direction)
{
    if (face.boundary.empty()) return {};
    Span span{face.boundary.front().dot(direction), face.boundary.front().dot(direction)};
    for (const Vector3d& point : face.boundary) {
        span.low = std::min(span.low, point.dot(direction));
        span.high = std::max(span.high, point.dot(direction));
    }
    return span;
}

bool areParallel(const Vector3d& a, const Vector3d& b)
{
    return a.cross(b).norm() < alignedAngle;
}

bool arePerpendicular(const Vector3d& a, const Vector3d& b)
{
    return std::abs(a.dot(b)) < alignedAngle;
}

double distanceOfLines(const Vector3d& point, const Vector3d& other, const Vector3d& direction)
{
    return (other - point).cross(direction).norm();
}

bool runsAllRound(const FaceShapes& faces, const Vector3d& point, const Vector3d& direction)
{
    constexpr double widest_rad = 40 * std::numbers::pi / 180;  // a circle's edge has 24 points, two half ones 48
    const Vector3d u = direction.unitOrthogonal(), v = direction.cross(u);
    std::vector<double> angles;
    for (const FaceShape* face : faces)
        for (const Vector3d& at : face->boundary)
            angles.push_back(std::atan2((at - point).dot(v), (at - point).dot(u)));
    if (angles.empty()) return false;
    std::sort(angles.begin(), angles.end());
    double widest = angles.front() + 2 * std::numbers::pi - angles.back();
    for (std::size_t i = 0; i + 1 < angles.size(); ++i) widest = std::max(widest, angles[i + 1] - angles[i]);
    return widest < widest_rad;
}

std::vector<FaceShapes> connected(const FaceShapes& faces)
{
    std::vector<std::size_t> group(faces.size());
    for (std::size_t i = 0; i < group.size(); ++i) group[i] = i;
    const auto root = [&](std::size_t i) {
        while (group[i] != i) i = group[i] = group[group[i]];
        return i;
    };
    std::vector<std::pair<int, std::size_t>> edges;
    for (std::size_t i = 0; i < faces.size(); ++i)
        for (const int edge : faces[i]->edge_numbers) edges.emplace_back(edge, i);
    std::sort(edges.begin(), edges.end());
    for (std::size_t i = 0; i + 1 < edges.size(); ++i) {
        if (edges[i].first != edges[i + 1].first) continue;
        const std::size_t a = root(edges[i].second), b = root(edges[i + 1].second);
        group[std::max(a, b)] = std::min(a, b);
    }
    std::vector<FaceShapes> result(faces.size());
    for (std::size_t i = 0; i < faces.size(); ++i) result[root(i)].push_back(faces[i]);
    std::erase_if(result, [](const auto& one) { return one.empty(); });
    return result;
}

}  // namespace lathelier::cad
