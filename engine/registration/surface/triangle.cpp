#include "engine/registration/surface/triangle.h"

namespace lathelier::registration {
namespace {

// A triangle without area: the nearest of its three edges.
TrianglePoint nearestOnEdges(const Eigen::Vector3d& query_mm, const std::array<Eigen::Vector3d, 3>& corners_mm)
{
    TrianglePoint best{corners_mm[0], TrianglePart::Corner0};
    for (std::size_t k = 0; k < 3; ++k) {
        const Eigen::Vector3d& a = corners_mm[k];
        const Eigen::Vector3d edge = corners_mm[(k + 1) % 3] - a;
        const double length2 = edge.squaredNorm();
        const double t = length2 > 0 ? (query_mm - a).dot(edge) / length2 : 0;
        TrianglePoint here{a, static_cast<TrianglePart>(k)};
        if (t >= 1)
            here = {corners_mm[(k + 1) % 3], static_cast<TrianglePart>((k + 1) % 3)};
        else if (t > 0)
            here = {a + t * edge, static_cast<TrianglePart>(3 + k)};
        if ((here.point_mm - query_mm).squaredNorm() < (best.point_mm - query_mm).squaredNorm()) best = here;
    }
    return best;
}

}  // namespace

TrianglePoint nearestOnTriangle(const Eigen::Vector3d& query_mm, const std::array<Eigen::Vector3d, 3>& corners_mm)
{
    const Eigen::Vector3d& a = corners_mm[0];
    const Eigen::Vector3d& b = corners_mm[1];
    const Eigen::Vector3d& c = corners_mm[2];
    const Eigen::Vector3d ab = b - a;
    const Eigen::Vector3d ac = c - a;
    const Eigen::Vector3d ap = query_mm - a;
    const double d1 = ab.dot(ap);
    const double d2 = ac.dot(ap);
    if (d1 <= 0 && d2 <= 0) return {a, TrianglePart::Corner0};
    const Eigen::Vector3d bp = query_mm - b;
    const double d3 = ab.dot(bp);
    const double d4 = ac.dot(bp);
    if (d3 >= 0 && d4 <= d3) return {b, TrianglePart::Corner1};
    const Eigen::Vector3d cp = query_mm - c;
    const double d5 = ab.dot(cp);
    const double d6 = ac.dot(cp);
    if (d6 >= 0 && d5 <= d6) return {c, TrianglePart::Corner2};
    const double vc = d1 * d4 - d3 * d2;
    const double vb = d5 * d2 - d1 * d6;
    const double va = d3 * d6 - d5 * d4;
    if (!(va + vb + vc > 0)) return nearestOnEdges(query_mm, corners_mm);
    if (vc <= 0 && d1 >= 0 && d3 <= 0) return {a + d1 / (d1 - d3) * ab, TrianglePart::Edge0};
    if (vb <= 0 && d2 >= 0 && d6 <= 0) return {a + d2 / (d2 - d6) * ac, TrianglePart::Edge2};
    if (va <= 0 && d4 >= d3 && d5 >= d6)
        return {b + (d4 - d3) / ((d4 - d3) + (d5 - d6)) * (c - b), TrianglePart::Edge1};
    const double scale = 1 / (va + vb + vc);
    return {a + (vb * scale) * ab + (vc * scale) * ac, TrianglePart::Face};
}

}  // namespace lathelier::registration
