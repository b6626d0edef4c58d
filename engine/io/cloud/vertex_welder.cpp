#include "engine/io/cloud/vertex_welder.h"

#include <bit>

namespace lathelier::io {
namespace {

std::uint64_t hashOf(const Eigen::Vector3d& p)
{
    std::uint64_t hash = 0;
    for (int k = 0; k < 3; ++k) {
        // splitmix64 (S. Vigna): spreads the few differing bits of neighbouring coordinates
        hash = (hash ^ std::bit_cast<std::uint64_t>(p[k])) + 0x9E3779B97F4A7C15u;
        hash = (hash ^ (hash >> 30)) * 0xBF58476D1CE4E5B9u;
        hash = (hash ^ (hash >> 27)) * 0x94D049BB133111EBu;
        hash ^= hash >> 31;
    }
    return hash;
}

}  // namespace

VertexWelder::VertexWelder(std::vector<Eigen::Vector3d>& vertices) : vertices_(vertices), slots_(1024, 0) {}

std::uint32_t VertexWelder::indexOf(const Eigen::Vector3d& given)
{
    const Eigen::Vector3d corner = given.array() + 0.0;  // turns -0 into 0
    if ((vertices_.size() + 1) * 2 > slots_.size()) grow();
    const std::size_t mask = slots_.size() - 1;
    for (std::size_t slot = hashOf(corner) & mask;; slot = (slot + 1) & mask) {
        if (slots_[slot] == 0) {
            vertices_.push_back(corner);
            slots_[slot] = static_cast<std::uint32_t>(vertices_.size());
            return slots_[slot] - 1;
        }
        if (vertices_[slots_[slot] - 1] == corner) return slots_[slot] - 1;
    }
}

void VertexWelder::grow()
{
    slots_.assign(slots_.size() * 2, 0);
    const std::size_t mask = slots_.size() - 1;
    for (std::size_t i = 0; i < vertices_.size(); ++i) {
        std::size_t slot = hashOf(vertices_[i]) & mask;
        while (slots_[slot] != 0) slot = (slot + 1) & mask;
        slots_[slot] = static_cast<std::uint32_t>(i + 1);
    }
}

}  // namespace lathelier::io
