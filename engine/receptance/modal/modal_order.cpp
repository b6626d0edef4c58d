#include "engine/receptance/modal/modal_order.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "engine/receptance/modal/modal_fit.h"

namespace lathelier::receptance {
namespace {

constexpr double largestResidueError = 0.35, largestDampingError = 0.5;  ///< largest relative uncertainties of a
                                                                         ///< determined term
constexpr double largestDamping = 0.25;  ///< damping ratio above which a term is not a resonance
constexpr double leastShare = 0.03;      ///< least contribution relative to |G| at its own frequency
constexpr double leastWideShare = 0.5;   ///< likewise of a wide one, which errors of other modes' damping imitate
constexpr double cancelling = 60;   ///< contribution relative to |G| at its own frequency that indicates cancelling
                                    ///< terms
constexpr double modesApart = 0.5;  ///< least distance of two modes, in half-power half-widths ζ f_n of the wider one
constexpr double leastLines = 0.7;  ///< least number of lines in the half-power band
constexpr double roundingShare = 1e-9;  ///< share of |G| below which errors are rounding
constexpr double edge = 1.25;           ///< start frequency of a term beyond the range, as factor of the range's end
constexpr double nearEdge = 1.3;        ///< closeness to the range's end, as factor, of what may be a term beyond it
constexpr double wideDamping = 0.1;     ///< damping ratio above which it may be one as well
constexpr double nearEnd = 1e-3;        ///< relative distance from the bound of a frequency
constexpr int withoutGain = 2;          ///< number of further terms without gain that ends the search
constexpr double leastGain = 32;  ///< least increase of χ² by removing a mode, relative to the variance of the errors:
                                  ///< noise on 4000 lines gives 25 once in ten files
constexpr double tryingGain = 15;   ///< least gain of a matched filter, likewise, that is tried: its template is coarse
constexpr double negativeGain = 2;  ///< factor of it for a mode with a negative residue where the sign is not known

constexpr double strong = 4;  ///< a mode whose residue shows four times as much is not tried

using Lines = std::span<const FitLines>;

double rowsOf(Lines lines)
{
    double rows = 0;
    for (const FitLines& one : lines) rows += 2 * static_cast<double>(one.value.size());
    return rows;
}

double parametersOf(const Refined& fit, bool complex_residues)
{
    const auto poles = static_cast<double>(fit.poles.size()), responses = static_cast<double>(fit.responses.size());
    return 2 * poles + responses * (perResidue(complex_residues) * poles + 2);
}

bool isInside(const Pole& pole, const Interval& range)
{
    return pole.frequency_hz >= range.from && pole.frequency_hz <= range.to;
}

int modesInside(const Refined& fit, const Interval& range)
{
    return static_cast<int>(
        std::count_if(fit.poles.begin(), fit.poles.end(), [&](const Pole& p) { return isInside(p, range); }));
}

double sizeOf(const Residue& residue)
{
    return std::hypot(residue.a_mm_N, residue.b_mm_N);
}

/// At most one term below and one above the range.
bool hasFewBeyond(const Refined& fit, const Interval& range)
{
    const auto below =
        std::count_if(fit.poles.begin(), fit.poles.end(), [&](const Pole& p) { return p.frequency_hz < range.from; });
    const auto above =
        std::count_if(fit.poles.begin(), fit.poles.end(), [&](const Pole& p) { return p.frequency_hz > range.to; });
    return below <= 1 && above <= 1;
}

bool isApart(const Refined& fit, std::size_t k)
{
    const Pole& pole = fit.poles[k];
    for (std::size_t other = 0; other < fit.poles.size(); ++other) {
        const Pole& p = fit.poles[other];
        if (other != k && std::abs(p.frequency_hz - pole.frequency_hz) <
                              modesApart * std::max(p.damping * p.frequency_hz, pole.damping * pole.frequency_hz))
            return false;
    }
    return true;
}

/// Width of the lines around a frequency.
double stepNear(Lines lines, double frequency_hz)
{
    const auto& f = lines.front().frequency_hz;
    const auto above = std::lower_bound(f.begin(), f.end(), frequency_hz);
    const auto at = std::clamp<std::ptrdiff_t>(above - f.begin(), 1, static_cast<std::ptrdiff_t>(f.size()) - 1);
    return f[static_cast<std::size_t>(at)] - f[static_cast<std::size_t>(at - 1)];
}

/// Whether one response at least determines the term and shows it at its own frequency.
bool isSound(const Refined& fit, Lines lines, std::size_t k, const OrderRequest& request, double scale)
{
    const Pole& pole = fit.poles[k];
    if (pole.damping > largestDamping || !(poleUncertainty(fit, k, 1, scale) <= largestDampingError)) return false;
    if (2 * pole.damping * pole.frequency_hz < leastLines * stepNear(lines, pole.frequency_hz)) return false;
    bool is_seen = false;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const Residue& residue = fit.responses[i].residues[k];
        const double error = residueUncertainty(fit, i, k, request.complex_residues, scale);
        if (!(error <= largestResidueError * sizeOf(residue))) continue;
        if (request.signs[i] == ResidueSign::Positive && residue.a_mm_N < 0) return false;
        const double here = std::abs(valueOf(fit.poles, fit.responses[i], pole.frequency_hz)),
                     alone = sizeOf(residue) / (2 * pole.damping);
        const double least = pole.damping > wideDamping ? leastWideShare : leastShare;
        is_seen |= alone >= least * here && alone <= cancelling * here;
    }
    return is_seen && isApart(fit, k);
}

bool isSoundFit(const Refined& fit, Lines lines, const OrderRequest& request)
{
    const double scale = scaleOf(fit, lines, request.complex_residues);
    for (std::size_t k = 0; k < fit.poles.size(); ++k)
        if (isAtEndOfReach(fit.poles[k], lines) ||
            (isInside(fit.poles[k], request.range_hz) && !isSound(fit, lines, k, request, scale)))
            return false;
    return hasFewBeyond(fit, request.range_hz) && modesInside(fit, request.range_hz) <= mostModes;
}

double roundingOf(Lines lines)
{
    double rounding = 0;
    for (const FitLines& one : lines)
        for (std::size_t i = 0; i < one.value.size(); ++i)
            rounding += std::norm(roundingShare * one.weight[i] * one.value[i]);
    return rounding;
}

double criterion(const Refined& fit, Lines lines, bool complex_residues)
{
    const double rows = rowsOf(lines);
    return rows * std::log(fit.chi2 + roundingOf(lines)) + parametersOf(fit, complex_residues) * std::log(rows);
}

/// Variance of the errors around a frequency that no smooth curve explains, relative to σ²: mean of the responses.
double varianceNear(const std::vector<std::vector<double>>& scatter, Lines lines, double frequency_hz)
{
    double all = 0;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const auto& f = lines[i].frequency_hz;
        const auto above = std::lower_bound(f.begin(), f.end(), frequency_hz);
        const auto at = std::min<std::ptrdiff_t>(above - f.begin(), static_cast<std::ptrdiff_t>(f.size()) - 1);
        all += scatter[i][static_cast<std::size_t>(at)];
    }
    return all / static_cast<double>(lines.size());
}

