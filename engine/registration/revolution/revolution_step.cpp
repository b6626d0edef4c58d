#include "engine/registration/revolution/revolution_step.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/core/parallel.h"
#include "engine/core/statistics.h"
#include "engine/registration/point_tasks.h"

namespace lathelier::registration {
namespace {

using Eigen::Matrix4d;
using Eigen::Vector3d;
using Eigen::Vector4d;

/// Weights, condition and clusters of one step (README, "Thresholds").
struct AxisStepThresholds {
    double tukey_sigmas = 6;          ///< where the weights reach 0; efficiency 99 % for normal residuals
    double steep_cosine = 0.3;        ///< of a side bin's normal with the radius: steeper bins tell little of the side
    double least_eigenvalue = 1e-13;  ///< of the normal equations, over the largest: below it they are singular
    int patch_stretches = 96;         ///< clusters of the covariance, along the axis
};
constexpr AxisStepThresholds stepThresholds{};

/// Contribution of one point in the frame of the axis: residual along the normal, weight and Jacobian with respect to
/// the axis.
struct PointRow {
    int key = -1;  ///< index of its bin; -1: the point is left out
    bool side = false;
    double cosine = 0;
    double error = 0;
    double share = 0;   ///< Tukey weight
    double weight = 0;  ///< Tukey weight over the variance of the bin
    double u = 0;       ///< error over the range of the weight function
    double jacobian[4] = {};
};

[[gnu::always_inline]] inline PointRow pointRowOf(const Vector3d& p, const MeridianBins& bins)
{
    PointRow row;
    const double r = std::sqrt(p.x() * p.x() + p.y() * p.y());
    const int key = bins.find(p.z(), r);
    if (key < 0 || r == 0) return row;
    const MeridianBin& bin = bins.bins[static_cast<std::size_t>(key)];
    row.side = key < bins.wall_count;
    const double along = row.side ? p.z() : r;
    const double across = row.side ? r : p.z();
    row.error = bin.cosine * (across - bin.value - bin.slope * (along - bin.middle));
    const double per_sigma = 1 / bin.sigma;
    row.u = row.error * (per_sigma / stepThresholds.tukey_sigmas);
    if (!(row.u * row.u < 1)) return row;
    row.key = key;
    row.cosine = bin.cosine;
    row.share = tukeyWeight(row.u);
    row.weight = row.share * (per_sigma * per_sigma);
    const double per_r = 1 / r;
    const double c = p.x() * per_r;
    const double s = p.y() * per_r;
    // A shift (x0, y0) and slopes (tx, ty) of the axis: dr = -c (x0 + tx z) - s (y0 + ty z), dz = r (c tx + s ty).
    const double to_r = row.side ? bin.cosine : -bin.cosine * bin.slope;
    const double to_z = row.side ? -bin.cosine * bin.slope : bin.cosine;
    const double tilt = to_z * r - to_r * p.z();
    row.jacobian[0] = -to_r * c;
    row.jacobian[1] = -to_r * s;
    row.jacobian[2] = tilt * c;
    row.jacobian[3] = tilt * s;
    return row;
}

void accumulate(const std::vector<Vector3d>& points, std::size_t begin, std::size_t end, const Eigen::Isometry3d& pose,
                const MeridianBins& bins, Sums& sums)
{
    sums.bins.resize(bins.bins.size());
    // The lower triangle written out: this loop dominates the run time.
    double h[10] = {}, g[4] = {};
    for (std::size_t i = begin; i < end; ++i) {
        const PointRow row = pointRowOf(pose * points[i], bins);
        if (row.key < 0) continue;
        const double we = row.weight * row.error;
        int k = 0;
        for (int a = 0; a < 4; ++a) {
            const double wj = row.weight * row.jacobian[a];
            for (int b = 0; b <= a; ++b) h[k++] += wj * row.jacobian[b];
            g[a] += we * row.jacobian[a];
        }
        sums.squares += row.share * row.u * row.u;
        sums.weights += row.share;
        if (row.side && row.cosine > stepThresholds.steep_cosine) sums.side_weights += row.share;
        Sums::Bin& own = sums.bins[static_cast<std::size_t>(row.key)];
        own.weight += row.weight;
        own.error += we;
        own.square += we * row.error;
        for (int a = 0; a < 4; ++a) own.jacobian[a] += row.weight * row.jacobian[a];
    }
    int k = 0;
    for (int a = 0; a < 4; ++a) {
        for (int b = 0; b <= a; ++b, ++k) {
            sums.hessian(a, b) += h[k];
            if (a != b) sums.hessian(b, a) += h[k];
        }
        sums.gradient[a] += g[a];
    }
}

constexpr int patchSectors = 16;  // of the turn: what sectorOf() tells apart

std::size_t patchAt(int stretch, int sector)
{
    return static_cast<std::size_t>(stretch) * patchSectors + static_cast<std::size_t>(sector);
}

/// Which sixteenth of the turn, in any order.
int sectorOf(double x, double y)
{
    constexpr double tan22 = std::numbers::sqrt2 - 1;  // tangent of 22.5°
    const double a = std::abs(x);
    const double b = std::abs(y);
    const int within = b < a ? (b < tan22 * a ? 0 : 1) : (a < tan22 * b ? 2 : 3);
    return within + (x < 0 ? 4 : 0) + (y < 0 ? 8 : 0);
}

/// A covariance that is in no direction less than `least` nor, in the common principal directions, than `other`.
Matrix4d noLess(const Matrix4d& least, const Matrix4d& other)
{
    const Eigen::LLT<Matrix4d> root(least);
    if (root.info() != Eigen::Success) return least;
    const Matrix4d lower = root.matrixL();
    const Matrix4d half = lower.triangularView<Eigen::Lower>().solve(other);
    const Matrix4d relative = lower.triangularView<Eigen::Lower>().solve(half.transpose());
    const Eigen::SelfAdjointEigenSolver<Matrix4d> eigen((relative + relative.transpose()) / 2);
    if (!eigen.eigenvalues().allFinite()) return least;
    const Matrix4d turned = lower * eigen.eigenvectors();
    return turned * eigen.eigenvalues().cwiseMax(1.0).asDiagonal() * turned.transpose();
}

/// The motion of the frame whose axis changes by a shift (x, y) at the origin and two slopes.
Eigen::Isometry3d motionOf(const Vector4d& change)
{
    const Vector3d direction = Vector3d(change[2], change[3], 1).normalized();
    Eigen::Isometry3d move = Eigen::Isometry3d::Identity();
    // Rows that are orthonormal to the last bit; a quaternion of nearly equal vectors is so to 1e-8 only.
    const Vector3d across = (Vector3d::UnitX() - direction * direction.x()).normalized();
    move.linear() << across.transpose(), direction.cross(across).transpose(), direction.transpose();
    move.translation() = -(move.linear() * Vector3d(change[0], change[1], 0));
    return move;
}

}  // namespace

Step improve(const std::vector<Vector3d>& points, Eigen::Isometry3d& pose, MeridianBins& bins, const Progress& progress)
{
    Step step;
    step.sums = parallelReduce(
        points.size(), largeTaskPoints(points.size()), progress, Sums{},
        [&](std::size_t begin, std::size_t end) {
            Sums part;
            accumulate(points, begin, end, pose, bins, part);
            return part;
        },
        [](Sums all, const Sums& part) {
            all.add(part);
            return all;
        });
    Vector4d gradient = step.sums.gradient;
    step.hessian = step.sums.hessian;
    for (const Sums::Bin& bin : step.sums.bins) {
        if (bin.weight <= 0) continue;
        step.hessian -= bin.jacobian * bin.jacobian.transpose() / bin.weight;
        gradient -= bin.jacobian * (bin.error / bin.weight);
    }
    // Rejects only a singular system: before convergence an exact face may outweigh a rough side by ten decades.
    const double arm = bins.size_mm;
    const Vector4d unit(1, 1, 1 / arm, 1 / arm);
    const Matrix4d scaled = unit.asDiagonal() * step.hessian * unit.asDiagonal();
    const Eigen::SelfAdjointEigenSolver<Matrix4d> eigen(scaled);
    step.determined =
        eigen.eigenvalues()[0] > stepThresholds.least_eigenvalue * eigen.eigenvalues()[3] && eigen.eigenvalues()[3] > 0;
    if (!step.determined) return step;
    step.change = -(unit.asDiagonal() * scaled.ldlt().solve(unit.asDiagonal() * gradient));
    step.determined = step.change.allFinite();
    if (!step.determined) return step;

    for (std::size_t i = 0; i < step.sums.bins.size(); ++i) {
        const Sums::Bin& bin = step.sums.bins[i];
        if (bin.weight > 0)
            bins.bins[i].value += (bin.error + bin.jacobian.dot(step.change)) / bin.weight / bins.bins[i].cosine;
    }
    pose = motionOf(step.change) * pose;
    return step;
}

Matrix4d covarianceOf(const std::vector<Vector3d>& points, const Eigen::Isometry3d& pose, const MeridianBins& bins,
                      const Step& step, const Progress& progress)
{
    constexpr int patchStretches = stepThresholds.patch_stretches;
    using Patches = std::vector<Vector4d>;
    const double length = bins.step_mm * bins.side_count;
    const Patches patches = parallelReduce(
        points.size(), largeTaskPoints(points.size()), progress,
        Patches(static_cast<std::size_t>(patchSectors * patchStretches), Vector4d::Zero()),
        [&](std::size_t begin, std::size_t end) {
            Patches part(static_cast<std::size_t>(patchSectors * patchStretches), Vector4d::Zero());
            for (std::size_t i = begin; i < end; ++i) {
                const Vector3d p = pose * points[i];
                const PointRow row = pointRowOf(p, bins);
                if (row.key < 0) continue;
                const int sector = sectorOf(p.x(), p.y());
                const int stretch = std::clamp(static_cast<int>((p.z() - bins.z_start_mm) / length * patchStretches), 0,
                                               patchStretches - 1);
                const Sums::Bin& bin = step.sums.bins[static_cast<std::size_t>(row.key)];
                if (bin.weight <= 0) continue;
                const Vector4d own(row.jacobian[0], row.jacobian[1], row.jacobian[2], row.jacobian[3]);
                part[patchAt(stretch, sector)] += row.weight * row.error * (own - bin.jacobian / bin.weight);
            }
            return part;
        },
        [](Patches all, const Patches& part) {
            for (std::size_t k = 0; k < all.size(); ++k) all[k] += part[k];
            return all;
        });
    // Patches, for noise correlated around a place; whole rings, for noise correlated along a row.
    Matrix4d places = Matrix4d::Zero();
    Matrix4d rings = Matrix4d::Zero();
    for (int stretch = 0; stretch < patchStretches; ++stretch) {
        Vector4d ring = Vector4d::Zero();
        for (int sector = 0; sector < patchSectors; ++sector) {
            const Vector4d& patch = patches[patchAt(stretch, sector)];
            places += patch * patch.transpose();
            ring += patch;
        }
        rings += ring * ring.transpose();
    }
    const Matrix4d independent = step.hessian.inverse();
    return noLess(noLess(independent, independent * places * independent), independent * rings * independent);
}

}  // namespace lathelier::registration
