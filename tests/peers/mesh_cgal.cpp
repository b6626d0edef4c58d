#include "tests/peers/mesh_cgal.h"

#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Simple_cartesian.h>

#include <cmath>
#include <vector>

namespace lathelier::peers {

using Kernel = CGAL::Simple_cartesian<double>;
using Triangles = std::vector<Kernel::Triangle_3>;
using Primitive = CGAL::AABB_triangle_primitive<Kernel, Triangles::const_iterator>;

struct CgalMesh::Tree {
    Triangles triangles;
    CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>> tree;
};

CgalMesh::CgalMesh(const Scan& mesh) : tree_(std::make_unique<Tree>())
{
    const auto corner = [&mesh](std::uint32_t index) {
        const Eigen::Vector3d& point = mesh.points_mm[index];
        return Kernel::Point_3(point.x(), point.y(), point.z());
    };
    for (const auto& [a, b, c] : mesh.triangles) {
        const Kernel::Triangle_3 triangle(corner(a), corner(b), corner(c));
        if (!triangle.is_degenerate()) tree_->triangles.push_back(triangle);
    }
    tree_->tree.rebuild(tree_->triangles.begin(), tree_->triangles.end());
    tree_->tree.accelerate_distance_queries();
}

CgalMesh::~CgalMesh() = default;

double CgalMesh::distance_mm(const Eigen::Vector3d& query_mm) const
{
    return std::sqrt(tree_->tree.squared_distance(Kernel::Point_3(query_mm.x(), query_mm.y(), query_mm.z())));
}

}  // namespace lathelier::peers
