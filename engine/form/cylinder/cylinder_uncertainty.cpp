#include "engine/form/cylinder/cylinder_uncertainty.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/core/parallel.h"
#include "engine/core/random.h"
#include "engine/core/statistics.h"
#include "engine/form/linear_minimax.h"
#include "engine/form/roundness/drawn_changes.h"
#include "engine/signal/hampel.h"

namespace lathelier::form {
namespace {

constexpr std::uint64_t cylinderDrawSeed = 12180;
constexpr int waves = 8, legendreDegree = 3;
constexpr int functions = (2 * waves + 1) * (legendreDegree + 1);
constexpr std::size_t enoughToFit = 20000;  ///< points used to fit the form
constexpr double leastCoefficient = 3;      ///< standard errors of a coefficient

using FormRow = Eigen::Vector<double, functions>;

/// Basis: circumferential Fourier terms times axial Legendre polynomials.
FormRow formRowAt(double angle, double u)
{
    const double along[] = {1, u, (3 * u * u - 1) / 2, (5 * u * u * u - 3 * u) / 2};
    FormRow row;
    int k = 0;
    for (int m = 0; m <= waves; ++m)
        for (int l = 0; l <= legendreDegree; ++l) {
            row[k++] = std::cos(m * angle) * along[l];
            if (m > 0) row[k++] = std::sin(m * angle) * along[l];
        }
    return row;
}

/// The points about the axis of the fit: distance, its slope, and the place on the surface.
struct Unrolled {
    std::vector<double> distance, angle, along;
    std::vector<Eigen::Vector4d> slope;
};

Unrolled unroll(const CylinderPoints& points, const AxisParameters& axis, const Progress& progress)
{
    Unrolled result;
    const double low = points.lowest(), height = std::max(points.highest() - low, 1e-300);
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (i % 16384 == 0) progress.check();
        const Eigen::Vector3d p = points.point(i);
        const AxisDistance d = distanceFrom(axis, p);
        result.distance.push_back(d.distance);
        result.slope.push_back(-d.gradient);
        result.angle.push_back(std::atan2(p.y() - axis[1] - p.z() * axis[3], p.x() - axis[0] - p.z() * axis[2]));
        result.along.push_back(2 * (p.z() - low) / height - 1);
    }
    return result;
}

/// The part of the deviations from `radius` explained by significant terms of the basis.
std::vector<double> explainedForm(const Unrolled& surface, double radius, double sigma, const Progress& progress)
{
    const std::size_t n = surface.distance.size(), stride = n / enoughToFit + 1;
    std::vector<double> form(n, 0.0);
    if (n < 4 * std::size_t{functions}) return form;
    Eigen::Matrix<double, functions, functions> normal = Eigen::Matrix<double, functions, functions>::Zero();
    FormRow right = FormRow::Zero();
    for (std::size_t i = 0; i < n; i += stride) {
        if (i / stride % 1024 == 0) progress.check();
        const FormRow row = formRowAt(surface.angle[i], surface.along[i]);
        normal.selfadjointView<Eigen::Lower>().rankUpdate(row);
        right += row * (surface.distance[i] - radius);
    }
    const double ridge = 1e-9 * normal.diagonal().maxCoeff();
    normal = normal.selfadjointView<Eigen::Lower>();
    normal.diagonal().array() += ridge;
    const Eigen::LDLT<Eigen::Matrix<double, functions, functions>> solver(normal);
    const FormRow variance = solver.solve(Eigen::Matrix<double, functions, functions>::Identity()).diagonal();
    FormRow coefficients = solver.solve(right);
    for (int k = 0; k < functions; ++k)
        if (std::abs(coefficients[k]) < leastCoefficient * sigma * std::sqrt(variance[k])) coefficients[k] = 0;
    parallelFor(n, 8192, progress, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            form[i] = coefficients.dot(formRowAt(surface.angle[i], surface.along[i]));
    });
    return form;
}

}  // namespace

double estimatedNoise(const CylinderPoints& points, const LeastSquaresCylinder& fit, const Progress& progress)
{
    const std::size_t n = points.size();
    if (n < 4 * std::size_t{functions}) return std::numeric_limits<double>::quiet_NaN();
    const Unrolled surface = unroll(points, fit.axis, progress);
    const std::vector<double> form = explainedForm(surface, fit.radius, 0, progress);
    std::vector<double> rest(n);
    double squares = 0;
    for (std::size_t i = 0; i < n; ++i) {
        rest[i] = surface.distance[i] - fit.radius - form[i];
        squares += rest[i] * rest[i];
    }
    const auto count = static_cast<double>(n);
    // Robust, as single flying points are no noise; values rounded to few steps may have no robust spread.
    const double robust = signal::robustSpread(rest, median(rest));
    return (robust > 0 ? robust : std::sqrt(squares / count)) * std::sqrt(count / (count - functions));
}

double expandedUncertaintyOfWidth(const CylinderPoints& points, const LeastSquaresCylinder& fit, double sigma,
                                  const Progress& progress)
{
    if (!(sigma > 0)) return 0;
    const std::size_t n = points.size();
    const Unrolled surface = unroll(points, fit.axis, progress);
    const std::vector<double> form = explainedForm(surface, fit.radius, sigma, progress);
    const double half = fit.radius / 2;
    const auto width = [&](double noise, std::uint64_t draw) {
        LinearDistances<4> distances;
        for (std::size_t i = 0; i < n; ++i)
            distances.push(fit.radius + form[i] + noise * randomNormal(cylinderDrawSeed, draw, i), surface.slope[i]);
        return minimax(distances, MinimaxGoal::Width, half).value;
    };
    const double quiet = width(0, 0);
    std::vector<double> changes(std::clamp<std::size_t>(400000 / n, 12, 120));
    parallelFor(changes.size(), 1, progress,
                [&](std::size_t begin, std::size_t) { changes[begin] = width(sigma, begin) - quiet; });
    // With few points the form under the simulated noise is itself uncertain.
    const double few = 1 + functions / (2.0 * static_cast<double>(n));
    return few * coverageHalfWidth(std::move(changes), 0);
}

}  // namespace lathelier::form
