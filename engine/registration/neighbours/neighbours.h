// Nearest points of a cloud: exact, for any distribution of points (equal points, clusters, far outliers).
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "engine/core/progress.h"
#include "engine/registration/neighbours/neighbours_boxes.h"

namespace lathelier::registration {

/// An index over points, built once: n log n time, about 40 bytes a point. Points are numbered by their place in the
/// index (0…size-1, neighbours in number are neighbours in space); input() gives their number in the input.
class Neighbours {
public:
    /// All coordinates finite. Throws Cancelled.
    explicit Neighbours(const std::vector<Eigen::Vector3d>& points_mm, const Progress& progress = {});

    std::size_t size() const { return order_.size(); }
    std::uint32_t input(std::uint32_t place) const { return order_[place]; }
    Eigen::Vector3d point_mm(std::uint32_t place) const
    {
        const Leaf& leaf = leaves_[place / leafSize];
        return {leaf.x[place % leafSize], leaf.y[place % leafSize], leaf.z[place % leafSize]};
    }

    struct Found {
        static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
        std::uint32_t place = none;  ///< `none` when no point is within the limit
        double squared_mm2 = std::numeric_limits<double>::infinity();
    };

    /// The nearest point closer than sqrt(`limit_mm2`).
    Found nearest(const Eigen::Vector3d& query_mm, double limit_mm2 = std::numeric_limits<double>::infinity()) const;

    /// The same for many queries that follow each other in space, as in Hilbert order: much faster than one by one.
    void nearest(std::span<const Eigen::Vector3d> queries_mm, double limit_mm2, std::span<Found> found) const;

    /// State of a query that is repeated while its point moves.
    struct Trace {
        std::uint32_t place = Found::none;  ///< its nearest point in the last search
        double others_mm = -1;              ///< lower bound of the distance of every other point then; -1: unknown
        Eigen::Vector3d at_mm = Eigen::Vector3d::Zero();  ///< the query point then
    };

    /// The same for repeated queries: the search is skipped where no other point can have become the nearest. `traces`
    /// are those of the last call with these queries, default ones at first.
    void nearest(std::span<const Eigen::Vector3d> queries_mm, double limit_mm2, std::span<Trace> traces,
                 std::span<Found> found) const;

    /// The up to `count` nearest points closer than sqrt(`limit_mm2`), nearest first, into `found`.
    void nearest(const Eigen::Vector3d& query_mm, std::size_t count, double limit_mm2, std::vector<Found>& found) const;

    /// The same points in any order, fast for many neighbours. `expected_mm2` is the square of the distance they are
    /// expected within: it only saves time, and becomes a good value for a query nearby.
    void nearestUnsorted(const Eigen::Vector3d& query_mm, std::size_t count, double& expected_mm2,
                         std::vector<Found>& found) const;

private:
    friend class Surroundings;

    static constexpr std::uint32_t leafSize = 8;

    // Eight points side by side; absent ones are infinitely far.
    struct alignas(64) Leaf {
        double x[leafSize];
        double y[leafSize];
        double z[leafSize];
    };

    void improve(std::uint32_t leaf, const Eigen::Vector3d& query_mm, Found& best) const;
    void complete(const Eigen::Vector3d& query_mm, std::uint32_t expected, Found& best) const;
    Found nearestTwo(const Eigen::Vector3d& query_mm, std::uint32_t expected, double& second_mm2) const;
    double squaredDistance(std::uint32_t place, const Eigen::Vector3d& query_mm) const;
    void leafDistances(std::uint32_t leaf, const Eigen::Vector3d& query_mm, double* squared) const;

    std::vector<std::uint32_t> order_;
    std::vector<Leaf> leaves_;
    BoxTree boxes_;
};

inline void Neighbours::leafDistances(std::uint32_t leaf, const Eigen::Vector3d& query_mm, double* squared) const
{
    const Leaf& points = leaves_[leaf];
    for (std::uint32_t i = 0; i < leafSize; ++i) {
        const double dx = points.x[i] - query_mm.x();
        const double dy = points.y[i] - query_mm.y();
        const double dz = points.z[i] - query_mm.z();
        squared[i] = dx * dx + dy * dy + dz * dz;
    }
}

inline void Neighbours::improve(std::uint32_t leaf, const Eigen::Vector3d& query_mm, Found& best) const
{
    alignas(64) double squared[leafSize];
    leafDistances(leaf, query_mm, squared);
    const double low = std::min(std::min(std::min(squared[0], squared[1]), std::min(squared[2], squared[3])),
                                std::min(std::min(squared[4], squared[5]), std::min(squared[6], squared[7])));
    if (!(low < best.squared_mm2)) return;
    const auto at = static_cast<std::uint32_t>(std::find(squared, squared + leafSize, low) - squared);
    best = {leaf * leafSize + at, low};
}

}  // namespace lathelier::registration
