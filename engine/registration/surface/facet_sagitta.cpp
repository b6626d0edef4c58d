#include "engine/registration/surface/facet_sagitta.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "engine/core/statistics.h"

namespace lathelier::registration {
namespace {

/// Quantile of the facets' sagitta.
double sagittaQuantile(const Scan& mesh, const Eigen::Isometry3d& axis_T_mesh, double share, const Progress& progress)
{
    constexpr double side = 0.3;    // of the normal's length along the radius
    constexpr double level = 1e-3;  // ends of a chord: this share of the radius apart at most
    std::vector<double> sagittas;
    sagittas.reserve(mesh.triangles.size());
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        if (i % 65536 == 0) progress.check();
        std::array<Eigen::Vector3d, 3> p;
        for (std::size_t k = 0; k < 3; ++k) p[k] = axis_T_mesh * mesh.points_mm[mesh.triangles[i][k]];
        const Eigen::Vector3d normal = (p[1] - p[0]).cross(p[2] - p[0]);
        const Eigen::Vector2d radial = (p[0] + p[1] + p[2]).head<2>().normalized();
        if (!(std::abs(normal.head<2>().dot(radial)) > side * normal.norm())) continue;
        double largest = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            const Eigen::Vector3d& a = p[k];
            const Eigen::Vector3d& b = p[(k + 1) % 3];
            const double radius = (a.head<2>().norm() + b.head<2>().norm()) / 2;
            if (std::abs(a.head<2>().norm() - b.head<2>().norm()) > level * radius) continue;
            largest = std::max(largest, radius - ((a + b) / 2).head<2>().norm());
        }
        sagittas.push_back(largest);
    }
    return sagittas.empty() ? 0 : quantileInPlace(sagittas, share);
}

}  // namespace

double facetSagitta_mm(const Scan& mesh, const Eigen::Isometry3d& axis_T_mesh, const Progress& progress)
{
    return sagittaQuantile(mesh, axis_T_mesh, 0.9, progress);
}

double largestSagitta_mm(const Scan& mesh, const Eigen::Isometry3d& axis_T_mesh, const Progress& progress)
{
    return sagittaQuantile(mesh, axis_T_mesh, 0.999, progress);
}

}  // namespace lathelier::registration
