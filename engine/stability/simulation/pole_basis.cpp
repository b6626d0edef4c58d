#include "engine/stability/simulation/pole_basis.h"

#include <Eigen/Eigenvalues>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <complex>

#include "engine/stability/boundary.h"

namespace lathelier::stability {
namespace {

constexpr double smoothRatio = 4;       ///< of the frequencies of neighbouring smooth terms
constexpr double beyondLast = 2;        ///< last smooth term over the last line
constexpr std::size_t evenLines = 240;  ///< evenly over the logarithm of the frequency
constexpr int linesOfPole = 20;         ///< on each side
constexpr double widthsOfPole = 12;     ///< half widths ζf on each side

}  // namespace

std::vector<Pole> smoothTerms(double from_hz, double to_hz)
{
    const double span = beyondLast * to_hz / from_hz;
    const int steps = std::max(1, static_cast<int>(std::ceil(std::log(span) / std::log(smoothRatio))));
    std::vector<Pole> terms;
    for (int i = 0; i <= steps; ++i) terms.push_back({from_hz * std::pow(span, static_cast<double>(i) / steps), 1});
    return terms;
}

Frf linesAround(const Frf& frf, const std::vector<Pole>& poles)
{
    const double from = std::max(frf.frequency_hz.front(), 1e-3 * frf.frequency_hz.back());
    const double to = frf.frequency_hz.back();
    Frf lines;
    for (std::size_t i = 0; i < evenLines; ++i)
        lines.frequency_hz.push_back(from * std::pow(to / from, static_cast<double>(i) / (evenLines - 1)));
    for (const Pole& pole : poles)
        for (int i = -linesOfPole; i <= linesOfPole; ++i) {
            const double share = static_cast<double>(i) / linesOfPole;  // denser near the pole
            const double f = pole.frequency_hz * (1 + widthsOfPole * pole.damping_ratio * share * std::abs(share));
            if (f > from && f < to) lines.frequency_hz.push_back(f);
        }
    std::sort(lines.frequency_hz.begin(), lines.frequency_hz.end());
    for (double& f : lines.frequency_hz) f = std::clamp(f, from, to);
    for (const double f : lines.frequency_hz) lines.value.push_back(interpolated(frf, f));
    return lines;
}

Eigen::MatrixXcd termsOf(const std::vector<Pole>& poles, const std::vector<double>& frequency_hz)
{
    Eigen::MatrixXcd terms(static_cast<Eigen::Index>(frequency_hz.size()), static_cast<Eigen::Index>(2 * poles.size()));
    for (Eigen::Index row = 0; row < terms.rows(); ++row)
        for (std::size_t p = 0; p < poles.size(); ++p) {
            const double r = frequency_hz[static_cast<std::size_t>(row)] / poles[p].frequency_hz;
            const std::complex<double> term = 1.0 / std::complex<double>(1 - r * r, 2 * poles[p].damping_ratio * r);
            const auto column = static_cast<Eigen::Index>(2 * p);
            terms(row, column) = term;
            terms(row, column + 1) = std::complex<double>(0, r) * term;
        }
    return terms;
}

Eigen::MatrixXd realRows(const Eigen::MatrixXcd& lines)
{
    Eigen::MatrixXd rows(2 * lines.rows(), lines.cols());
    rows << lines.real(), lines.imag();
    return rows;
}

Eigen::VectorXd leastSquares(Eigen::MatrixXd rows, const Eigen::VectorXd& right)
{
    Eigen::VectorXd size = rows.colwise().norm().transpose();
    for (double& one : size)
        if (!(one > 0)) one = 1;
    rows = rows * size.cwiseInverse().asDiagonal();
    return rows.colPivHouseholderQr().solve(right).cwiseQuotient(size);
}

Eigen::VectorXcd eigenvaluesOf(const Eigen::MatrixXd& matrix)
{
    return Eigen::EigenSolver<Eigen::MatrixXd>(matrix, false).eigenvalues();
}

}  // namespace lathelier::stability
