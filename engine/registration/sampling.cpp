#include "engine/registration/sampling.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <vector>

#include "engine/core/statistics.h"
#include "engine/registration/neighbours/neighbours.h"

namespace lathelier::registration {
namespace {

using Eigen::Vector3d;

constexpr std::size_t placeCount = 12;
constexpr std::size_t patchSamples = 1200;  // samples around each place
constexpr std::size_t areaNeighbours = 32;  // neighbours whose circle gives the area per sample

}  // namespace

std::vector<Vector3d> samplingPlaces(const std::vector<Vector3d>& points_mm)
{
    std::vector<Vector3d> places;
    for (std::size_t k = 0; k < placeCount && !points_mm.empty(); ++k)
        places.push_back(points_mm[(2 * k + 1) * points_mm.size() / (2 * placeCount)]);
    return places;
}

std::size_t samplingNeighbours(std::size_t points)
{
    return std::min(patchSamples, points / 4);
}

SamplingFloor samplingFloor(const std::vector<Vector3d>& points_mm, const Neighbours& index, const Progress& progress)
{
    SamplingFloor result;
    if (points_mm.size() < 200) return result;
    std::vector<std::vector<Vector3d>> patches;
    double expected_mm2 = std::numeric_limits<double>::infinity();
    std::vector<Neighbours::Found> found;
    for (const Vector3d& place : samplingPlaces(points_mm)) {
        progress.check();
        index.nearestUnsorted(place, samplingNeighbours(points_mm.size()), expected_mm2, found);
        std::vector<Vector3d>& patch = patches.emplace_back();
        for (const Neighbours::Found& near : found) {
            patch.push_back(index.point_mm(near.place) - place);
            result.reach_mm = std::max(result.reach_mm, patch.back().norm());
        }
    }

    std::vector<double> nearest, area;
    for (const std::vector<Vector3d>& patch : patches) {
        if (patch.size() < 2 * areaNeighbours) continue;
        Vector3d mean = Vector3d::Zero();
        for (const Vector3d& p : patch) mean += p / static_cast<double>(patch.size());
        Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();
        for (const Vector3d& p : patch) scatter += (p - mean) * (p - mean).transpose();
        const Vector3d normal = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(scatter).eigenvectors().col(0);
        // A few centres near the patch's middle, so that their circles stay inside it.
        std::vector<std::pair<double, std::size_t>> inner;
        for (std::size_t i = 0; i < patch.size(); ++i) inner.emplace_back(patch[i].squaredNorm(), i);
        std::partial_sort(inner.begin(), inner.begin() + 8, inner.end());
        for (std::size_t c = 0; c < 8; ++c) {
            const Vector3d centre = patch[inner[c].second];
            std::vector<double> distances;
            for (const Vector3d& p : patch) {
                const Vector3d off = p - centre;
                distances.push_back((off - normal * normal.dot(off)).squaredNorm());
            }
            std::nth_element(distances.begin(), distances.begin() + areaNeighbours, distances.end());
            area.push_back(std::numbers::pi * distances[areaNeighbours] / (areaNeighbours + 0.5));
            std::partial_sort(distances.begin(), distances.begin() + 2, distances.begin() + areaNeighbours);
            nearest.push_back(std::sqrt(distances[1]));
        }
    }
    if (area.empty()) return result;
    const double cell = upperMedianInPlace(area);
    const double a = std::clamp(upperMedianInPlace(nearest), 1e-3 * std::sqrt(cell), std::sqrt(cell));
    const double b = cell / a;
    result.rms_mm = std::sqrt((a * a + b * b) / 12);
    return result;
}

}  // namespace lathelier::registration
