#include "engine/stability/simulation/growth_rate.h"

#include <Eigen/Eigenvalues>
#include <cmath>
#include <complex>
#include <numbers>

namespace lathelier::stability {
namespace {

constexpr double keptShare = 1e-11;  ///< of the largest eigenvalue of the snapshots' products

using SmallComplex =
    Eigen::Matrix<std::complex<double>, Eigen::Dynamic, Eigen::Dynamic, 0, mostSnapshots + 1, mostSnapshots + 1>;

}  // namespace

Growth growthOf(const SnapshotProducts& products, double revolution_s, int steps)
{
    const Eigen::Index n = products.same.rows() - 1;
    // Each snapshot and its successor by the size of the snapshot: fast decay would hide the later ones.
    const Eigen::VectorXd size = products.same.diagonal().head(n).cwiseSqrt();
    if (!(size.minCoeff() > 0) || !size.allFinite() || !products.same.allFinite()) return {};
    const auto scaled = [&](const Small& whole) -> Small {
        return size.cwiseInverse().asDiagonal() * whole * size.cwiseInverse().asDiagonal();
    };
    const Small now = scaled(products.same.topLeftCorner(n, n)), next = scaled(products.same.block(0, 1, n, n));
    const Eigen::SelfAdjointEigenSolver<Small> basis(now);
    const Eigen::VectorXd& power = basis.eigenvalues();
    Eigen::Index kept = 0;
    while (kept < n && power[n - 1 - kept] > keptShare * power[n - 1]) ++kept;
    const Small towards =
        basis.eigenvectors().rightCols(kept) * power.tail(kept).cwiseSqrt().cwiseInverse().asDiagonal();
    const Small map = towards.transpose() * next * towards;
    const Eigen::EigenSolver<Small> solver(map);
    Eigen::Index largest = 0;
    for (Eigen::Index i = 1; i < kept; ++i)
        if (std::abs(solver.eigenvalues()[i]) > std::abs(solver.eigenvalues()[largest])) largest = i;
    Growth growth{std::abs(solver.eigenvalues()[largest]), 0};
    // From one step to the next the eigenvector turns by less than half a turn: that says which of the frequencies
    // that look alike from revolution to revolution it is.
    const SmallComplex weights = towards * solver.eigenvectors().col(largest);
    const std::complex<double> step = (weights.adjoint() * scaled(products.later) * weights)(0, 0);
    growth.frequency_hz = std::abs(std::arg(step)) / (2 * std::numbers::pi) * steps / revolution_s;
    return growth;
}

}  // namespace lathelier::stability
