// A stratified sample: places spread evenly over a sequence, not periodic.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "engine/core/random.h"

namespace lathelier::registration {

/// One place among 0…size-1 from each of `count` equal stretches, drawn at random within it, so that there is no
/// aliasing with the grid of a scanner. `count` is at most `size`.
inline std::vector<std::size_t> drawnPlaces(std::size_t size, std::size_t count, std::uint64_t seed)
{
    std::vector<std::size_t> places(count);
    for (std::size_t i = 0; i < count; ++i) {
        const double place = (static_cast<double>(i) + randomUniform(seed, 0, i)) * static_cast<double>(size);
        places[i] = static_cast<std::size_t>(place / static_cast<double>(count));
        if (places[i] >= size) places[i] = size - 1;  // by rounding
    }
    return places;
}

}  // namespace lathelier::registration
