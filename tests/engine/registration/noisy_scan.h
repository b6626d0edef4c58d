// Scans of a mesh whose noise is of the kinds that real scanners have.
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <tuple>

#include "engine/core/random.h"
#include "engine/registration/surface/surface_samples.h"

namespace lathelier::testing_noise {

enum class Noise { White, AlongLines, AlongLinesInAnyOrder, UnevenCoverage, Spikes };

inline const char* nameOf(Noise kind)
{
    switch (kind) {
        case Noise::White: return "white";
        case Noise::AlongLines: return "along scan lines";
        case Noise::AlongLinesInAnyOrder: return "along scan lines, the file in any order";
        case Noise::UnevenCoverage: return "along scan lines, coverage 20:1";
        case Noise::Spikes: return "spikes";
    }
    return "";
}

/// About `count` points in scan lines 1.5 mm apart, in the order of the lines. Noise of `sigma_mm` along the normal:
/// white, or correlated over about 30 neighbours of a line (plus white noise of a third).
inline Scan noisyScan(const Scan& mesh, Noise kind, std::size_t count, double sigma_mm, std::uint64_t seed)
{
    const Scan even = registration::sampleSurface(mesh, kind == Noise::UnevenCoverage ? 3 * count : count, seed);
    const Eigen::Vector3d sweep = Eigen::Vector3d(0.2, 0.3, 1).normalized();
    const Eigen::Vector3d across = sweep.unitOrthogonal();
    Eigen::Vector3d middle = Eigen::Vector3d::Zero();
    for (const auto& p : even.points_mm) middle += p / static_cast<double>(even.points_mm.size());
    struct Place {
        double line;
        double angle;
        std::size_t index;
    };
    std::vector<Place> order;
    for (std::size_t i = 0; i < even.points_mm.size(); ++i) {
        const Eigen::Vector3d d = even.points_mm[i] - middle;
        // A scanner near one corner: dense there, thin at the far end.
        const double share = std::exp(-d.dot(Eigen::Vector3d(1, 0.5, -0.3)) / 25) / 4;
        if (kind == Noise::UnevenCoverage && randomUniform(seed, 21, i) > std::clamp(share, 0.05, 1.0)) continue;
        order.push_back({std::floor(d.dot(sweep) / 1.5), std::atan2(d.dot(across), d.dot(sweep.cross(across))), i});
    }
    std::sort(order.begin(), order.end(), [](const Place& a, const Place& b) {
        return std::tie(a.line, a.angle, a.index) < std::tie(b.line, b.angle, b.index);
    });
    const bool is_white = kind == Noise::White || kind == Noise::Spikes;
    const double keep = std::exp(-1 / 30.0);
    double drift = randomNormal(seed, 22, 0);
    Scan scan;
    for (std::size_t k = 0; k < order.size(); ++k) {
        const std::size_t i = order[k].index;
        drift = keep * drift + std::sqrt(1 - keep * keep) * randomNormal(seed, 23, i);
        const double white = randomNormal(seed, 24, i);
        double off = sigma_mm * (is_white ? white : drift + white / 3);
        if (kind == Noise::Spikes && randomUniform(seed, 25, i) < 0.03) off += 3 * randomNormal(seed, 26, i);
        scan.points_mm.emplace_back(even.points_mm[i] + off * even.normals[i].cast<double>());
    }
    if (kind == Noise::AlongLinesInAnyOrder)
        for (std::size_t i = scan.points_mm.size() - 1; i > 0; --i)
            std::swap(scan.points_mm[i], scan.points_mm[randomBits(seed, 27, i) % (i + 1)]);
    return scan;
}

}  // namespace lathelier::testing_noise
