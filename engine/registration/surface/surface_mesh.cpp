#include "engine/registration/surface/surface_mesh.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "engine/registration/neighbours/neighbours_order.h"
#include "engine/registration/registration_codes.h"
#include "engine/registration/surface/mesh_repair.h"

namespace lathelier::registration {
namespace {

constexpr double rimMarginShare = 1e-4;  // of the mesh's extent

double angleBetween(const Eigen::Vector3d& a, const Eigen::Vector3d& b)
{
    return std::atan2(a.cross(b).norm(), a.dot(b));
}

}  // namespace

Eigen::Vector3d MeshSurface::Triangle::normal() const
{
    return (corners_mm[1] - corners_mm[0]).cross(corners_mm[2] - corners_mm[0]);
}

MeshSurface::MeshSurface(const Scan& mesh, const Progress& progress)
{
    build(mesh, mesh.triangles, numberCorners(mesh.points_mm), progress.part(0, 0.7));
    if (closed_ && conflicts_ == 0) return;
    const RepairedMesh repaired = repairMesh(mesh, progress.part(0.7, 0.8));
    if (repaired.facets_turned > 0) notes_.push_back({notes::facetsTurned, {{"count", repaired.facets_turned}}});
    if (repaired.holes_filled > 0)
        notes_.push_back(
            {notes::holesFilled, {{"count", repaired.holes_filled}, {"largest_mm", repaired.largest_hole_mm}}});
    build(mesh, repaired.triangles, repaired.corners, progress.part(0.8, 1));
}

void MeshSurface::build(const Scan& mesh, std::span<const TriangleCorners> triangles, const CornerNumbers& numbers,
                        const Progress& progress)
{
    progress.report(0.2);
    givenNormals_ = 0;
    std::vector<Eigen::Vector3d> centres;
    centres.reserve(triangles.size());
    for (const auto& t : triangles)
        centres.push_back((mesh.points_mm[t[0]] + mesh.points_mm[t[1]] + mesh.points_mm[t[2]]) / 3);
    const std::vector<std::uint32_t> order = hilbertOrder(centres, progress);
    triangles_.assign(order.size(), {});
    std::vector<Box> boxes((order.size() + leafSize - 1) / leafSize);
    Box all;
    for (std::size_t i = 0; i < order.size(); ++i) {
        const auto& t = triangles[order[i]];
        Triangle& triangle = triangles_[i];
        triangle.corners = numbers.of(t);
        for (std::size_t k = 0; k < 3; ++k) {
            triangle.corners_mm[k] = mesh.points_mm[t[k]];
            boxes[i / leafSize].add(triangle.corners_mm[k]);
            all.add(triangle.corners_mm[k]);
            if (mesh.hasNormals()) givenNormals_ += mesh.normals[t[k]].cast<double>().dot(triangle.normal());
        }
    }
    rimMargin_mm_ = triangles_.empty() ? 0 : rimMarginShare * (all.high_mm - all.low_mm).norm();
    progress.report(0.6);
    boxes_ = BoxTree(boxes, progress);
    cornerNormals_.assign(numbers.count, Eigen::Vector3d::Zero());
    cornerOnRim_.assign(numbers.count, false);
    connect(progress);
}

void MeshSurface::connect(const Progress& progress)
{
    volume_mm3_ = 0;
    area_mm2_ = 0;
    std::vector<TriangleCorners> numbered;
    numbered.reserve(triangles_.size());
    for (Triangle& triangle : triangles_) {
        numbered.push_back(triangle.corners);
        const Eigen::Vector3d product = triangle.normal();
        const Eigen::Vector3d unit = product.norm() > 0 ? product.normalized() : Eigen::Vector3d::Zero();
        volume_mm3_ += (triangle.corners_mm[0] - triangles_[0].corners_mm[0]).dot(product) / 6;
        area_mm2_ += product.norm() / 2;
        for (std::size_t k = 0; k < 3; ++k) {
            const Eigen::Vector3d& p = triangle.corners_mm[k];
            cornerNormals_[triangle.corners[k]] +=
                angleBetween(triangle.corners_mm[(k + 1) % 3] - p, triangle.corners_mm[(k + 2) % 3] - p) * unit;
            triangle.edge_normals[k] = unit.cast<float>();
        }
    }
    progress.report(0.75);
    const std::vector<MeshEdge> edges = edgesOf(numbered);
    progress.report(0.95);
    closed_ = true;
    edges_ = 0;
    conflicts_ = 0;
    rim_mm_ = 0;
    forEachEdge(edges, [&](std::size_t first, std::size_t last) {
        int sense = 0;
        Eigen::Vector3f sum = Eigen::Vector3f::Zero();
        for (std::size_t e = first; e < last; ++e) {
            sense += edges[e].forward ? 1 : -1;
            sum += triangles_[edges[e].triangle].edge_normals[edges[e].side];
        }
        if (sense != 0) closed_ = false;
        for (std::size_t e = first; e < last; ++e) triangles_[edges[e].triangle].edge_normals[edges[e].side] = sum;
        if (last - first == 2) {
            ++edges_;
            conflicts_ += sense != 0 ? 1 : 0;
        } else if (last - first == 1) {
            Triangle& triangle = triangles_[edges[first].triangle];
            const std::size_t side = edges[first].side;
            triangle.rim |= static_cast<std::uint8_t>(1U << side);
            rim_mm_ += (triangle.corners_mm[(side + 1) % 3] - triangle.corners_mm[side]).norm();
            cornerOnRim_[edges[first].low()] = true;
            cornerOnRim_[edges[first].high()] = true;
        }
    });
}

SurfacePlace MeshSurface::placeOne(const Eigen::Vector3d& query_mm, double max_distance_mm, std::uint32_t& hint) const
{
    TrianglePoint best{};
    std::uint32_t where = Neighbours::Found::none;
    double bound = std::nextafter(max_distance_mm * max_distance_mm, std::numeric_limits<double>::infinity());
    const auto look = [&](std::uint32_t leaf, double& limit) {
        const std::uint32_t end = std::min((leaf + 1) * leafSize, static_cast<std::uint32_t>(triangles_.size()));
        for (std::uint32_t t = leaf * leafSize; t < end; ++t) {
            const TrianglePoint here = nearestOnTriangle(query_mm, triangles_[t].corners_mm);
            const double squared = (here.point_mm - query_mm).squaredNorm();
            if (squared < limit) {
                limit = squared;
                best = here;
                where = t;
            }
        }
    };
    if (hint != Neighbours::Found::none) look(hint / leafSize, bound);
    boxes_.visit(Box(query_mm), bound, look);
    SurfacePlace place;
    if (where == Neighbours::Found::none) return place;
    hint = where;
    const Triangle& triangle = triangles_[where];
    const auto part = static_cast<std::size_t>(best.part);
    Eigen::Vector3d normal = triangle.normal();
    if (part < 3)
        normal = cornerNormals_[triangle.corners[part]];
    else if (part < 6)
        normal = triangle.edge_normals[part - 3].cast<double>();
    const bool on_rim =
        part < 3 ? cornerOnRim_[triangle.corners[part]] : part < 6 && (triangle.rim >> (part - 3) & 1) != 0;
    const Eigen::Vector3d offset = query_mm - best.point_mm;
    // Beside an opening the distance to its rim is no deviation of the surface.
    const Eigen::Vector3d out = normal.stableNormalized();
    place.border = on_rim && (offset - out.dot(offset) * out).norm() > rimMargin_mm_;
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
                        std::span<SurfacePlace> places, std::span<Trace> traces) const
{
    std::uint32_t hint = Neighbours::Found::none;  // neighbouring queries share the bound
    for (std::size_t q = 0; q < queries_mm.size(); ++q) {
        if (!traces.empty() && traces[q].place != Neighbours::Found::none) hint = traces[q].place;
        places[q] = placeOne(queries_mm[q], max_distance_mm, hint);
        if (!traces.empty()) traces[q].place = hint;
    }
}

bool MeshSurface::orient(const Progress&)
{
    if (conflicts_ > edges_ / 1000) return false;
    if (givenNormals_ != 0)
        sense_ = givenNormals_ < 0 ? -1 : 1;
    else
        sense_ = (closed_ || isNearlyClosed()) && volume_mm3_ < 0 ? -1 : 1;
    return area_mm2_ > 0;
}

}  // namespace lathelier::registration
