// Relative orientation of pieces of surface (union-find with parity).
#pragma once

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <vector>

namespace lathelier::registration {

/// Sets of elements whose senses are known relative to each other (disjoint sets with parity).
class Senses {
public:
    explicit Senses(std::size_t count) : parent_(count), flipped_(count, 0)
    {
        std::iota(parent_.begin(), parent_.end(), 0U);
    }

    /// The set that element `i` belongs to, and whether it lies there the other way round.
    std::uint32_t root(std::uint32_t i, bool& flipped)
    {
        std::uint32_t top = i;
        bool sense = false;
        while (parent_[top] != top) {
            sense ^= flipped_[top] != 0;
            top = parent_[top];
        }
        flipped = sense;
        while (parent_[i] != top && i != top) {  // shorten the path for the next time
            const std::uint32_t next = parent_[i];
            const bool own = flipped_[i] != 0;
            parent_[i] = top;
            flipped_[i] = sense;
            sense ^= own;
            i = next;
        }
        return top;
    }

    /// Lays the sets of a and b together. False where they were together before and their senses contradict.
    bool join(std::uint32_t a, std::uint32_t b, bool opposite)
    {
        bool flip_a = false;
        bool flip_b = false;
        const std::uint32_t root_a = root(a, flip_a);
        const std::uint32_t root_b = root(b, flip_b);
        if (root_a == root_b) return (flip_a != flip_b) == opposite;
        const std::uint32_t low = std::min(root_a, root_b);
        const std::uint32_t high = std::max(root_a, root_b);
        parent_[high] = low;
        flipped_[high] = flip_a ^ flip_b ^ opposite;
        return true;
    }

private:
    std::vector<std::uint32_t> parent_;
    std::vector<std::uint8_t> flipped_;
};

}  // namespace lathelier::registration
