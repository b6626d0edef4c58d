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

/// How the rows and the axis of the scanner are found (README, "Thresholds").
struct ScannerAxisThresholds {
    std::size_t pairs = 8000;          ///< of neighbours in the file, spread over it
    double longest_step = 3;           ///< of the typical step: longer ones lead to another row
    int row_rounds = 6;                ///< of the fit of the rows' normal
    double row_widths = 4;             ///< of the typical step out of the rows: larger ones do not count
    double least_row_width = 1e-12;    ///< of the typical step, for exact rows
    double row_share = 0.01;           ///< of the typical step: largest typical step out of the rows
    double least_across_cosine = 0.5;  ///< between the rows' normal and the part's axis: 60°
    double in_row_share = 0.05;        ///< of the typical step: steps further out of the rows are left out
    std::size_t least_pairs = 200;     ///< in rows, for a step of angle
    int origin_rounds = 40;            ///< of the fit of the place that rays come from
    double least_step_rad = 1e-6;      ///< of angle between neighbours
    double single_step = 1.5;          ///< steps of angle: larger ones are no residuals of one step
    double least_weights = 50;         ///< sum, for the place to be determined
    std::size_t least_part = 4;        ///< of the pairs (1 / n): fewer with one step give no place
    double origin_scales = 6;          ///< of the median residual: where the weights reach 0
    double least_scale = 1e-9;         ///< of a step, for exact rows
    double first_scale = 0.5;          ///< of a step: the scale is no larger
    double common_scale = 0.3;         ///< of a step: with a larger scale there is no common step
    double settled_sigmas = 1e-3;      ///< standard uncertainties of the place: a smaller change has settled
    double settled_mm = 1e-12;         ///< and so has one below this
};
constexpr ScannerAxisThresholds axisThresholds{};

/// Neighbours in the file, in the part's axis frame.
struct NeighbourPair {
    Vector3d first;
    Vector3d step;
};

std::vector<NeighbourPair> neighboursOf(const std::vector<Vector3d>& points, const Eigen::Isometry3d& axis_T_scan)
{
    std::vector<NeighbourPair> pairs;
    if (points.size() < 2) return pairs;
    pairs.reserve(axisThresholds.pairs);
    for (std::size_t k = 0; k < axisThresholds.pairs; ++k) {
        const std::size_t i = k * (points.size() - 1) / axisThresholds.pairs;
        pairs.push_back({axis_T_scan * points[i], axis_T_scan.linear() * (points[i + 1] - points[i])});
    }
    return pairs;
}

/// Median distance between neighbours.
double typicalStepOf(const std::vector<NeighbourPair>& pairs)
{
    std::vector<double> lengths;
    lengths.reserve(pairs.size());
    for (const NeighbourPair& pair : pairs) lengths.push_back(pair.step.norm());
    return upperMedianInPlace(lengths);
}

/// The direction in which neighbours do not differ; nullopt when there is none.
std::optional<Vector3d> acrossRows(const std::vector<NeighbourPair>& pairs, double typical)
{
    Vector3d normal = Vector3d::UnitZ();
    double least = 0;
    double width = std::numeric_limits<double>::infinity();
    for (int round = 0; round < axisThresholds.row_rounds; ++round) {
        Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();
        for (const NeighbourPair& pair : pairs)
            if (pair.step.norm() < axisThresholds.longest_step * typical && std::abs(pair.step.dot(normal)) <= width)
                scatter += pair.step * pair.step.transpose();
        normal = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(scatter).eigenvectors().col(0);
        std::vector<double> off;
        off.reserve(pairs.size());
        for (const NeighbourPair& pair : pairs) off.push_back(std::abs(pair.step.dot(normal)));
        least = upperMedianInPlace(off);
        width = axisThresholds.row_widths * least + axisThresholds.least_row_width * typical;
    }
    if (!(least < axisThresholds.row_share * typical) || std::abs(normal.z()) < axisThresholds.least_across_cosine)
        return std::nullopt;
    return normal.z() < 0 ? Vector3d(-normal) : normal;
}

/// The position from which neighbours lie one angular step apart: noise acts along the rays and leaves their angles
/// unchanged. Sigma infinite: there is no such place.
struct RayOrigin {
    Vector2d centre = Vector2d::Zero();
    double sigma = std::numeric_limits<double>::infinity();
};

/// How fast the direction of an arm turns when its foot moves.
Vector2d turnOf(const Vector2d& arm)
{
    return Vector2d(arm.y(), -arm.x()) / arm.squaredNorm();
}

/// Gauss-Newton over position and step with Tukey weights scaled by the residuals.
class RayOriginFit {
public:
    /// Pairs of neighbours, in the plane of the rows.
    RayOriginFit(const std::vector<Vector2d>& first, const std::vector<Vector2d>& second)
        : first_(first), second_(second), angles_(first.size()), sizes_(first.size())
    {
        for (const Vector2d& p : first) place_.centre += p / static_cast<double>(first.size());
    }

