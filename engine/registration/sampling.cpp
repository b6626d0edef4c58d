#include "engine/registration/sampling.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "engine/core/parallel.h"

namespace lathelier {
namespace {

using Eigen::Vector3d;

constexpr std::size_t kPlaces = 12;
constexpr std::size_t kNearest = 32;  // samples whose circle gives the area of one

double medianOf(std::vector<double>& values)
{
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

}  // namespace

double samplingFloor_mm(const std::vector<Vector3d>& points, const Progress& progress)
{
    const double none = std::numeric_limits<double>::quiet_NaN();
    if (points.size() < 200) return none;
    Vector3d low = points.front();
    Vector3d high = low;
    for (std::size_t i = 0; i < points.size(); i += 1 + points.size() / 5000) {
        low = low.cwiseMin(points[i]);
        high = high.cwiseMax(points[i]);
    }
    const double radius = (high - low).norm() * std::sqrt(300.0 / static_cast<double>(points.size()));
    std::vector<Vector3d> places;
    for (std::size_t k = 0; k < kPlaces; ++k) places.push_back(points[(2 * k + 1) * points.size() / (2 * kPlaces)]);

    using Patches = std::vector<std::vector<Vector3d>>;
    const Patches patches = parallelReduce(
        points.size(), std::max<std::size_t>(16384, points.size() / 24), progress, Patches(kPlaces),
        [&](std::size_t begin, std::size_t end) {
            Patches part(kPlaces);
            for (std::size_t i = begin; i < end; ++i)
                for (std::size_t k = 0; k < kPlaces; ++k) {
                    const double dx = points[i].x() - places[k].x();
                    if (dx > radius || dx < -radius) continue;
                    if ((points[i] - places[k]).squaredNorm() < radius * radius)
                        part[k].push_back(points[i] - places[k]);
                }
            return part;
        },
        [](Patches all, const Patches& part) {
            for (std::size_t k = 0; k < kPlaces; ++k) all[k].insert(all[k].end(), part[k].begin(), part[k].end());
            return all;
        });

    std::vector<double> nearest, area;
    for (const std::vector<Vector3d>& patch : patches) {
        if (patch.size() < 2 * kNearest) continue;
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
            std::nth_element(distances.begin(), distances.begin() + kNearest, distances.end());
            area.push_back(std::numbers::pi * distances[kNearest] / (kNearest + 0.5));
            std::partial_sort(distances.begin(), distances.begin() + 2, distances.begin() + kNearest);
            nearest.push_back(std::sqrt(distances[1]));
        }
    }
    if (area.empty()) return none;
    const double cell = medianOf(area);
    const double a = std::clamp(medianOf(nearest), 1e-3 * std::sqrt(cell), std::sqrt(cell));
    const double b = cell / a;
    return std::sqrt((a * a + b * b) / 12);
}

}  // namespace lathelier
