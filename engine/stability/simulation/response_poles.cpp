#include "engine/stability/simulation/response_poles.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <complex>

namespace lathelier::stability {
namespace {

constexpr std::size_t mostPoles = 24;
constexpr int relocations = 4;
constexpr double peakDamping = 0.02;  ///< start value of a peak
constexpr double apart = 0.03;        ///< of peaks, relative
constexpr double smallShare = 0.1;    ///< of the median of |G|: smaller values need no relative precision
constexpr double strongest = 0.5;     ///< damping ratio above which a pole is left to the smooth terms

/// Weights 1/|G|, bounded.
Eigen::VectorXd weightsOf(const Frf& lines)
{
    std::vector<double> size;
    size.reserve(lines.value.size());
    for (const auto& g : lines.value) size.push_back(std::abs(g));
    std::vector<double> sorted = size;
    std::nth_element(sorted.begin(), sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2), sorted.end());
    const double least = smallShare * sorted[sorted.size() / 2];
    Eigen::VectorXd weights(static_cast<Eigen::Index>(size.size()));
    for (std::size_t i = 0; i < size.size(); ++i) weights[static_cast<Eigen::Index>(i)] = 1 / std::max(size[i], least);
    return weights;
}

/// The peaks of |G| f, which does not fall with the frequency as |G| does, the highest first.
std::vector<Pole> peaksOf(const Frf& frf)
{
    struct Peak {
        double frequency_hz, size;
    };
    std::vector<Peak> peaks;
    const auto size = [&](std::size_t i) { return std::abs(frf.value[i]) * frf.frequency_hz[i]; };
    for (std::size_t i = 1; i + 1 < frf.value.size(); ++i)
        if (size(i) > size(i - 1) && size(i) >= size(i + 1)) peaks.push_back({frf.frequency_hz[i], size(i)});
    std::sort(peaks.begin(), peaks.end(), [](const Peak& a, const Peak& b) { return a.size > b.size; });
    std::vector<Pole> poles;
    for (const Peak& peak : peaks) {
        const bool is_new = std::none_of(poles.begin(), poles.end(), [&](const Pole& other) {
            return std::abs(other.frequency_hz - peak.frequency_hz) < apart * peak.frequency_hz;
        });
        if (is_new && poles.size() < mostPoles / 2) poles.push_back({peak.frequency_hz, peakDamping});
    }
    return poles;
}

/// One relocation: the zeros of σ = 1 + Σ c̃ φ.
std::vector<Pole> relocated(const Frf& frf, const std::vector<Pole>& poles)
{
    using Complex = std::complex<double>;
    const Frf lines = linesAround(frf, poles);
    const auto rows = static_cast<Eigen::Index>(lines.value.size());
    const auto own = static_cast<Eigen::Index>(2 * poles.size());
    std::vector<Pole> all = smoothTerms(lines.frequency_hz.front(), lines.frequency_hz.back());
    all.insert(all.end(), poles.begin(), poles.end());
    const Eigen::MatrixXcd terms = termsOf(all, lines.frequency_hz);
    const Eigen::VectorXd weights = weightsOf(lines);
    const double scale = lines.frequency_hz.back();
    Eigen::MatrixXcd system(rows, terms.cols() + 1 + own);
    system.leftCols(terms.cols()) = terms;
    system.col(terms.cols()).setOnes();
    Eigen::VectorXcd right(rows);
    Eigen::MatrixXd companion = Eigen::MatrixXd::Zero(own, own);
    for (std::size_t p = 0; p < poles.size(); ++p) {
        const double f = poles[p].frequency_hz / scale, z = poles[p].damping_ratio;
        const Complex pole(-z * f, f * std::sqrt(1 - z * z));
        const auto at = static_cast<Eigen::Index>(2 * p);
        companion(at, at) = companion(at + 1, at + 1) = pole.real();
        companion(at, at + 1) = pole.imag();
        companion(at + 1, at) = -pole.imag();
        for (Eigen::Index row = 0; row < rows; ++row) {
            const Complex s(0, lines.frequency_hz[static_cast<std::size_t>(row)] / scale);
            const Complex one = 1.0 / (s - pole), other = 1.0 / (s - std::conj(pole));
            const Complex g = lines.value[static_cast<std::size_t>(row)];
            system(row, terms.cols() + 1 + at) = -g * (one + other);
            system(row, terms.cols() + 2 + at) = -g * Complex(0, 1) * (one - other);
        }
    }
    for (Eigen::Index row = 0; row < rows; ++row)
        right[row] = weights[row] * lines.value[static_cast<std::size_t>(row)];
    system = weights.asDiagonal() * system;
    const Eigen::VectorXd found = leastSquares(realRows(system), realRows(right));
    for (Eigen::Index pair = 0; pair < own; pair += 2) companion.row(pair) -= 2 * found.tail(own).transpose();

    std::vector<Pole> moved;
    for (const Complex& zero : eigenvaluesOf(companion)) {
        if (!(zero.imag() > 0)) continue;
        const double size = std::abs(zero);
        moved.push_back({size * scale, std::max(1e-6, std::abs(zero.real()) / size)});
    }
    return moved;
}

}  // namespace

std::vector<Pole> polesOf(const Frf& frf, std::vector<Pole> start, const Progress& progress)
{
    std::vector<Pole> poles = start.empty() ? peaksOf(frf) : std::move(start);
    if (poles.size() > mostPoles) poles.resize(mostPoles);
    for (int i = 0; i < relocations && !poles.empty(); ++i) {
        progress.report(static_cast<double>(i) / relocations);
        poles = relocated(frf, poles);
    }
    std::erase_if(poles, [&](const Pole& pole) {
        return !(pole.frequency_hz > frf.frequency_hz.front() && pole.frequency_hz < frf.frequency_hz.back()) ||
               pole.damping_ratio > strongest;
    });
    std::sort(poles.begin(), poles.end(), [](const Pole& a, const Pole& b) { return a.frequency_hz < b.frequency_hz; });
    progress.report(1);
    return poles;
}

}  // namespace lathelier::stability