    RayOrigin run()
    {
        measureAngles();
        std::vector<double> sorted = sizes_;
        step_ = upperMedianInPlace(sorted);
        if (!(step_ > axisThresholds.least_step_rad)) return {};
        scale_ = step_;
        for (int round = 0; round < axisThresholds.origin_rounds; ++round) {
            if (round > 0) measureAngles();
            const std::optional<double> change = improvePlace();
            if (!change) return {};
            if (*change < axisThresholds.settled_sigmas * place_.sigma + axisThresholds.settled_mm) break;
        }
        if (!(scale_ < axisThresholds.common_scale * step_)) return {};  // no common step
        return place_;
    }

private:
    void measureAngles()
    {
        for (std::size_t i = 0; i < first_.size(); ++i) {
            const Vector2d a = first_[i] - place_.centre;
            const Vector2d b = second_[i] - place_.centre;
            angles_[i] = std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b));
            sizes_[i] = std::abs(angles_[i]);
        }
    }

    /// One step of the fit; how far the place moves, in mm. nullopt: it is not determined.
    std::optional<double> improvePlace()
    {
        Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
        Vector3d right = Vector3d::Zero();
        std::vector<double> residuals;
        double squares = 0, weights = 0;
        for (std::size_t i = 0; i < first_.size(); ++i) {
            const double residual = sizes_[i] - step_;
            if (sizes_[i] < axisThresholds.single_step * step_) residuals.push_back(std::abs(residual));
            const double w = tukeyWeight(residual / scale_);
            if (w == 0) continue;
            const Vector2d by = (turnOf(second_[i] - place_.centre) - turnOf(first_[i] - place_.centre)) *
                                (angles_[i] < 0 ? -1.0 : 1.0);
            const Vector3d j(by.x(), by.y(), -1);
            normal += w * j * j.transpose();
            right -= w * residual * j;
            squares += w * residual * residual;
            weights += w;
        }
        if (weights < axisThresholds.least_weights || residuals.size() < first_.size() / axisThresholds.least_part)
            return std::nullopt;
        const Vector3d change = normal.ldlt().solve(right);
        if (!change.allFinite()) return std::nullopt;
        place_.centre += change.head<2>();
        step_ += change.z();
        if (!(step_ > axisThresholds.least_step_rad)) return std::nullopt;
        const Eigen::Matrix3d covariance = normal.inverse() * (squares / weights);
        place_.sigma = std::sqrt(covariance(0, 0) + covariance(1, 1));
        scale_ = std::clamp(axisThresholds.origin_scales * upperMedianInPlace(residuals),
                            axisThresholds.least_scale * step_, axisThresholds.first_scale * step_);
        return change.head<2>().norm();
    }

    const std::vector<Vector2d>& first_;
    const std::vector<Vector2d>& second_;
    RayOrigin place_;
    std::vector<double> angles_, sizes_;  ///< between neighbours, seen from the place; absolute
    double step_ = 0;                     ///< of angle, rad
    double scale_ = 0;                    ///< residual at which the weights reach 0, rad
};

}  // namespace

std::optional<ScannerAxis> findScannerAxis(const std::vector<Vector3d>& points, const Eigen::Isometry3d& axis_T_scan,
                                           double radius_mm)
{
    const std::vector<NeighbourPair> pairs = neighboursOf(points, axis_T_scan);
    if (pairs.empty()) return std::nullopt;
    const double typical = typicalStepOf(pairs);
    const auto normal = acrossRows(pairs, typical);
    if (!normal) return std::nullopt;
    ScannerAxis axis;
    axis.direction = *normal;
    axis.sigma_mm = axisOffsetShare * radius_mm;

    const Vector3d u = normal->unitOrthogonal();
    const Vector3d v = normal->cross(u);
    std::vector<Vector2d> first, second;
    for (const NeighbourPair& pair : pairs) {
        if (pair.step.norm() > axisThresholds.longest_step * typical ||
            std::abs(pair.step.dot(*normal)) > axisThresholds.in_row_share * typical)
            continue;
        const Vector3d next = pair.first + pair.step;
        first.emplace_back(pair.first.dot(u), pair.first.dot(v));
        second.emplace_back(next.dot(u), next.dot(v));
    }
    if (first.size() < axisThresholds.least_pairs) return axis;
    const RayOrigin place = RayOriginFit(first, second).run();
    if (place.sigma < axis.sigma_mm) {
        axis.point_mm = place.centre.x() * u + place.centre.y() * v;
        axis.sigma_mm = place.sigma;
    }
    return axis;
}

}  // namespace lathelier::registration