std::vector<Pole> without(const std::vector<Pole>& poles, std::size_t k)
{
    std::vector<Pole> fewer = poles;
    fewer.erase(fewer.begin() + static_cast<std::ptrdiff_t>(k));
    return fewer;
}

bool isNegative(const Refined& fit, std::size_t k)
{
    double sum = 0;
    for (const LinearTerms& one : fit.responses) sum += one.residues[k].a_mm_N < 0 ? -1 : 1;
    return sum < 0;
}

/// Least increase of χ² that shows mode `k`.
double gainToShow(const Refined& fit, Lines lines, const OrderRequest& request, std::size_t k)
{
    std::vector<std::vector<double>> scatter;
    for (std::size_t i = 0; i < lines.size(); ++i) scatter.push_back(scatterOf(lines[i], fit, i));
    const double variance = std::max(scaleOf(fit, lines, request.complex_residues),
                                     varianceNear(scatter, lines, fit.poles[k].frequency_hz));
    return leastGain * variance * (isNegative(fit, k) ? negativeGain : 1) + roundingOf(lines);
}

/// Increase of χ² by removing mode `k` as its residues and their uncertainties predict.
double wald(const Refined& fit, std::size_t k, const OrderRequest& request, double scale)
{
    double shown = 0;
    for (std::size_t i = 0; i < fit.responses.size(); ++i) {
        const double error = residueUncertainty(fit, i, k, request.complex_residues, scale);
        const double ratio = sizeOf(fit.responses[i].residues[k]) / std::max(error, 1e-300);
        shown += ratio * ratio;
    }
    return shown * scale;
}

