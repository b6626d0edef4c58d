// Points sorted into the cubes of a grid, and groups of neighbouring cubes.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <functional>
#include <vector>

namespace lathelier::features {

class PointCubes {
public:
    PointCubes(const std::vector<Eigen::Vector3d>& points, double edge_mm);

    /// Number of cubes that hold points, in the order of their first points.
    std::size_t size() const { return start_.size() - 1; }
    /// Number of points in a cube.
    std::size_t count(std::size_t cube) const { return start_[cube + 1] - start_[cube]; }
    /// Indices of the points of a cube, in order.
    const std::uint32_t* begin(std::size_t cube) const { return order_.data() + start_[cube]; }
    const std::uint32_t* end(std::size_t cube) const { return order_.data() + start_[cube + 1]; }
    /// Cubes for which `is_used` holds, in groups of those that share a face, an edge or a corner; by their first cube.
    std::vector<std::vector<std::size_t>> groups(const std::function<bool(std::size_t)>& is_used) const;
    /// The cubes and all that lie up to `rings` cubes beside one of them, in ascending order.
    std::vector<std::size_t> around(const std::vector<std::size_t>& cubes, int rings) const;

private:
    struct Cell {
        std::int64_t x, y, z;
    };
    std::ptrdiff_t find(std::int64_t x, std::int64_t y, std::int64_t z) const;

    std::vector<Cell> cells_;                                      ///< of each cube
    std::vector<std::pair<std::uint64_t, std::uint32_t>> sorted_;  ///< key and cube, by key
    std::vector<std::size_t> start_;                               ///< of the points of each cube in `order_`
    std::vector<std::uint32_t> order_;
};

}  // namespace lathelier::features
