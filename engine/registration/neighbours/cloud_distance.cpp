#include "engine/registration/neighbours/cloud_distance.h"

#include <cmath>
#include <limits>

#include "engine/core/parallel.h"
#include "engine/registration/neighbours/neighbours.h"
#include "engine/registration/neighbours/neighbours_order.h"

namespace lathelier::registration {
std::vector<float> nearestDistances(const std::vector<Eigen::Vector3d>& reference_mm,
                                    const std::vector<Eigen::Vector3d>& query_mm, double max_distance_mm,
                                    const Progress& progress)
{
    const Neighbours reference(reference_mm, progress);
    progress.report(0.25);
    return nearestDistances(reference, query_mm, max_distance_mm, progress.part(0.25, 1));
}

std::vector<float> nearestDistances(const Neighbours& reference, const std::vector<Eigen::Vector3d>& query_mm,
                                    double max_distance_mm, const Progress& progress)
{
    // Hilbert order: each search starts near the result of the query before.
    const std::vector<std::uint32_t> order = hilbertOrder(query_mm, progress);
    progress.report(0.15);
    // The limit of the search is exclusive, that of the caller inclusive.
    const double limit = std::nextafter(max_distance_mm * max_distance_mm, std::numeric_limits<double>::infinity());
    std::vector<float> result(query_mm.size(), std::numeric_limits<float>::quiet_NaN());
    parallelFor(order.size(), 2048, progress, [&](std::size_t begin, std::size_t end) {
        std::vector<Eigen::Vector3d> queries;
        std::vector<std::uint32_t> targets;
        for (std::size_t i = begin; i < end; ++i) {
            if (!query_mm[order[i]].allFinite()) continue;
            queries.push_back(query_mm[order[i]]);
            targets.push_back(order[i]);
        }
        std::vector<Neighbours::Found> found(queries.size());
        reference.nearest(queries, limit, found);
        for (std::size_t q = 0; q < queries.size(); ++q)
            if (found[q].place != Neighbours::Found::none)
                result[targets[q]] = static_cast<float>(std::sqrt(found[q].squared_mm2));
    });
    return result;
}

}  // namespace lathelier::registration
