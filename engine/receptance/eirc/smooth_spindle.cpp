#include "engine/receptance/eirc/smooth_spindle.h"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "engine/core/parallel.h"

namespace lathelier::receptance {
namespace {

using NormalMatrix = Eigen::Matrix<Complex, 9, 9>;
using RightSide = Eigen::Matrix<Complex, 9, 1>;

constexpr std::array<std::size_t, 6> halfWidths{2, 3, 5, 8, 12, 16};
constexpr std::size_t hereabouts = 6;  // lines on either side whose prediction errors select the width
constexpr std::size_t linesPerSmoothingTask = 16;
constexpr double unknowns = 3;

double tricube(double u)
{
    const double rest = 1 - std::abs(u * u * u);
    return rest > 0 ? rest * rest * rest : 0;
}

class LocalFit {
public:
    LocalFit(std::span<const double> frequency_hz, std::span<const LineFit> fits)
        : frequency_hz_(frequency_hz), fits_(fits)
    {
    }

    /// Local quadratic at a line from `half_width` lines on either side, with or without the line itself.
    std::optional<ScaledSpindle> at(std::size_t line, std::size_t half_width, bool with_itself) const
    {
        const std::size_t first = line > half_width ? line - half_width : 0;
        const std::size_t last = std::min(fits_.size() - 1, line + half_width);
        const double reach_hz =
            (1 + 1 / static_cast<double>(half_width)) *
            std::max(frequency_hz_[last] - frequency_hz_[line], frequency_hz_[line] - frequency_hz_[first]);
        NormalMatrix normal = NormalMatrix::Zero();
        RightSide right = RightSide::Zero();
        std::size_t count = 0;
        for (std::size_t k = first; k <= last; ++k) {
            const LineFit& fit = fits_[k];
            if ((k == line && !with_itself) || !fit.information.allFinite() || !fit.spindle.allFinite()) continue;
            const double u = (frequency_hz_[k] - frequency_hz_[line]) / reach_hz;
            const Eigen::Vector3d powers(1, u, u * u);
            const Eigen::Matrix3cd information = tricube(u) * fit.information;
            const Eigen::Vector3cd known = information * fit.spindle;
            for (Eigen::Index r = 0; r < 3; ++r) {
                right.segment<3>(3 * r) += powers[r] * known;
                for (Eigen::Index c = 0; c < 3; ++c)
                    normal.block<3, 3>(3 * r, 3 * c) += powers[r] * powers[c] * information;
            }
            ++count;
        }
        if (count < 4) return std::nullopt;
        const RightSide solution = normal.ldlt().solve(right);
        return solution.allFinite() ? std::optional<ScaledSpindle>(solution.head<3>()) : std::nullopt;
    }

    /// Leave-one-out prediction error of a line, in its own weights.
    double miss(std::size_t line, std::size_t half_width) const
    {
        const auto predicted = at(line, half_width, false);
        if (!predicted) return HUGE_VAL;
        const ScaledSpindle apart = *predicted - fits_[line].spindle;
        return std::real(apart.dot(fits_[line].information * apart));
    }

private:
    std::span<const double> frequency_hz_;
    std::span<const LineFit> fits_;
};

double meanAround(const std::vector<double>& values, std::size_t line)
{
    const std::size_t first = line > hereabouts ? line - hereabouts : 0;
    const std::size_t last = std::min(values.size() - 1, line + hereabouts);
    double sum = 0;
    for (std::size_t k = first; k <= last; ++k) sum += values[k];
    return sum / static_cast<double>(last - first + 1);
}

}  // namespace

std::vector<ScaledSpindle> smoothed(std::span<const double> frequency_hz, std::span<const LineFit> fits,
                                    const Progress& progress)
{
    const LocalFit local(frequency_hz, fits);
    std::vector<std::vector<double>> misses(halfWidths.size(), std::vector<double>(fits.size()));
    std::vector<double> noise;  // by line: variance of unit weight
    for (const LineFit& fit : fits)
        noise.push_back(fit.cost / std::max(1.0, static_cast<double>(fit.responses) - unknowns));
    parallelFor(fits.size(), linesPerSmoothingTask, progress, [&](std::size_t begin, std::size_t end) {
        for (std::size_t line = begin; line < end; ++line)
            for (std::size_t w = 0; w < halfWidths.size(); ++w) misses[w][line] = local.miss(line, halfWidths[w]);
    });
    progress.report(0.8);
    std::vector<ScaledSpindle> result(fits.size());
    for (std::size_t line = 0; line < fits.size(); ++line) {
        progress.check();
        // The prediction error contains the noise of the line and the error of the prediction: smoothing is accepted
        // below twice the noise.
        double least = 2 * unknowns * meanAround(noise, line);
        std::size_t half_width = 0;
        for (std::size_t w = 0; w < halfWidths.size(); ++w) {
            const double miss = meanAround(misses[w], line);
            if (!(miss < least)) continue;
            least = miss;
            half_width = halfWidths[w];
        }
        result[line] = fits[line].spindle;
        if (half_width > 0) result[line] = local.at(line, half_width, true).value_or(fits[line].spindle);
    }
    progress.report(1);
    return result;
}

}  // namespace lathelier::receptance
