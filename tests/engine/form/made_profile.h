// Profiles of known form for the tests.
#pragma once

#include <cmath>
#include <numbers>
#include <vector>

#include "engine/core/profile.h"
#include "engine/core/random.h"

namespace lathelier::form {

struct Lobe {
    int upr;
    double amplitude_mm, phase_rad;
};

inline std::vector<double> evenAngles(std::size_t n)
{
    std::vector<double> result;
    for (std::size_t i = 0; i < n; ++i)
        result.push_back(2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(n));
    return result;
}

/// Points at the given angles about `centre_mm`, with lobes and normal noise.
inline Profile lobedProfile(const std::vector<double>& angle_rad, const std::vector<Lobe>& lobes,
                            Eigen::Vector2d centre_mm = {0, 0}, double noise_mm = 0, std::uint64_t seed = 1,
                            double radius_mm = 25)
{
    Profile profile;
    for (std::size_t i = 0; i < angle_rad.size(); ++i) {
        double r = radius_mm + noise_mm * randomNormal(seed, 0, i);
        for (const Lobe& lobe : lobes) r += lobe.amplitude_mm * std::cos(lobe.upr * angle_rad[i] - lobe.phase_rad);
        profile.points_mm.push_back(centre_mm + r * Eigen::Vector2d(std::cos(angle_rad[i]), std::sin(angle_rad[i])));
    }
    return profile;
}

}  // namespace lathelier::form
