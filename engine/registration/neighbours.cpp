#include "engine/registration/neighbours.h"

#include <algorithm>
#include <cmath>

#include "engine/core/parallel.h"
#include "engine/registration/neighbours_order.h"

namespace lathelier::registration {

Neighbours::Neighbours(const std::vector<Eigen::Vector3d>& points_mm, const Progress& progress)
    : order_(hilbertOrder(points_mm, progress))
{
    leaves_.resize((order_.size() + leaf_size - 1) / leaf_size);
    std::vector<Box> boxes(leaves_.size());
    parallelFor(leaves_.size(), 4096, progress, [&](std::size_t begin, std::size_t end) {
        for (std::size_t l = begin; l < end; ++l)
            for (std::size_t i = 0; i < leaf_size; ++i) {
                const std::size_t place = l * leaf_size + i;
                Eigen::Vector3d p = Eigen::Vector3d::Constant(std::numeric_limits<double>::infinity());
                if (place < order_.size()) {
                    p = points_mm[order_[place]];
                    boxes[l].add(p);
                }
                leaves_[l].x[i] = p.x();
                leaves_[l].y[i] = p.y();
                leaves_[l].z[i] = p.z();
            }
    });
    boxes_ = BoxTree(boxes, progress);
}

inline void Neighbours::leafDistances(std::uint32_t leaf, const Eigen::Vector3d& query_mm, double* squared) const
{
    const Leaf& points = leaves_[leaf];
    for (std::uint32_t i = 0; i < leaf_size; ++i) {
        const double dx = points.x[i] - query_mm.x();
        const double dy = points.y[i] - query_mm.y();
        const double dz = points.z[i] - query_mm.z();
        squared[i] = dx * dx + dy * dy + dz * dz;
    }
}

inline double Neighbours::squaredDistance(std::uint32_t place, const Eigen::Vector3d& query_mm) const
{
    const Eigen::Vector3d p = point_mm(place);
    const double dx = p.x() - query_mm.x();
    const double dy = p.y() - query_mm.y();
    const double dz = p.z() - query_mm.z();
    return dx * dx + dy * dy + dz * dz;
}

inline void Neighbours::improve(std::uint32_t leaf, const Eigen::Vector3d& query_mm, Found& best) const
{
    alignas(64) double squared[leaf_size];
    leafDistances(leaf, query_mm, squared);
    const double low = std::min(std::min(std::min(squared[0], squared[1]), std::min(squared[2], squared[3])),
                                std::min(std::min(squared[4], squared[5]), std::min(squared[6], squared[7])));
    if (!(low < best.squared_mm2)) return;
    const auto at = static_cast<std::uint32_t>(std::find(squared, squared + leaf_size, low) - squared);
    best = {leaf * leaf_size + at, low};
}

Neighbours::Found Neighbours::nearest(const Eigen::Vector3d& query_mm, double limit_mm2) const
{
    Found best{Found::none, limit_mm2};
    complete(query_mm, best);
    return best;
}

void Neighbours::complete(const Eigen::Vector3d& query_mm, Found& best) const
{
    double bound = best.squared_mm2;
    boxes_.visit(Box(query_mm), bound, [&](std::uint32_t leaf, double& limit) {
        improve(leaf, query_mm, best);
        limit = best.squared_mm2;
    });
    if (best.place == Found::none) best.squared_mm2 = std::numeric_limits<double>::infinity();
}

void Neighbours::nearest(std::span<const Eigen::Vector3d> queries_mm, double limit_mm2, std::span<Found> found) const
{
    Box box;
    for (std::size_t q = 0; q < queries_mm.size(); ++q) {
        box.add(queries_mm[q]);
        found[q] = {Found::none, limit_mm2};
    }
    double bound = limit_mm2;
    int leaves_left = 24;  // queries far apart, or far from many points, do not gain by going together and go on alone
    boxes_.visit(box, bound, [&](std::uint32_t leaf, double& limit) {
        limit = 0;
        for (std::size_t q = 0; q < queries_mm.size(); ++q) {
            improve(leaf, queries_mm[q], found[q]);
            limit = std::max(limit, found[q].squared_mm2);
        }
        if (--leaves_left == 0) limit = 0;
    });
    for (std::size_t q = 0; q < queries_mm.size(); ++q)
        if (leaves_left <= 0)
            complete(queries_mm[q], found[q]);
        else if (found[q].place == Found::none)
            found[q].squared_mm2 = std::numeric_limits<double>::infinity();
}

// The nearest point nearer than sqrt(second_mm2), which becomes the square of the distance of the second.
Neighbours::Found Neighbours::nearestTwo(const Eigen::Vector3d& query_mm, std::uint32_t expected,
                                         double& second_mm2) const
{
    Found best{Found::none, second_mm2};
    const auto look = [&](std::uint32_t leaf, double& second) {
        alignas(64) double squared[leaf_size];
        leafDistances(leaf, query_mm, squared);
        for (std::uint32_t i = 0; i < leaf_size; ++i) {
            if (!(squared[i] < second)) continue;
            if (squared[i] < best.squared_mm2) {
                second = best.squared_mm2;
                best = {leaf * leaf_size + i, squared[i]};
            } else {
                second = squared[i];
            }
        }
    };
    const std::uint32_t first = expected < size() ? expected / leaf_size : Found::none;
    if (first != Found::none) look(first, second_mm2);
    boxes_.visit(Box(query_mm), second_mm2, [&](std::uint32_t leaf, double& second) {
        if (leaf != first) look(leaf, second);
    });
    if (best.place == Found::none) best.squared_mm2 = std::numeric_limits<double>::infinity();
    return best;
}

void Neighbours::nearest(std::span<const Eigen::Vector3d> queries_mm, double limit_mm2, std::span<Trace> traces,
                         std::span<Found> found) const
{
    std::uint32_t before = Found::none;  // what the query before found is near the next one
    for (std::size_t q = 0; q < queries_mm.size(); ++q) {
        Trace& trace = traces[q];
        const Eigen::Vector3d& query = queries_mm[q];
        Found here;
        if (trace.place != Found::none) here = {trace.place, squaredDistance(trace.place, query)};
        const double nearest_mm = std::sqrt(std::min(here.squared_mm2, limit_mm2));
        if (!(trace.others_mm - (query - trace.at_mm).norm() > nearest_mm * (1 + 1e-9))) {
            double second_mm2 = limit_mm2;
            here = nearestTwo(query, trace.place != Found::none ? trace.place : before, second_mm2);
            trace = {here.place, std::sqrt(second_mm2), query};
        }
        found[q] = here.squared_mm2 < limit_mm2 ? here : Found();
        if (here.place != Found::none) before = here.place;
    }
}

void Neighbours::nearest(const Eigen::Vector3d& query_mm, std::size_t count, double limit_mm2,
                         std::vector<Found>& found) const
{
    found.clear();
    if (count == 0) return;
    double bound = limit_mm2;
    boxes_.visit(Box(query_mm), bound, [&](std::uint32_t leaf, double& limit) {
        alignas(64) double squared[leaf_size];
        leafDistances(leaf, query_mm, squared);
        for (std::uint32_t i = 0; i < leaf_size; ++i) {
            if (!(squared[i] < limit)) continue;
            if (found.size() < count) found.emplace_back();
            std::size_t place = found.size() - 1;
            for (; place > 0 && found[place - 1].squared_mm2 > squared[i]; --place) found[place] = found[place - 1];
            found[place] = {leaf * leaf_size + i, squared[i]};
            if (found.size() == count) limit = std::min(limit, found.back().squared_mm2);
        }
    });
}

void Neighbours::nearestUnsorted(const Eigen::Vector3d& query_mm, std::size_t count, double& expected_mm2,
                                 std::vector<Found>& found) const
{
    const std::size_t wanted = std::min(count, size());
    const std::size_t most = 8 * wanted + 64;
    found.clear();
    if (wanted == 0) return;
    for (int round = 0; round < 4; ++round, expected_mm2 *= 2) {
        found.clear();
        double bound = expected_mm2;
        boxes_.visit(Box(query_mm), bound, [&](std::uint32_t leaf, double& limit) {
            alignas(64) double squared[leaf_size];
            leafDistances(leaf, query_mm, squared);
            for (std::uint32_t i = 0; i < leaf_size; ++i)
                if (squared[i] < limit) found.push_back({leaf * leaf_size + i, squared[i]});
            if (found.size() > most) limit = 0;
        });
        if (found.size() >= wanted) break;
    }
    if (found.size() < wanted || found.size() > most) {
        nearest(query_mm, wanted, std::numeric_limits<double>::infinity(), found);
    } else {
        const auto last = found.begin() + static_cast<std::ptrdiff_t>(wanted - 1);
        std::nth_element(found.begin(), last, found.end(), [](const Found& a, const Found& b) {
            return a.squared_mm2 != b.squared_mm2 ? a.squared_mm2 < b.squared_mm2 : a.place < b.place;
        });
        found.resize(wanted);
        // The order that is left depends on what was looked at first: make it depend on the points only.
        std::sort(found.begin(), found.end(), [](const Found& a, const Found& b) { return a.place < b.place; });
        expected_mm2 = 0;
        for (const Found& f : found) expected_mm2 = std::max(expected_mm2, f.squared_mm2);
        expected_mm2 *= 1.2;
        return;
    }
    expected_mm2 = 1.2 * found.back().squared_mm2;
}

}  // namespace lathelier::registration
