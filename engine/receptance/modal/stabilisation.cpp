#include "engine/receptance/modal/stabilisation.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/core/plain_complex.h"

namespace lathelier::receptance {
namespace {

using Eigen::Index;
constexpr double stableFrequency = 0.01, stableDamping = 0.1;  ///< relative
constexpr double leastPoleDamping = 1e-5, mostPoleDamping = 0.4;
constexpr int longEnough = 3;    ///< orders
constexpr double margin = 1.02;  ///< Nyquist frequency of the z-domain over the last line
constexpr Index mostCoefficients = 2 * mostOrder + 1;

/// Σ over lines by lag: w² z^l, -w² G z^l (real parts, lags of both signs), w² |G|² z^l.
struct LagSums {
    std::vector<double> numerator, denominator, cross;
};

LagSums lagSums(const FitLines& lines, double nyquist_hz)
{
    const auto most = static_cast<std::size_t>(mostCoefficients);
    LagSums sums{std::vector<double>(most), std::vector<double>(most), std::vector<double>(2 * most - 1)};
    for (std::size_t i = 0; i < lines.value.size(); ++i) {
        const double w2 = lines.weight[i] * lines.weight[i],
                     angle = std::numbers::pi * lines.frequency_hz[i] / nyquist_hz;
        const std::complex<double> z(std::cos(angle), std::sin(angle)), g = w2 * lines.value[i];
        const double g2 = w2 * std::norm(lines.value[i]);
        std::complex<double> power(1, 0);
        for (std::size_t l = 0; l < most; ++l) {
            sums.numerator[l] += w2 * power.real();
            sums.denominator[l] += g2 * power.real();
            const double direct = g.real() * power.real(), turned = g.imag() * power.imag();
            sums.cross[most - 1 + l] -= direct - turned;
            if (l > 0) sums.cross[most - 1 - l] -= direct + turned;
            power = product(power, z);
        }
    }
    return sums;
}

/// Equations of the denominator with the numerators eliminated: Σ T - Sᵀ R⁻¹ S over the responses.
Eigen::MatrixXd reduced(const std::vector<LagSums>& responses, Index coefficients)
{
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(coefficients, coefficients);
    for (const LagSums& sums : responses) {
        Eigen::MatrixXd r(coefficients, coefficients), s(coefficients, coefficients), t(coefficients, coefficients);
        for (Index j = 0; j < coefficients; ++j)
            for (Index k = 0; k < coefficients; ++k) {
                const auto lag = static_cast<std::size_t>(std::abs(k - j));
                r(j, k) = sums.numerator[lag];
                t(j, k) = sums.denominator[lag];
                s(j, k) = sums.cross[static_cast<std::size_t>(mostCoefficients - 1 + k - j)];
            }
        matrix += t - s.transpose() * r.ldlt().solve(s);
    }
    return matrix;
}

std::vector<Pole> polesOf(const Eigen::MatrixXd& matrix, double nyquist_hz)
{
    const Index order = matrix.rows() - 1;
    // The lowest coefficient is 1: poles of noise become unstable (Cauberghe et al., Mech. Syst. Signal Process. 19
    // (2005) 1239), and are left out.
    const Eigen::VectorXd a = -matrix.bottomRightCorner(order, order).ldlt().solve(matrix.block(1, 0, order, 1));
    if (!a.allFinite() || a(order - 1) == 0) return {};
    Eigen::MatrixXd companion = Eigen::MatrixXd::Zero(order, order);
    companion.diagonal(-1).setOnes();
    companion(0, order - 1) = -1 / a(order - 1);
    for (Index j = 1; j < order; ++j) companion(j, order - 1) = -a(j - 1) / a(order - 1);
    std::vector<Pole> poles;
    for (const std::complex<double>& z : companion.eigenvalues()) {
        if (!(z.imag() > 0)) continue;
        const std::complex<double> s = std::log(z);  // times the sampling frequency
        const double size = std::abs(s), damping = -s.real() / size;
        if (damping < leastPoleDamping || damping > mostPoleDamping) continue;
        poles.push_back({size * nyquist_hz / std::numbers::pi, damping});
    }
    std::sort(poles.begin(), poles.end(), [](const Pole& x, const Pole& y) { return x.frequency_hz < y.frequency_hz; });
    return poles;
}

bool isNear(double a, double b, double share)
{
    return std::abs(a - b) <= share * std::max(a, b);
}

}  // namespace

std::vector<OrderPole> polesByOrder(std::span<const FitLines> lines, const Progress& progress)
{
    const Interval range = spanOf(lines);
    const double nyquist_hz = margin * range.to;
    std::vector<LagSums> sums;
    for (const FitLines& one : lines) {
        progress.check();
        sums.push_back(lagSums(one, nyquist_hz));
    }
    std::vector<OrderPole> all;
    std::vector<Pole> before;
    for (int order = 1; order <= mostOrder; ++order) {
        progress.check();
        const std::vector<Pole> poles = polesOf(reduced(sums, 2 * order + 1), nyquist_hz);
        for (const Pole& pole : poles) {
            if (pole.frequency_hz < range.from || pole.frequency_hz > range.to) continue;
            OrderPole one{order, pole.frequency_hz, pole.damping};
            for (const Pole& last : before) {
                if (!isNear(last.frequency_hz, pole.frequency_hz, stableFrequency)) continue;
                one.is_stable = true;
                one.is_damping_stable |= isNear(last.damping, pole.damping, stableDamping);
            }
            all.push_back(one);
        }
        before = poles;
    }
    return all;
}

std::vector<Pole> stablePoles(const std::vector<OrderPole>& all)
{
    struct Column {
        Pole last;
        int order, length;
    };
    std::vector<Column> columns;
    for (const OrderPole& one : all) {
        Column* nearest = nullptr;
        for (Column& column : columns)
            if (column.order == one.order - 1 && isNear(column.last.frequency_hz, one.frequency_hz, stableFrequency) &&
                isNear(column.last.damping, one.damping_ratio, stableDamping) &&
                (!nearest || std::abs(column.last.frequency_hz - one.frequency_hz) <
                                 std::abs(nearest->last.frequency_hz - one.frequency_hz)))
                nearest = &column;
        const Pole pole{one.frequency_hz, one.damping_ratio};
        if (nearest)
            *nearest = {pole, one.order, nearest->length + 1};
        else
            columns.push_back({pole, one.order, 1});
    }
    std::erase_if(columns, [](const Column& column) { return column.length < longEnough; });
    std::stable_sort(columns.begin(), columns.end(),
                     [](const Column& a, const Column& b) { return a.length > b.length; });
    std::vector<Pole> poles;
    for (const Column& column : columns) {
        const bool is_known = std::any_of(poles.begin(), poles.end(), [&](const Pole& pole) {
            return isNear(pole.frequency_hz, column.last.frequency_hz, stableFrequency);
        });
        if (!is_known) poles.push_back(column.last);
    }
    return poles;
}

}  // namespace lathelier::receptance
