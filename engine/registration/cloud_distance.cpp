#include "engine/registration/cloud_distance.h"

#include <array>
#include <cmath>
#include <limits>
#include <span>

#include "engine/core/parallel.h"
#include "engine/registration/neighbours.h"
#include "engine/registration/neighbours_order.h"

namespace lathelier::registration {
namespace {

constexpr std::size_t bundle = 8;  // queries that go down the tree together

}  // namespace

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
    // Queries that follow each other in space find their answer where the one before found it.
    const std::vector<std::uint32_t> order = hilbertOrder(query_mm, progress);
    progress.report(0.15);
    // The search wants a strict limit, the caller an inclusive one.
    const double limit = std::nextafter(max_distance_mm * max_distance_mm, std::numeric_limits<double>::infinity());
    std::vector<float> result(query_mm.size(), std::numeric_limits<float>::quiet_NaN());
    parallelFor(order.size(), 2048, progress, [&](std::size_t begin, std::size_t end) {
        std::array<Eigen::Vector3d, bundle> queries;
        std::array<std::uint32_t, bundle> targets;
        std::array<Neighbours::Found, bundle> found;
        for (std::size_t i = begin; i < end;) {
            std::size_t count = 0;
            for (; i < end && count < bundle; ++i) {
                if (!query_mm[order[i]].allFinite()) continue;
                queries[count] = query_mm[order[i]];
                targets[count++] = order[i];
            }
            reference.nearest(std::span(queries).first(count), limit, found);
            for (std::size_t q = 0; q < count; ++q)
                if (found[q].place != Neighbours::Found::none)
                    result[targets[q]] = static_cast<float>(std::sqrt(found[q].squared_mm2));
        }
    });
    return result;
}

}  // namespace lathelier::registration
