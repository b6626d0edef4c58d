#include "engine/signal/fourier_fit.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <optional>

#include "engine/signal/fourier.h"
#include "engine/signal/nonuniform_fourier.h"

namespace lathelier::signal {
namespace {

using Complex = std::complex<double>;
using Coefficients = std::vector<Complex>;

constexpr int mostIterations = 80;     ///< more iterations indicate undetermined orders
constexpr double goal = 1e-13;         ///< relative residual to reach
constexpr double sufficient = 1e-10;   ///< relative residual accepted when rounding prevents further progress
constexpr double worstCondition = 30;  ///< largest ratio of eigenvalues; noise is amplified by at most its square root

/// The inner product of two real functions given by their coefficients.
double dot(const Coefficients& a, const Coefficients& b)
{
    double sum = (std::conj(a[0]) * b[0]).real();
    for (std::size_t k = 1; k < a.size(); ++k) sum += 2 * (std::conj(a[k]) * b[k]).real();
    return sum;
}

/// The normal matrix T_kl = Σ_j w_j e^{-i(k-l)θ_j}, applied as a product of functions on a grid fine enough for it.
class NormalMatrix {
public:
    NormalMatrix(const Coefficients& weight_sums, std::size_t orders)
        : transform_(quickTransformLength(4 * orders + 1)), orders_(orders)
    {
        weight_ = transform_.series(
            padded({weight_sums.begin(), weight_sums.begin() + static_cast<std::ptrdiff_t>(2 * orders - 1)}));
    }

    Coefficients operator*(const Coefficients& coefficients) const
    {
        std::vector<double> values = transform_.series(padded(coefficients));
        for (std::size_t i = 0; i < values.size(); ++i) values[i] *= weight_[i];
        Coefficients result = transform_.forward(values);
        result.resize(orders_);
        for (Complex& value : result) value /= static_cast<double>(transform_.length());
        return result;
    }

private:
    Coefficients padded(Coefficients coefficients) const
    {
        coefficients.resize(transform_.length() / 2 + 1);
        return coefficients;
    }

    FourierTransform transform_;
    std::size_t orders_;
    std::vector<double> weight_;
};

/// Condition of the normal matrix estimated from the conjugate gradients: their coefficients are the entries of
/// Lanczos' tridiagonal matrix, whose extreme eigenvalues are those of the normal matrix.
double conditionOf(const std::vector<double>& step, const std::vector<double>& turn)
{
    const auto n = static_cast<Eigen::Index>(step.size());
    Eigen::VectorXd diagonal(n), beside(std::max<Eigen::Index>(0, n - 1));
    for (Eigen::Index i = 0; i < n; ++i) {
        const auto k = static_cast<std::size_t>(i);
        diagonal[i] = 1 / step[k] + (i > 0 ? turn[k - 1] / step[k - 1] : 0);
        if (i + 1 < n) beside[i] = std::sqrt(turn[k]) / step[k];
    }
    Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver;
    solver.computeFromTridiagonal(diagonal, beside, Eigen::EigenvaluesOnly);
    return solver.eigenvalues()[n - 1] / std::max(solver.eigenvalues()[0], 1e-300);
}

/// None when the orders are not determined.
std::optional<Coefficients> solve(const NormalMatrix& matrix, const Coefficients& right, const Progress& progress)
{
    Coefficients solution(right.size()), residual = right, direction = right;
    const double start = dot(right, right);
    double squared = start;
    std::vector<double> steps, turns;
    for (int i = 0; i < mostIterations && squared > goal * goal * start; ++i) {
        progress.check();
        const Coefficients image = matrix * direction;
        const double curvature = dot(direction, image);
        if (!(curvature > 0)) break;
        const double step = squared / curvature;
        for (std::size_t k = 0; k < right.size(); ++k) {
            solution[k] += step * direction[k];
            residual[k] -= step * image[k];
        }
        const double next = dot(residual, residual);
        for (std::size_t k = 0; k < right.size(); ++k) direction[k] = residual[k] + (next / squared) * direction[k];
        steps.push_back(step);
        turns.push_back(next / squared);
        squared = next;
    }
    if (squared > sufficient * sufficient * start) return std::nullopt;
    if (!steps.empty() && conditionOf(steps, turns) > worstCondition) return std::nullopt;
    return solution;
}

}  // namespace

Coefficients fitFourier(const AngularSampling& sampling, std::span<const double> values, int limit,
                        const Progress& progress)
{
    int order = std::max(0, std::min(limit, carriedOrders(sampling).determined));
    std::vector<double> weighted(values.size());
    for (std::size_t j = 0; j < values.size(); ++j) weighted[j] = sampling.weight[j] * values[j];
    const Coefficients weight_sums = fourierSums(sampling.angle_rad, sampling.weight, 2 * order, progress);
    Coefficients right = fourierSums(sampling.angle_rad, weighted, order, progress);
    for (;; order = order * 3 / 4) {
        const auto orders = static_cast<std::size_t>(order) + 1;
        right.resize(orders);
        if (order == 0) return {right[0] / weight_sums[0]};
        if (auto solution = solve(NormalMatrix(weight_sums, orders), right, progress)) return *solution;
    }
}

}  // namespace lathelier::signal
