// The points of an index near a box, copied for many queries within that box.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "engine/registration/neighbours/neighbours.h"

namespace lathelier::registration {

/// Kept by one thread, filled again and again.
class Surroundings {
public:
    explicit Surroundings(const Neighbours& index) : index_(&index) {}

    /// Collects all points closer than sqrt(`reach_mm2`) to `box`, and some further ones. False, and nothing is
    /// collected, where more than `most_leaves` times eight points are near.
    bool collect(const Box& box, double reach_mm2, std::size_t most_leaves);

    /// The nearest point to a query in the box, where it is closer than `best`.
    void improve(const Eigen::Vector3d& query_mm, Neighbours::Found& best);

    /// The `count` nearest points to a query in the box, in the order of the index. False where they do not all lie
    /// within the reach.
    bool nearest(const Eigen::Vector3d& query_mm, std::size_t count, std::vector<Neighbours::Found>& found);

private:
    const Neighbours* index_;
    double reach_mm2_ = 0;
    std::vector<std::uint32_t> leaves_;
    Eigen::ArrayX3d low_mm_;  ///< of the leaves' boxes
    Eigen::ArrayX3d high_mm_;
    Eigen::ArrayXd squared_mm2_;
    std::vector<double> sorted_mm2_;
    std::vector<Neighbours::Found> inside_;
    std::size_t before_ = 0;  ///< leaf in which the query before found its nearest point
};

}  // namespace lathelier::registration
