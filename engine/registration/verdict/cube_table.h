// Cubes in space as keys, and a hash table of them.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "engine/registration/verdict/surface_cells.h"

namespace lathelier::registration {

/// Place of a cube, in sizes of a cube.
using Cube = std::array<std::int32_t, 3>;

/// Where a normal points, as one of six sides (three where the deviation has no sign: then 0, 2, 4).
inline int sideOf(const Eigen::Vector3f& normal)
{
    Eigen::Index axis = 0;
    normal.cwiseAbs().maxCoeff(&axis);
    return static_cast<int>(2 * axis) + (normal[axis] < 0 ? 1 : 0);
}

/// Cubes further away count as this far: within the 20 bits of a coordinate in a key.
inline constexpr double farthestCube = 500000;

/// 20 bits for each coordinate, 3 for the side.
inline std::uint64_t keyOf(const Cube& cube, int side)
{
    std::uint64_t key = 0;
    for (const std::int32_t c : cube) key = key << 20 | (static_cast<std::uint32_t>(c + (1 << 19)) & 0xfffffU);
    return key << 3 | static_cast<std::uint64_t>(side);
}

/// Hash table from keys to consecutive numbers (open addressing).
class KeyTable {
public:
    explicit KeyTable(std::size_t most)
    {
        std::size_t size = 16;
        while (size < 2 * most) size *= 2;
        slots_.assign(size, {emptySlot, CellPoints::noCell});
    }

    std::uint32_t find(std::uint64_t key) const { return slots_[place(key)].second; }
    /// The number of the key, `next` when it is new.
    std::uint32_t add(std::uint64_t key, std::uint32_t next)
    {
        auto& slot = slots_[place(key)];
        if (slot.first == emptySlot) slot = {key, next};
        return slot.second;
    }

private:
    static constexpr std::uint64_t emptySlot = ~std::uint64_t{0};

    std::size_t place(std::uint64_t key) const
    {
        std::size_t at = (key * 0x9e3779b97f4a7c15ULL >> 20) & (slots_.size() - 1);
        while (slots_[at].first != emptySlot && slots_[at].first != key) at = (at + 1) & (slots_.size() - 1);
        return at;
    }

    std::vector<std::pair<std::uint64_t, std::uint32_t>> slots_;
};

/// The cube of a size that holds a place.
inline Cube cubeOf(const Eigen::Vector3d& place, double size)
{
    Cube cube{};
    for (int a = 0; a < 3; ++a)
        cube[static_cast<std::size_t>(a)] =
            static_cast<std::int32_t>(std::clamp(std::floor(place[a] / size), -farthestCube, farthestCube));
    return cube;
}

}  // namespace lathelier::registration
