#include "engine/registration/revolution/scanner_axis.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/core/statistics.h"

namespace lathelier::registration {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr std::size_t pairSamples = 8000;
constexpr double axisOffsetSigmaShare = 0.15;  // of the radius: standard uncertainty of the distance between scanner
                                               // axis and part axis when it cannot be estimated

/// Neighbours in the file, in the part's axis frame.
struct NeighbourPair {
    Vector3d first;
    Vector3d step;
};

std::vector<NeighbourPair> neighboursOf(const std::vector<Vector3d>& points, const Eigen::Isometry3d& axis_T_scan)
{
    std::vector<NeighbourPair> pairs;
    if (points.size() < 2) return pairs;
    pairs.reserve(pairSamples);
    for (std::size_t k = 0; k < pairSamples; ++k) {
        const std::size_t i = k * (points.size() - 1) / pairSamples;
        pairs.push_back({axis_T_scan * points[i], axis_T_scan.linear() * (points[i + 1] - points[i])});
    }
    return pairs;
}

/// The direction in which neighbours do not differ; nullopt when there is none.
std::optional<Vector3d> acrossRows(const std::vector<NeighbourPair>& pairs)
{
    std::vector<double> lengths;
    lengths.reserve(pairs.size());
    for (const NeighbourPair& pair : pairs) lengths.push_back(pair.step.norm());
    const double typical = upperMedianInPlace(lengths);
    Vector3d normal = Vector3d::UnitZ();
    double least = 0;
    double width = std::numeric_limits<double>::infinity();
    for (int round = 0; round < 6; ++round) {
        Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();
        for (const NeighbourPair& pair : pairs)
            if (pair.step.norm() < 3 * typical && std::abs(pair.step.dot(normal)) <= width)
                scatter += pair.step * pair.step.transpose();
        normal = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(scatter).eigenvectors().col(0);
        std::vector<double> off;
        off.reserve(pairs.size());
        for (const NeighbourPair& pair : pairs) off.push_back(std::abs(pair.step.dot(normal)));
        least = upperMedianInPlace(off);
        width = 4 * least + 1e-12 * typical;
    }
    if (!(least < 0.01 * typical) || std::abs(normal.z()) < 0.5) return std::nullopt;
    return normal.z() < 0 ? Vector3d(-normal) : normal;
}

/// The position from which neighbours lie one angular step apart: noise acts along the rays and leaves their angles
/// unchanged. Gauss-Newton over position and step with Tukey weights scaled by the residuals. Sigma infinite: there is
/// no such place.
struct RayOrigin {
    Vector2d centre = Vector2d::Zero();
    double sigma = std::numeric_limits<double>::infinity();
};
RayOrigin rayOriginOf(const std::vector<Vector2d>& first, const std::vector<Vector2d>& second)
{
    const auto gradient = [](const Vector2d& arm) -> Vector2d {
        return Vector2d(arm.y(), -arm.x()) / arm.squaredNorm();
    };
    RayOrigin place;
    for (const Vector2d& p : first) place.centre += p / static_cast<double>(first.size());
    std::vector<double> angles(first.size()), sizes(first.size());
    double step = 0;
    double scale = 0;
    for (int round = 0; round < 40; ++round) {
        for (std::size_t i = 0; i < first.size(); ++i) {
            const Vector2d a = first[i] - place.centre;
            const Vector2d b = second[i] - place.centre;
            const double angle = std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b));
            angles[i] = angle;
            sizes[i] = std::abs(angle);
        }
        if (round == 0) {
            std::vector<double> sorted = sizes;
            step = upperMedianInPlace(sorted);
            if (!(step > 1e-6)) return RayOrigin{};
            scale = step;
        }
        Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
        Vector3d right = Vector3d::Zero();
        std::vector<double> residuals;
        double squares = 0, weights = 0;
        for (std::size_t i = 0; i < first.size(); ++i) {
            const double residual = sizes[i] - step;
            if (sizes[i] < 1.5 * step) residuals.push_back(std::abs(residual));
            const double u = residual / scale;
            if (!(u * u < 1)) continue;
            const double w = (1 - u * u) * (1 - u * u);
            const Vector2d by =
                (gradient(second[i] - place.centre) - gradient(first[i] - place.centre)) * (angles[i] < 0 ? -1.0 : 1.0);
            const Vector3d j(by.x(), by.y(), -1);
            normal += w * j * j.transpose();
            right -= w * residual * j;
            squares += w * residual * residual;
            weights += w;
        }
        if (weights < 50 || residuals.size() < first.size() / 4) return RayOrigin{};
        const Vector3d change = normal.ldlt().solve(right);
        if (!change.allFinite()) return RayOrigin{};
        place.centre += change.head<2>();
        step += change.z();
        if (!(step > 1e-6)) return RayOrigin{};
        const Eigen::Matrix3d covariance = normal.inverse() * (squares / weights);
        place.sigma = std::sqrt(covariance(0, 0) + covariance(1, 1));
        scale = std::clamp(6 * upperMedianInPlace(residuals), 1e-9 * step, 0.5 * step);
        if (change.head<2>().norm() < 1e-3 * place.sigma + 1e-12) break;
    }
    if (!(scale < 0.3 * step)) return RayOrigin{};  // no common step
    return place;
}

}  // namespace

std::optional<ScannerAxis> findScannerAxis(const std::vector<Vector3d>& points, const Eigen::Isometry3d& axis_T_scan,
                                           double radius_mm)
{
    const std::vector<NeighbourPair> pairs = neighboursOf(points, axis_T_scan);
    if (pairs.empty()) return std::nullopt;
    const auto normal = acrossRows(pairs);
    if (!normal) return std::nullopt;
    ScannerAxis axis;
    axis.direction = *normal;
    axis.sigma_mm = axisOffsetSigmaShare * radius_mm;

    const Vector3d u = normal->unitOrthogonal();
    const Vector3d v = normal->cross(u);
    std::vector<double> lengths;
    lengths.reserve(pairs.size());
    for (const NeighbourPair& pair : pairs) lengths.push_back(pair.step.norm());
    const double typical = upperMedianInPlace(lengths);
    std::vector<Vector2d> first, second;
    for (const NeighbourPair& pair : pairs) {
        if (pair.step.norm() > 3 * typical || std::abs(pair.step.dot(*normal)) > 0.05 * typical) continue;
        const Vector3d next = pair.first + pair.step;
        first.emplace_back(pair.first.dot(u), pair.first.dot(v));
        second.emplace_back(next.dot(u), next.dot(v));
    }
    if (first.size() < 200) return axis;
    const RayOrigin place = rayOriginOf(first, second);
    if (place.sigma < axis.sigma_mm) {
        axis.point_mm = place.centre.x() * u + place.centre.y() * v;
        axis.sigma_mm = place.sigma;
    }
    return axis;
}

}  // namespace lathelier::registration
