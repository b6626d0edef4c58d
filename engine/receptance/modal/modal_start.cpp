#include "engine/receptance/modal/modal_start.h"

#include <Eigen/Eigenvalues>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>

#include "engine/core/plain_complex.h"

namespace lathelier::receptance {
namespace {

using Complex = std::complex<double>;
constexpr int iterations = 12;
constexpr double firstDamping = 0.01;
constexpr double leastStartDamping = 1e-5, mostStartDamping = 0.5;
constexpr double widestStart = 2;  ///< bound of the poles as factor of the first and last frequency

/// The pole pair's two real basis functions at s = i·f.
std::pair<Complex, Complex> basisOf(Complex pole, double frequency_hz)
{
    const Complex s(0, frequency_hz), first = reciprocal(s - pole), second = reciprocal(s - std::conj(pole));
    return {first + second, Complex(0, 1) * (first - second)};
}

Complex poleOf(double frequency_hz, double damping)
{
    return frequency_hz * Complex(-damping, std::sqrt(std::max(0.0, 1 - damping * damping)));
}

/// Zeros of the denominator: the next poles. Real zeros are paired into heavily damped poles.
std::vector<Complex> movedPoles(const std::vector<Complex>& poles, const Eigen::VectorXd& numerator, double constant)
{
    const auto count = static_cast<Eigen::Index>(poles.size());
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(2 * count, 2 * count);
    for (Eigen::Index k = 0; k < count; ++k) {
        const Complex pole = poles[static_cast<std::size_t>(k)];
        matrix.block<2, 2>(2 * k, 2 * k) << pole.real(), pole.imag(), -pole.imag(), pole.real();
        matrix.row(2 * k) -= 2 * numerator.transpose() / constant;
    }
    const Eigen::VectorXcd zeros = matrix.eigenvalues();
    std::vector<Complex> result;
    std::vector<double> reals;
    result.reserve(poles.size());
    for (const Complex& zero : zeros) {
        if (zero.imag() > 0) result.push_back({-std::abs(zero.real()), zero.imag()});
        if (zero.imag() == 0) reals.push_back(std::abs(zero.real()));
    }
    std::sort(reals.begin(), reals.end());
    for (std::size_t i = 0; i + 1 < reals.size(); i += 2)
        result.push_back(poleOf(std::sqrt(reals[i] * reals[i + 1]), mostStartDamping));
    return result;
}

/// One step of the Sanathanan-Koerner iteration.
std::vector<Complex> nextPoles(const FitLines& lines, const std::vector<Complex>& poles, double size)
{
    const auto pairs = static_cast<Eigen::Index>(poles.size());
    const auto count = static_cast<Eigen::Index>(lines.frequency_hz.size());
    const Eigen::Index columns = 4 * pairs + 3;  // numerator, mass line, constant, denominator, its constant
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(2 * count + 1, columns);
    Eigen::VectorXd right = Eigen::VectorXd::Zero(2 * count + 1);
    const double lowest = lines.frequency_hz.front();
    const auto put = [&](Eigen::Index line, Eigen::Index column, Complex value) {
        matrix(2 * line, column) = value.real();
        matrix(2 * line + 1, column) = value.imag();
    };
    for (Eigen::Index i = 0; i < count; ++i) {
        const auto at = static_cast<std::size_t>(i);
        const double f = lines.frequency_hz[at], w = lines.weight[at];
        const Complex g = lines.value[at];
        for (Eigen::Index k = 0; k < pairs; ++k) {
            const auto [first, second] = basisOf(poles[static_cast<std::size_t>(k)], f);
            put(i, 2 * k, w * first);
            put(i, 2 * k + 1, w * second);
            put(i, 2 * pairs + 2 + 2 * k, -w * g * first);
            put(i, 2 * pairs + 3 + 2 * k, -w * g * second);
            matrix(2 * count, 2 * pairs + 2 + 2 * k) += size * first.real();
            matrix(2 * count, 2 * pairs + 3 + 2 * k) += size * second.real();
        }
        put(i, 2 * pairs, w * (lowest * lowest) / (f * f));
        put(i, 2 * pairs + 1, w);
        put(i, columns - 1, -w * g);
        matrix(2 * count, columns - 1) += size;
    }
    right(2 * count) = size * static_cast<double>(count);
    const Eigen::VectorXd scale = matrix.colwise().norm().cwiseMax(1e-300).cwiseInverse();
    matrix = matrix * scale.asDiagonal();
    const Eigen::VectorXd solved = scale.asDiagonal() * matrix.householderQr().solve(right);
    const double constant = solved(columns - 1);
    if (!solved.allFinite() || std::abs(constant) < 1e-8) return poles;
    return movedPoles(poles, solved.segment(2 * pairs + 2, 2 * pairs), constant);
}

}  // namespace

std::vector<PoleTerm> rationalStart(const FitLines& lines, int count, const Progress& progress)
{
    const double low = lines.frequency_hz.front(), high = lines.frequency_hz.back();
    std::vector<Complex> poles;
    poles.reserve(static_cast<std::size_t>(count));
    for (int i = 0; i < count; ++i) poles.push_back(poleOf(low + (i + 0.5) / count * (high - low), firstDamping));
    double size = 0;
    for (std::size_t i = 0; i < lines.value.size(); ++i) size += std::norm(lines.weight[i] * lines.value[i]);
    size = std::sqrt(size) / static_cast<double>(lines.value.size());
    for (int i = 0; i < iterations; ++i) {
        progress.check();
        poles = nextPoles(lines, poles, size);
    }
    std::vector<PoleTerm> terms;
    terms.reserve(poles.size());
    for (const Complex& pole : poles) {
        const double f = std::clamp(std::abs(pole), low / widestStart, high * widestStart);
        terms.push_back({f, std::clamp(-pole.real() / std::abs(pole), leastStartDamping, mostStartDamping), 0, 0});
    }
    return terms;
}

std::vector<PoleTerm> withWorstPeak(const FitLines& lines, const Refined& model)
{
    const std::size_t count = lines.frequency_hz.size();
    std::vector<double> error(count);
    for (std::size_t i = 0; i < count; ++i)
        error[i] = std::norm(lines.weight[i] * (lines.value[i] - valueOf(model, lines.frequency_hz[i])));
    std::size_t worst = 0;
    double most = -1;
    for (std::size_t i = 0; i < count; ++i) {  // smoothed, since single lines may be noise
        double sum = 0;
        for (std::size_t j = i > 1 ? i - 2 : 0; j < std::min(count, i + 3); ++j) sum += error[j];
        if (sum <= most) continue;
        most = sum;
        worst = i;
    }
    const std::size_t next = std::min(count - 1, worst + 1), before = worst > 0 ? worst - 1 : 0;
    const double step = (lines.frequency_hz[next] - lines.frequency_hz[before]) / static_cast<double>(next - before);
    const double f = lines.frequency_hz[worst];
    std::vector<PoleTerm> terms = model.terms;
    terms.push_back({f, std::clamp(2 * step / f, firstDamping, mostStartDamping), 0, 0});
    return terms;
}

}  // namespace lathelier::receptance
