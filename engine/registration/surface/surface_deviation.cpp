#include "engine/registration/surface/surface_deviation.h"

#include <cmath>
#include <vector>

#include "engine/core/parallel.h"
#include "engine/registration/neighbours/neighbours_order.h"
#include "engine/registration/registration_codes.h"
#include "engine/registration/surface/surface.h"

namespace lathelier::registration {

namespace {

SurfaceDeviation deviationsFrom(Surface& surface, const Eigen::Vector3d& origin_mm,
                                const std::vector<Eigen::Vector3d>& points, double max_distance_mm,
                                const Progress& progress)
{
    SurfaceDeviation result;
    result.notes = surface.notes();
    result.has_sign = surface.orient(progress.part(0, 0.3));
    if (!result.has_sign) result.notes.push_back({notes::signUndetermined, {}});
    progress.report(0.3);
    const std::vector<std::uint32_t> order = hilbertOrder(points, progress);
    progress.report(0.4);
    result.deviation_mm.assign(order.size(), std::numeric_limits<float>::quiet_NaN());
    result.direction.assign(order.size(), Eigen::Vector3f::Zero());
    parallelFor(order.size(), 512, progress, [&](std::size_t begin, std::size_t end) {
        std::vector<Eigen::Vector3d> queries;
        std::vector<std::uint32_t> targets;
        for (std::size_t i = begin; i < end; ++i) {
            if (!points[order[i]].allFinite()) continue;
            queries.emplace_back(points[order[i]] - origin_mm);
            targets.push_back(order[i]);
        }
        std::vector<SurfacePlace> places(queries.size());
        surface.place(queries, max_distance_mm, places, {});
        for (std::size_t q = 0; q < queries.size(); ++q) {
            const double d = places[q].distance_mm;
            if (!(std::abs(d) <= max_distance_mm) || places[q].border) continue;
            const bool turned = !result.has_sign && d < 0;
            result.deviation_mm[targets[q]] = static_cast<float>(turned ? -d : d);
            result.direction[targets[q]] = (turned ? -places[q].normal : places[q].normal).cast<float>();
        }
    });
    return result;
}

}  // namespace

SurfaceDeviation surfaceDeviation(const Scan& reference,
                                  const std::vector<Eigen::Vector3d>& copy_points_in_reference_mm,
                                  double max_distance_mm, const Progress& progress)
{
    const std::unique_ptr<Surface> surface = makeSurface(reference, progress.part(0, 0.4));
    return deviationsFrom(*surface, Eigen::Vector3d::Zero(), copy_points_in_reference_mm, max_distance_mm,
                          progress.part(0.4, 1));
}

SurfaceDeviation surfaceDeviation(const GeneralReference& reference,
                                  const std::vector<Eigen::Vector3d>& copy_points_in_reference_mm,
                                  double max_distance_mm, const Progress& progress)
{
    return deviationsFrom(*reference.surface, reference.points.middle_mm, copy_points_in_reference_mm, max_distance_mm,
                          progress);
}

}  // namespace lathelier::registration
