#include "engine/registration/surface_deviation.h"

#include <array>
#include <cmath>

#include "engine/core/parallel.h"
#include "engine/registration/neighbours_order.h"
#include "engine/registration/registration_codes.h"
#include "engine/registration/surface.h"

namespace lathelier::registration {

namespace {

SurfaceDeviation measure(Surface& surface, const Eigen::Vector3d& origin_mm, const std::vector<Eigen::Vector3d>& points,
                         double max_distance_mm, const Progress& progress)
{
    SurfaceDeviation result;
    result.notes = surface.notes();
    result.has_sign = surface.orient(progress.part(0, 0.3));
    if (!result.has_sign) result.notes.push_back({notes::signUndetermined, {}});
    progress.report(0.3);
    const std::vector<std::uint32_t> order = hilbertOrder(points, progress);
    progress.report(0.4);
    result.deviation_mm.assign(order.size(), std::numeric_limits<float>::quiet_NaN());
    parallelFor(order.size(), 512, progress, [&](std::size_t begin, std::size_t end) {
        std::array<Eigen::Vector3d, Surface::bundle> queries;
        std::array<std::uint32_t, Surface::bundle> targets;
        std::array<SurfacePlace, Surface::bundle> places;
        for (std::size_t i = begin; i < end;) {
            std::size_t count = 0;
            for (; i < end && count < Surface::bundle; ++i) {
                if (!points[order[i]].allFinite()) continue;
                queries[count] = points[order[i]] - origin_mm;
                targets[count++] = order[i];
            }
            surface.place(std::span(queries).first(count), max_distance_mm, places, {});
            for (std::size_t q = 0; q < count; ++q) {
                const double d = places[q].distance_mm;
                if (!(std::abs(d) <= max_distance_mm) || places[q].border) continue;
                result.deviation_mm[targets[q]] = static_cast<float>(result.has_sign ? d : std::abs(d));
            }
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
    return measure(*surface, Eigen::Vector3d::Zero(), copy_points_in_reference_mm, max_distance_mm,
                   progress.part(0.4, 1));
}

SurfaceDeviation surfaceDeviation(const GeneralReference& reference,
                                  const std::vector<Eigen::Vector3d>& copy_points_in_reference_mm,
                                  double max_distance_mm, const Progress& progress)
{
    return measure(*reference.surface, reference.points.middle_mm, copy_points_in_reference_mm, max_distance_mm,
                   progress);
}

}  // namespace lathelier::registration
