// g++ 12 at -O3 takes Eigen's zero-sized temporaries for values without initialisation.
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#endif

#include "engine/core/small_solve.h"

#include <Eigen/Dense>

namespace lathelier {
namespace {

template <int n>
SymmetricAxes<n> axesOf(const Eigen::Matrix<double, n, n>& symmetric)
{
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, n, n>> solver(symmetric);
    return {solver.eigenvalues(), solver.eigenvectors()};
}

}  // namespace

SymmetricAxes<3> symmetricAxes(const Eigen::Matrix3d& symmetric)
{
    return axesOf<3>(symmetric);
}

SymmetricAxes<6> symmetricAxes(const Eigen::Matrix<double, 6, 6>& symmetric)
{
    return axesOf<6>(symmetric);
}

Eigen::MatrixXd rightSingularVectors(const Eigen::MatrixXd& a)
{
    return Eigen::JacobiSVD<Eigen::MatrixXd>(a, Eigen::ComputeFullV).matrixV();
}

Eigen::MatrixXd pseudoInverse(const Eigen::MatrixXd& a)
{
    return a.completeOrthogonalDecomposition().pseudoInverse();
}

Eigen::Index rankOf(const Eigen::MatrixXd& a, double threshold)
{
    Eigen::FullPivLU<Eigen::MatrixXd> solver(a);
    solver.setThreshold(threshold);
    return solver.rank();
}

Eigen::Vector2cd solveFullPivoting(const Eigen::Matrix2cd& a, const Eigen::Vector2cd& b)
{
    return a.fullPivLu().solve(b);
}

Eigen::Vector3cd solveFullPivoting(const Eigen::Matrix3cd& a, const Eigen::Vector3cd& b)
{
    return a.fullPivLu().solve(b);
}

Eigen::Vector3cd leastSquares(const ThreeColumns& a, const Eigen::VectorXcd& b)
{
    return a.colPivHouseholderQr().solve(b);
}

Eigen::Vector3d singularValues(const ThreeColumns& a)
{
    return a.jacobiSvd().singularValues();
}

}  // namespace lathelier