/// The fit without the modes that noise may have made.
Refined withoutNoise(Refined fit, Lines lines, const OrderRequest& request, const Progress& progress)
{
    for (bool found = true; found;) {
        found = false;
        const double scale = scaleOf(fit, lines, request.complex_residues);
        for (std::size_t k = 0; k < fit.poles.size() && !found; ++k) {
            if (!isInside(fit.poles[k], request.range_hz)) continue;
            const double needed = gainToShow(fit, lines, request, k);
            if (wald(fit, k, request, scale) > strong * needed) continue;
            Refined reduced =
                refineModes(lines, without(fit.poles, k), request.complex_residues, Refinement::Rough, progress);
            if (reduced.chi2 - fit.chi2 >= needed || !isSoundFit(reduced, lines, request)) continue;
            fit = std::move(reduced);
            found = true;
        }
    }
    return fit;
}

/// Whether the errors of a fit have a course that noise has not: sums over stretches of lines, squared and relative to
/// their variance.
bool hasCourse(const FitLines& lines, const Refined& fit, std::size_t response, const std::vector<double>& scatter)
{
    constexpr std::size_t stretches = 16;
    constexpr double mostOfNoise = 2.0 * stretches + 4 * 8;  // mean and four standard deviations of χ² with 32 degrees
    const auto errors = weightedErrors(lines, fit, response);
    double sum = 0;
    for (std::size_t k = 0; k < stretches; ++k) {
        const std::size_t from = k * errors.size() / stretches, to = (k + 1) * errors.size() / stretches;
        std::complex<double> course;
        double variance = 1e-300;
        for (std::size_t i = from; i < to; ++i) {
            course += errors[i];
            variance += scatter[i];
        }
        sum += std::norm(course) / variance;
    }
    return sum > mostOfNoise;
}

/// The poles with the nearest one to `missing` split in two, where they overlap: one term fitted to two equal modes a
/// half-power band apart is 1.5 times as wide as each. Empty where none is near.
std::vector<Pole> splitNear(const std::vector<Pole>& poles, const Pole& missing)
{
    constexpr double near = 4, share = 2.0 / 3;  // in half-widths, of ζ
    const auto away = [&missing](const Pole& p) { return std::abs(p.frequency_hz - missing.frequency_hz); };
    const auto nearest =
        std::min_element(poles.begin(), poles.end(), [&](const Pole& a, const Pole& b) { return away(a) < away(b); });
    if (nearest == poles.end() || away(*nearest) > near * nearest->damping * nearest->frequency_hz) return {};
    std::vector<Pole> split = poles;
    Pole& first = split[static_cast<std::size_t>(nearest - poles.begin())];
    const double shift = share * first.damping;
    first.damping *= share;
    split.push_back({first.frequency_hz * (1 + shift), first.damping});
    split[static_cast<std::size_t>(nearest - poles.begin())].frequency_hz *= 1 - shift;
    return split;
}

/// Starts with `count` terms; none where the fit with fewer leaves noise alone.
std::vector<std::vector<Pole>> startsWith(std::size_t count, const std::optional<Refined>& fewer, Lines lines,
                                          const OrderRequest& request, const Progress& progress)
{
    if (!fewer) return {{}};
    std::vector<std::vector<double>> scatter;
    bool has_course = false;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        progress.check();
        scatter.push_back(scatterOf(lines[i], *fewer, i));
        has_course |= hasCourse(lines[i], *fewer, i, scatter[i]);
    }
    const Candidate missing = strongestMissing(lines, *fewer, request.signs, progress);
    const double variance = varianceNear(scatter, lines, missing.pole.frequency_hz);
    const bool is_missing = missing.gain > tryingGain * variance + roundingOf(lines);
    std::vector<std::vector<Pole>> starts;
    const auto with = [&](const Pole& pole) {
        starts.push_back(fewer->poles);
        starts.back().push_back(pole);
    };
    if (is_missing) {
        with(missing.pole);
        if (auto split = splitNear(fewer->poles, missing.pole); !split.empty()) starts.push_back(std::move(split));
    }
    if ((is_missing || has_course) && request.stable.size() >= count)
        starts.emplace_back(request.stable.begin(), request.stable.begin() + static_cast<std::ptrdiff_t>(count));
    const Interval& range = request.range_hz;
    const auto& poles = fewer->poles;
    if (!has_course) return starts;
    const bool is_wide = !is_missing || missing.pole.damping > wideDamping;
    if ((is_wide || missing.pole.frequency_hz < nearEdge * range.from) &&
        std::none_of(poles.begin(), poles.end(), [&](const Pole& p) { return p.frequency_hz < range.from; }))
        with({range.from / edge, 0.05});
    if ((is_wide || missing.pole.frequency_hz > range.to / nearEdge) &&
        std::none_of(poles.begin(), poles.end(), [&](const Pole& p) { return p.frequency_hz > range.to; }))
        with({range.to * edge, 0.05});
    return starts;
}

}  // namespace

