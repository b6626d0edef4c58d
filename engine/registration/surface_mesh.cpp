#include "engine/registration/surface_mesh.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

#include "engine/core/parallel.h"
#include "engine/registration/neighbours_order.h"

namespace lathelier {
namespace {

double angle(const Eigen::Vector3d& a, const Eigen::Vector3d& b)
{
    return std::atan2(a.cross(b).norm(), a.dot(b));
}

// One number for all vertices with the same coordinates.
std::vector<std::uint32_t> numberCorners(const std::vector<Eigen::Vector3d>& points, std::uint32_t& count)
{
    std::vector<std::uint32_t> order(points.size());
    std::iota(order.begin(), order.end(), 0U);
    const auto before = [&](std::uint32_t a, std::uint32_t b) {
        return std::tie(points[a].x(), points[a].y(), points[a].z(), a) <
               std::tie(points[b].x(), points[b].y(), points[b].z(), b);
    };
    std::sort(order.begin(), order.end(), before);
    std::vector<std::uint32_t> numbers(points.size());
    count = 0;
    for (std::size_t i = 0; i < order.size(); ++i) {
        if (i > 0 && points[order[i]] != points[order[i - 1]]) ++count;
        numbers[order[i]] = count;
    }
    count = points.empty() ? 0 : count + 1;
    return numbers;
}

}  // namespace

Eigen::Vector3d MeshSurface::Triangle::normal() const
{
    return (corners_mm[1] - corners_mm[0]).cross(corners_mm[2] - corners_mm[0]);
}

MeshSurface::MeshSurface(const Scan& mesh, const Progress& progress)
{
    std::uint32_t corner_count = 0;
    const std::vector<std::uint32_t> numbers = numberCorners(mesh.points_mm, corner_count);
    progress.report(0.2);
    std::vector<Eigen::Vector3d> centres;
    centres.reserve(mesh.triangles.size());
    for (const auto& t : mesh.triangles)
        centres.push_back((mesh.points_mm[t[0]] + mesh.points_mm[t[1]] + mesh.points_mm[t[2]]) / 3);
    const std::vector<std::uint32_t> order = hilbertOrder(centres, progress);
    triangles_.resize(order.size());
    std::vector<Box> boxes((order.size() + leaf_size - 1) / leaf_size);
    for (std::size_t i = 0; i < order.size(); ++i) {
        const auto& t = mesh.triangles[order[i]];
        Triangle& triangle = triangles_[i];
        for (std::size_t k = 0; k < 3; ++k) {
            triangle.corners_mm[k] = mesh.points_mm[t[k]];
            triangle.corners[k] = numbers[t[k]];
            boxes[i / leaf_size].add(triangle.corners_mm[k]);
            if (mesh.hasNormals()) given_normals_ += mesh.normals[t[k]].cast<double>().dot(triangle.normal());
        }
    }
    progress.report(0.6);
    boxes_ = BoxTree(boxes, progress);
    corner_normals_.assign(corner_count, Eigen::Vector3d::Zero());
    corner_on_rim_.assign(corner_count, false);
    connect(progress);
}

void MeshSurface::connect(const Progress& progress)
{
    struct Edge {
        std::uint64_t corners;  // smaller number in the upper half
        std::uint32_t triangle;
        std::uint8_t side;
        bool forward;
    };
    std::vector<Edge> edges;
    edges.reserve(3 * triangles_.size());
    for (std::uint32_t t = 0; t < triangles_.size(); ++t) {
        Triangle& triangle = triangles_[t];
        const Eigen::Vector3d product = triangle.normal();
        const Eigen::Vector3d unit = product.norm() > 0 ? product.normalized() : Eigen::Vector3d::Zero();
        volume_mm3_ += (triangle.corners_mm[0] - triangles_[0].corners_mm[0]).dot(product) / 6;
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t a = triangle.corners[k];
            const std::uint32_t b = triangle.corners[(k + 1) % 3];
            const Eigen::Vector3d& p = triangle.corners_mm[k];
            corner_normals_[a] +=
                angle(triangle.corners_mm[(k + 1) % 3] - p, triangle.corners_mm[(k + 2) % 3] - p) * unit;
            triangle.edge_normals[k] = unit.cast<float>();
            if (a != b)
                edges.push_back(
                    {std::uint64_t{std::min(a, b)} << 32 | std::max(a, b), t, static_cast<std::uint8_t>(k), a < b});
        }
    }
    progress.report(0.75);
    std::sort(edges.begin(), edges.end(), [](const Edge& a, const Edge& b) {
        return std::tie(a.corners, a.triangle, a.side) < std::tie(b.corners, b.triangle, b.side);
    });
    progress.report(0.95);
    closed_ = true;
    for (std::size_t i = 0; i < edges.size();) {
        std::size_t j = i;
        int sense = 0;
        Eigen::Vector3f sum = Eigen::Vector3f::Zero();
        for (; j < edges.size() && edges[j].corners == edges[i].corners; ++j) {
            sense += edges[j].forward ? 1 : -1;
            sum += triangles_[edges[j].triangle].edge_normals[edges[j].side];
        }
        if (sense != 0) closed_ = false;
        for (std::size_t e = i; e < j; ++e) triangles_[edges[e].triangle].edge_normals[edges[e].side] = sum;
        if (j - i == 1) {
            triangles_[edges[i].triangle].rim |= static_cast<std::uint8_t>(1U << edges[i].side);
            corner_on_rim_[edges[i].corners >> 32] = true;
            corner_on_rim_[edges[i].corners & 0xffffffff] = true;
        }
        i = j;
    }
}

