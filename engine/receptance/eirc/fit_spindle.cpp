#include "engine/receptance/eirc/fit_spindle.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/core/parallel.h"

namespace lathelier::receptance {
namespace {

constexpr std::size_t linesPerFitTask = 16;
constexpr int stepsApart = 8;
constexpr double unknownsOfLine = 3;
constexpr double betterCost = 0.99;          // a start from a neighbour is accepted if it lowers the cost to this share
constexpr double chanceOfTwoSigma = 0.0228;  // one-sided

LineFit startedFit(const SpindleLines& lines, std::size_t line, const ScaledSpindle& other, int most_steps = mostSteps)
{
    const SpindleLine& bare = lines.bare.empty() ? lines.lines[line] : lines.bare[line];
    return refine(lines.lines[line], linearStart(bare).value_or(other), most_steps);
}

double freedomOfLine(const LineFit& fit)
{
    return std::max(0.0, static_cast<double>(fit.responses) - unknownsOfLine);
}

/// Greatest root of the symmetric 2×2 matrix (a, b; b, c), and its unit vector.
struct GreatestAxis {
    double value;
    Eigen::Vector2d axis;
};

GreatestAxis greatestAxis(double a, double b, double c)
{
    const double turn = std::atan2(2 * b, a - c) / 2;
    return {(a + c) / 2 + std::hypot((a - c) / 2, b), {std::cos(turn), std::sin(turn)}};
}

/// The k that a normal deviate exceeds with this chance.
double deviateBeyond(double chance)
{
    double low = 0, high = 40;
    for (int i = 0; i < 60; ++i) {
        const double middle = (low + high) / 2;
        (std::erfc(middle / std::numbers::sqrt2) / 2 > chance ? low : high) = middle;
    }
    return high;
}

}  // namespace

std::vector<LineFit> fitSpindle(const SpindleLines& lines, const Progress& progress)
{
    std::vector<LineFit> fits(lines.lines.size());
    parallelFor(fits.size(), linesPerFitTask, progress, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) fits[i] = startedFit(lines, i, ScaledSpindle::Zero());
    });
    progress.report(0.5);
    const auto improve = [&](std::size_t line, std::size_t neighbour) {
        progress.check();
        LineFit other = refine(lines.lines[line], fits[neighbour].spindle);
        if (other.cost < betterCost * fits[line].cost) fits[line] = other;
    };
    for (std::size_t i = 1; i < fits.size(); ++i) improve(i, i - 1);
    progress.report(0.75);
    for (std::size_t i = fits.size(); i-- > 1;) improve(i - 1, i);
    progress.report(1);
    return fits;
}

std::vector<LineFit> fitApart(const SpindleLines& lines, const std::vector<LineFit>& hints)
{
    std::vector<LineFit> fits;
    for (std::size_t i = 0; i < lines.lines.size(); ++i) {
        const ScaledSpindle hint = hints.empty() ? ScaledSpindle::Zero() : hints[i].spindle;
        fits.push_back(startedFit(lines, i, hint, stepsApart));
    }
    return fits;
}

double freedomOf(const SpindleLine& line, const LineResponse& response, const LineFit& fit)
{
    const Eigen::RowVector3cd row = response.weight * gradientOn(line, response, fit.spindle);
    const Eigen::Vector3cd part = fit.information.inverse() * row.adjoint();
    const double used = std::abs((row * part).value());
    return std::isfinite(used) ? std::clamp(1 - used, 0.0, 1.0) : 0;
}

FitQuality qualityOf(const std::vector<SpindleLine>& lines, const std::vector<LineFit>& fits)
{
    const std::size_t responses = lines.empty() ? 0 : lines.front().responses.size();
    std::vector<double> squares(responses), freedoms(responses);
    double expected = 0, count = 0;
    for (std::size_t i = 0; i < lines.size(); ++i)
        for (std::size_t k = 0; k < responses; ++k) {
            const LineResponse& one = lines[i].responses[k];
            if (!(one.weight > 0)) continue;
            const double free = freedomOf(lines[i], one, fits[i]);
            squares[k] += std::norm(one.weight * (responseOn(lines[i], one, fits[i].spindle) - one.measured));
            freedoms[k] += free;
            expected += free / std::norm(one.weight * one.measured);
            ++count;
        }
    FitQuality quality;
    for (std::size_t k = 0; k < responses; ++k)
        quality.chi2_per_dof_of_responses.push_back(freedoms[k] > 0 ? std::optional(squares[k] / freedoms[k])
                                                                    : std::nullopt);
    const double all = chi2PerDof(fits);
    if (std::isfinite(all)) quality.chi2_per_dof = all;
    quality.expected_rms_percent = count > 0 ? 100 * std::sqrt(expected / count) : 0;
    return quality;
}

double chi2PerDof(const std::vector<LineFit>& fits)
{
    double cost = 0, dof = 0;
    for (const LineFit& fit : fits)
        if (freedomOfLine(fit) > 0) {
            cost += fit.cost;
            dof += freedomOfLine(fit);
        }
    return dof > 0 ? cost / dof : HUGE_VAL;
}

std::int64_t activeLines(const std::vector<LineFit>& fits, const std::vector<ScaledSpindle>& spindle,
                         bool is_noise_known)
{
    if (fits.empty()) return 0;
    const double k = deviateBeyond(chanceOfTwoSigma / static_cast<double>(fits.size()));
    std::int64_t active = 0;
    for (std::size_t i = 0; i < fits.size(); ++i) {
        const Eigen::Vector3d gain = spindle[i].imag();
        const auto [value, axis] = greatestAxis(gain[0], gain[1], gain[2]);
        if (!(value > 0)) continue;
        const Eigen::Vector3cd parts =
            Eigen::Vector3d(axis[0] * axis[0], 2 * axis[0] * axis[1], axis[1] * axis[1]).cast<Complex>();
        const double left = freedomOfLine(fits[i]) > 0 ? fits[i].cost / freedomOfLine(fits[i]) : 1;
        const double unit = is_noise_known ? std::max(1.0, left) : left;
        // The variance of the imaginary part is half of the complex one.
        const double variance = unit / 2 * std::abs(parts.dot(fits[i].information.inverse() * parts));
        if (value > k * std::sqrt(variance)) ++active;
    }
    return active;
}

}  // namespace lathelier::receptance
