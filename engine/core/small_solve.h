// Decompositions of small matrices, compiled once: each of them costs a source that uses it several seconds.
// Sources: Eigen's solvers of the same names.
#pragma once

#include <Eigen/Core>
#include <complex>

namespace lathelier {

/// Of a symmetric matrix: eigenvalues in ascending order and unit eigenvectors in the columns (SelfAdjointEigenSolver).
template <int n>
struct SymmetricAxes {
    Eigen::Matrix<double, n, 1> values;
    Eigen::Matrix<double, n, n> vectors;
};
SymmetricAxes<3> symmetricAxes(const Eigen::Matrix3d& symmetric);
SymmetricAxes<6> symmetricAxes(const Eigen::Matrix<double, 6, 6>& symmetric);

/// V of A = U S Vᵀ, all columns, singular values in descending order (JacobiSVD).
Eigen::MatrixXd rightSingularVectors(const Eigen::MatrixXd& a);

/// A⁺ by a complete orthogonal decomposition.
Eigen::MatrixXd pseudoInverse(const Eigen::MatrixXd& a);

/// Pivots above `threshold` times the largest one (FullPivLU).
Eigen::Index rankOf(const Eigen::MatrixXd& a, double threshold);

/// A x = b with pivots of the whole matrix (FullPivLU).
Eigen::Vector2cd solveFullPivoting(const Eigen::Matrix2cd& a, const Eigen::Vector2cd& b);
Eigen::Vector3cd solveFullPivoting(const Eigen::Matrix3cd& a, const Eigen::Vector3cd& b);

using ThreeColumns = Eigen::Matrix<std::complex<double>, Eigen::Dynamic, 3>;

/// The x of least |A x − b| (ColPivHouseholderQR).
Eigen::Vector3cd leastSquares(const ThreeColumns& a, const Eigen::VectorXcd& b);

/// In descending order (JacobiSVD).
Eigen::Vector3d singularValues(const ThreeColumns& a);

}  // namespace lathelier