SurfacePlace MeshSurface::placeOne(const Eigen::Vector3d& query_mm, double max_distance_mm, std::uint32_t& hint) const
{
    TrianglePoint best{};
    std::uint32_t where = no_hint;
    double bound = std::nextafter(max_distance_mm * max_distance_mm, std::numeric_limits<double>::infinity());
    const auto look = [&](std::uint32_t leaf, double& limit) {
        const std::uint32_t end = std::min((leaf + 1) * leaf_size, static_cast<std::uint32_t>(triangles_.size()));
        for (std::uint32_t t = leaf * leaf_size; t < end; ++t) {
            const TrianglePoint here = nearestOnTriangle(query_mm, triangles_[t].corners_mm);
            const double squared = (here.point_mm - query_mm).squaredNorm();
            if (squared < limit) {
                limit = squared;
                best = here;
                where = t;
            }
        }
    };
    if (hint != no_hint) look(hint / leaf_size, bound);
    boxes_.visit(Box(query_mm), bound, look);
    SurfacePlace place;
    if (where == no_hint) return place;
    hint = where;
    const Triangle& triangle = triangles_[where];
    const auto part = static_cast<std::size_t>(best.part);
    Eigen::Vector3d normal = triangle.normal();
    if (part < 3)
        normal = corner_normals_[triangle.corners[part]];
    else if (part < 6)
        normal = triangle.edge_normals[part - 3].cast<double>();
    place.border =
        part < 3 ? corner_on_rim_[triangle.corners[part]] : part < 6 && (triangle.rim >> (part - 3) & 1) != 0;
    const Eigen::Vector3d offset = query_mm - best.point_mm;
    const double side = sense_ * offset.dot(normal) < 0 ? -1 : 1;
    const double distance = std::sqrt(bound);
    place.distance_mm = side * distance;
    // Beside an edge the direction to it is the normal there; on the surface itself the triangle's.
    const bool beside = part < 6 && distance > 1e-9 * (1 + triangle.corners_mm[0].cwiseAbs().maxCoeff());
    place.normal = beside ? Eigen::Vector3d(side * offset / distance)
                          : Eigen::Vector3d(sense_ * triangle.normal().stableNormalized());
    return place;
}

void MeshSurface::place(std::span<const Eigen::Vector3d> queries_mm, double max_distance_mm,
                        std::span<SurfacePlace> places, std::span<std::uint32_t> hints) const
{
    std::uint32_t last = no_hint;  // queries lie near each other
    for (std::size_t q = 0; q < queries_mm.size(); ++q) {
        if (hints[q] == no_hint) hints[q] = last;
        places[q] = placeOne(queries_mm[q], max_distance_mm, hints[q]);
        last = hints[q];
    }
}

bool MeshSurface::orient(const Progress&)
{
    if (given_normals_ != 0)
        sense_ = given_normals_ < 0 ? -1 : 1;
    else if (closed_ && volume_mm3_ != 0)
        sense_ = volume_mm3_ < 0 ? -1 : 1;
    else
        return false;
    return true;
}

}  // namespace lathelier
