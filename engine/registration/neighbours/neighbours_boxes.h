// A tree of boxes over items in Hilbert order, eight children to a node (a packed R-tree). Distances to boxes and to
// what they hold are computed by the same monotone steps, so that a box is skipped exactly when it cannot contain the
// nearest point. Source: I. Kamel, C. Faloutsos, "On packing R-trees", CIKM 1993.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "engine/core/progress.h"

namespace lathelier::registration {

/// An axis-parallel box; empty when default constructed.
struct Box {
    Eigen::Vector3d low_mm = Eigen::Vector3d::Constant(std::numeric_limits<double>::infinity());
    Eigen::Vector3d high_mm = Eigen::Vector3d::Constant(-std::numeric_limits<double>::infinity());

    Box() = default;
    explicit Box(const Eigen::Vector3d& point_mm) : low_mm(point_mm), high_mm(point_mm) {}

    void add(const Eigen::Vector3d& point_mm)
    {
        low_mm = low_mm.cwiseMin(point_mm);
        high_mm = high_mm.cwiseMax(point_mm);
    }
};

/// The tree over leaves 0…n-1, whose boxes are given.
class BoxTree {
public:
    BoxTree() = default;
    BoxTree(const std::vector<Box>& leaves, const Progress& progress);

    /// Calls leaf(index, limit) for every leaf whose squared distance to the box `query` (or point) is below `limit`,
    /// near ones first; `leaf` lowers `limit` when it finds something better.
    template <class Leaf>
    void visit(const Box& query, double& limit, Leaf&& leaf) const;

    Box leafBox(std::uint32_t leaf) const
    {
        const Node& node = levels_.front()[leaf / fan];
        Box box;
        for (int a = 0; a < 3; ++a) {
            box.low_mm[a] = node.low[a][leaf % fan];
            box.high_mm[a] = node.high[a][leaf % fan];
        }
        return box;
    }

private:
    static constexpr std::uint32_t fan = 8;

    // Coordinates of eight children side by side; absent children have empty boxes.
    struct alignas(64) Node {
        double low[3][fan];
        double high[3][fan];
    };

    struct Pending {
        std::uint32_t level;
        std::uint32_t index;
        double squared;
    };

    static void childDistances(const Node& node, const Box& query, double* squared);

    std::vector<std::vector<Node>> levels_;  // levels_[0]: nodes whose children are leaves; the last level has one node
};

inline void BoxTree::childDistances(const Node& node, const Box& query, double* squared)
{
    using Eight = Eigen::Array<double, fan, 1>;
    using Eights = Eigen::Map<const Eight, Eigen::Aligned64>;
    const auto outside = [&](int a) {
        return (Eights(node.low[a]) - query.high_mm[a]).max(query.low_mm[a] - Eights(node.high[a])).max(0.0);
    };
    Eigen::Map<Eight, Eigen::Aligned64> result(squared);
    result = outside(0).square() + outside(1).square() + outside(2).square();
}

template <class Leaf>
void BoxTree::visit(const Box& query, double& limit, Leaf&& leaf) const
{
    if (levels_.empty()) return;
    std::array<Pending, std::size_t{8} * 12> stack;  // 8^11 leaves are more than 32 bits can count
    std::size_t depth = 0;
    stack[depth++] = {static_cast<std::uint32_t>(levels_.size()), 0, 0};
    while (depth > 0) {
        const Pending top = stack[--depth];
        if (!(top.squared < limit)) continue;
        if (top.level == 0) {
            leaf(top.index, limit);
            continue;
        }
        alignas(64) double squared[fan];
        childDistances(levels_[top.level - 1][top.index], query, squared);
        const std::size_t bottom = depth;
        for (std::uint32_t c = 0; c < fan; ++c) {
            if (!(squared[c] < limit)) continue;
            std::size_t place = depth++;  // nearest on top
            for (; place > bottom && stack[place - 1].squared < squared[c]; --place) stack[place] = stack[place - 1];
            stack[place] = {top.level - 1, top.index * fan + c, squared[c]};
        }
    }
}

}  // namespace lathelier::registration
