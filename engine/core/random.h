// Random numbers by counter: the same on every machine, in any order, from any thread.
#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>

namespace lathelier {

/// Number `index` of stream `stream` under `seed`, as if drawn from one long sequence (SplitMix64 finaliser,
/// Steele, Lea, Flood: "Fast splittable pseudorandom number generators", OOPSLA 2014).
inline std::uint64_t randomBits(std::uint64_t seed, std::uint64_t stream, std::uint64_t index)
{
    const auto mix = [](std::uint64_t z) {
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
        z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
        return z ^ (z >> 31);
    };
    return mix(mix(mix(seed + 0x9e3779b97f4a7c15ULL) + stream * 0xd1b54a32d192ed03ULL) + index * 0x9e3779b97f4a7c15ULL);
}

/// Uniform in [0, 1).
inline double randomUniform(std::uint64_t seed, std::uint64_t stream, std::uint64_t index)
{
    return static_cast<double>(randomBits(seed, stream, index) >> 11) * 0x1p-53;
}

/// A normal deviate with mean 0 and standard deviation 1 (Box and Muller), or 0 where its absolute value is certainly
/// below `least`: faster for small `rarity` = exp(-least²/2).
inline double randomNormalBeyond(std::uint64_t seed, std::uint64_t stream, std::uint64_t index, double rarity)
{
    const double radius = 1.0 - randomUniform(seed, stream, 2 * index);
    if (radius > rarity) return 0;
    const double turn = randomUniform(seed, stream, 2 * index + 1);
    return std::sqrt(-2 * std::log(radius)) * std::cos(2 * std::numbers::pi * turn);
}

/// Normal with mean 0 and standard deviation 1.
inline double randomNormal(std::uint64_t seed, std::uint64_t stream, std::uint64_t index)
{
    return randomNormalBeyond(seed, stream, index, 1);
}

}  // namespace lathelier