double scaleOf(const Refined& fit, std::span<const FitLines> lines, bool complex_residues)
{
    return fit.chi2 / std::max(1.0, rowsOf(lines) - parametersOf(fit, complex_residues));
}

double poleUncertainty(const Refined& fit, std::size_t k, int which, double scale)
{
    const auto at = 2 * static_cast<Eigen::Index>(k) + which;
    return std::sqrt(std::max(0.0, fit.covariance.front()(at, at)) * scale);
}

double residueUncertainty(const Refined& fit, std::size_t response, std::size_t k, bool complex_residues, double scale)
{
    const Eigen::MatrixXd& covariance = fit.covariance[response];
    const auto at =
        2 * static_cast<Eigen::Index>(fit.poles.size()) + perResidue(complex_residues) * static_cast<Eigen::Index>(k);
    if (!complex_residues) return std::sqrt(std::max(0.0, covariance(at, at)) * scale);
    const Residue& residue = fit.responses[response].residues[k];
    const double size = std::max(sizeOf(residue), 1e-300), a = residue.a_mm_N / size, b = residue.b_mm_N / size;
    const double variance =
        a * a * covariance(at, at) + 2 * a * b * covariance(at, at + 1) + b * b * covariance(at + 1, at + 1);
    return std::sqrt(std::max(0.0, variance) * scale);
}

bool isAtEndOfReach(const Pole& pole, std::span<const FitLines> lines)
{
    const Interval reach = reachOf(lines);
    return pole.frequency_hz < (1 + nearEnd) * reach.from || pole.frequency_hz > (1 - nearEnd) * reach.to;
}

Refined fitByOrder(std::span<const FitLines> lines, const OrderRequest& request, const Progress& progress)
{
    const bool complex_residues = request.complex_residues;
    const int most = request.modes > 0 ? request.modes + 2 : mostModes + 2;
    std::optional<Refined> best, fewer;
    double least = HUGE_VAL;
    int best_modes = -1;
    int idle = 0;
    for (int count = 0; count <= most; ++count) {
        const Progress part = progress.part(static_cast<double>(count) / (most + 1), (count + 1.0) / (most + 1));
        part.report(0);
        bool gained = false;
        std::optional<Refined> closest;
        auto starts = startsWith(static_cast<std::size_t>(count), fewer, lines, request, part);
        if (starts.empty()) break;
        for (auto& start : starts) {
            Refined fit = refineModes(lines, std::move(start), complex_residues, Refinement::Rough, part);
            const int modes = modesInside(fit, request.range_hz);
            if (isSoundFit(fit, lines, request) && (request.modes == 0 || modes <= request.modes)) {
                const double value = criterion(fit, lines, complex_residues);
                if (request.modes > 0 && modes != best_modes ? modes > best_modes : value < least) {
                    best = fit;
                    least = value;
                    best_modes = modes;
                    gained = true;
                }
            }
            if (!closest || fit.chi2 < closest->chi2) closest = std::move(fit);
        }
        idle = gained ? 0 : idle + 1;
        if (request.modes == 0 && idle > withoutGain) break;
        fewer = std::move(closest);
    }
    return request.modes > 0 ? *best : withoutNoise(std::move(*best), lines, request, progress);
}

}  // namespace lathelier::receptance
