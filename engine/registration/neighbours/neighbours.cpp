#include "engine/registration/neighbours/neighbours.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/core/parallel.h"
#include "engine/registration/neighbours/neighbours_order.h"
#include "engine/registration/surroundings.h"

namespace lathelier::registration {

Neighbours::Neighbours(const std::vector<Eigen::Vector3d>& points_mm, const Progress& progress)
    : order_(hilbertOrder(points_mm, progress))
{
    leaves_.resize((order_.size() + leafSize - 1) / leafSize);
    std::vector<Box> boxes(leaves_.size());
    parallelFor(leaves_.size(), 4096, progress, [&](std::size_t begin, std::size_t end) {
        for (std::size_t l = begin; l < end; ++l)
            for (std::size_t i = 0; i < leafSize; ++i) {
                const std::size_t place = l * leafSize + i;
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

inline double Neighbours::squaredDistance(std::uint32_t place, const Eigen::Vector3d& query_mm) const
{
    const Eigen::Vector3d p = point_mm(place);
    const double dx = p.x() - query_mm.x();
    const double dy = p.y() - query_mm.y();
    const double dz = p.z() - query_mm.z();
    return dx * dx + dy * dy + dz * dz;
}

Neighbours::Found Neighbours::nearest(const Eigen::Vector3d& query_mm, double limit_mm2) const
{
    Found best{Found::none, limit_mm2};
    complete(query_mm, Found::none, best);
    return best;
}

void Neighbours::complete(const Eigen::Vector3d& query_mm, std::uint32_t expected, Found& best) const
{
    if (expected < size()) improve(expected / leafSize, query_mm, best);
    double bound = best.squared_mm2;
    boxes_.visit(Box(query_mm), bound, [&](std::uint32_t leaf, double& limit) {
        improve(leaf, query_mm, best);
        limit = best.squared_mm2;
    });
    if (best.place == Found::none) best.squared_mm2 = std::numeric_limits<double>::infinity();
}

void Neighbours::nearest(std::span<const Eigen::Vector3d> queries_mm, double limit_mm2, std::span<Found> found) const
{
    constexpr std::size_t together = 32;
    Surroundings surroundings(*this);
    std::uint32_t before = Found::none;  // start: result of the query before
    double expected_mm2 = 0;             // bound for the following queries
    for (std::size_t begin = 0; begin < queries_mm.size(); begin += together) {
        const std::size_t end = std::min(begin + together, queries_mm.size());
        Box box;
        for (std::size_t q = begin; q < end; ++q) box.add(queries_mm[q]);
        const double reach_mm2 = std::min(expected_mm2, limit_mm2);
        const bool is_dense = surroundings.collect(box, reach_mm2, together);
        for (std::size_t q = begin; q < end; ++q) {
            found[q] = {Found::none, reach_mm2};
            if (is_dense) surroundings.improve(queries_mm[q], found[q]);
            if (found[q].place == Found::none) {
                found[q].squared_mm2 = limit_mm2;
                complete(queries_mm[q], before, found[q]);
            }
            if (found[q].place != Found::none) before = found[q].place;
        }
        std::array<double, together> sizes;
        for (std::size_t q = begin; q < end; ++q) sizes[q - begin] = found[q].squared_mm2;
        const auto most = sizes.begin() + static_cast<std::ptrdiff_t>((end - begin) * 15 / 16);
        std::nth_element(sizes.begin(), most, sizes.begin() + static_cast<std::ptrdiff_t>(end - begin));
        expected_mm2 = 1.3 * *most;
    }
}

// The nearest point nearer than sqrt(second_mm2), which becomes the square of the distance of the second.
Neighbours::Found Neighbours::nearestTwo(const Eigen::Vector3d& query_mm, std::uint32_t expected,
                                         double& second_mm2) const
{
    Found best{Found::none, second_mm2};
    const auto look = [&](std::uint32_t leaf, double& second) {
        alignas(64) double squared[leafSize];
        leafDistances(leaf, query_mm, squared);
        for (std::uint32_t i = 0; i < leafSize; ++i) {
            if (!(squared[i] < second)) continue;
            if (squared[i] < best.squared_mm2) {
                second = best.squared_mm2;
                best = {leaf * leafSize + i, squared[i]};
            } else {
                second = squared[i];
            }
        }
    };
    const std::uint32_t first = expected < size() ? expected / leafSize : Found::none;
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
    std::uint32_t before = Found::none;  // start: result of the query before
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
        alignas(64) double squared[leafSize];
        leafDistances(leaf, query_mm, squared);
        for (std::uint32_t i = 0; i < leafSize; ++i) {
            if (!(squared[i] < limit)) continue;
            if (found.size() < count) found.emplace_back();
            std::size_t place = found.size() - 1;
            for (; place > 0 && found[place - 1].squared_mm2 > squared[i]; --place) found[place] = found[place - 1];
            found[place] = {leaf * leafSize + i, squared[i]};
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
            alignas(64) double squared[leafSize];
            leafDistances(leaf, query_mm, squared);
            for (std::uint32_t i = 0; i < leafSize; ++i)
                if (squared[i] < limit) found.push_back({leaf * leafSize + i, squared[i]});
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
        // Sort: the order must depend on the points only, not on the traversal.
        std::sort(found.begin(), found.end(), [](const Found& a, const Found& b) { return a.place < b.place; });
        expected_mm2 = 0;
        for (const Found& f : found) expected_mm2 = std::max(expected_mm2, f.squared_mm2);
        expected_mm2 *= 1.2;
        return;
    }
    expected_mm2 = 1.2 * found.back().squared_mm2;
}

}  // namespace lathelier::registration
