#include "engine/receptance/modal/modal_order.h"

#include <algorithm>
#include <cmath>

#include "engine/receptance/modal/modal_fit.h"
#include "engine/receptance/modal/modal_start.h"

namespace lathelier::receptance {
namespace {

constexpr double largestResidueError = 0.3, largestDampingError = 0.5;  ///< largest relative uncertainties of a
                                                                        ///< determined term
constexpr double largestDamping = 0.45;  ///< damping ratio above which a term is not a resonance
constexpr double leastShare = 0.03;      ///< least contribution relative to |G| at its own frequency
constexpr double cancelling = 25;   ///< contribution relative to |G| at its own frequency that indicates cancelling
                                    ///< terms
constexpr double modesApart = 2;    ///< least distance of two modes, in half-power half-widths ζ f_n of the wider one
constexpr double leastLines = 0.7;  ///< least number of lines in the half-power band
constexpr double roundingShare = 1e-9;  ///< share of |G| below which errors are rounding
constexpr double edge = 1.25;           ///< start frequency of a term beyond the range, as factor of the range's end
constexpr double nearEnd = 1e-3;        ///< relative distance from the bound of a frequency
constexpr int withoutGain = 2;          ///< number of further terms without gain that ends the search

bool isInside(const PoleTerm& term, const Interval& range)
{
    return term.frequency_hz >= range.from && term.frequency_hz <= range.to;
}

int modesInside(const Refined& fit, const Interval& range)
{
    return static_cast<int>(
        std::count_if(fit.terms.begin(), fit.terms.end(), [&](const PoleTerm& t) { return isInside(t, range); }));
}

/// At most one term below and one above the range.
bool hasFewBeyond(const Refined& fit, const Interval& range)
{
    const auto below = std::count_if(fit.terms.begin(), fit.terms.end(),
                                     [&](const PoleTerm& t) { return t.frequency_hz < range.from; });
    const auto above =
        std::count_if(fit.terms.begin(), fit.terms.end(), [&](const PoleTerm& t) { return t.frequency_hz > range.to; });
    return below <= 1 && above <= 1;
}

bool isWithinReach(const Refined& fit, const FitLines& lines)
{
    return std::none_of(fit.terms.begin(), fit.terms.end(),
                        [&](const PoleTerm& term) { return isAtEndOfReach(term, lines); });
}

bool isSoundFit(const Refined& fit, const FitLines& lines, const OrderRequest& request)
{
    for (std::size_t k = 0; k < fit.terms.size(); ++k)
        if (isInside(fit.terms[k], request.range_hz) && !isSound(fit, lines, k, request.complex_residues)) return false;
    return hasFewBeyond(fit, request.range_hz) && isWithinReach(fit, lines) &&
           modesInside(fit, request.range_hz) <= mostModes;
}

double criterion(const Refined& fit, const FitLines& lines, bool complex_residues)
{
    double rounding = 0;
    for (std::size_t i = 0; i < lines.value.size(); ++i)
        rounding += std::norm(roundingShare * lines.weight[i] * lines.value[i]);
    const double rows = 2 * static_cast<double>(lines.value.size());
    const double parameters = perTerm(complex_residues) * static_cast<double>(fit.terms.size()) + 2;
    return rows * std::log(fit.chi2 + rounding) + parameters * std::log(rows);
}

/// Fits with `count` terms from several starts.
std::vector<Refined> fitsWith(const FitLines& lines, int count, const std::vector<Refined>& fewer,
                              const Interval& range, bool complex_residues, const Progress& progress)
{
    std::vector<std::vector<PoleTerm>> starts;
    if (count > 0) starts.push_back(rationalStart(lines, count, progress));
    if (fewer.empty() && count == 0) starts.emplace_back();
    for (const Refined& fit : fewer) {
        starts.push_back(withWorstPeak(lines, fit));
        for (const double f : {range.from / edge, range.to * edge}) {
            starts.push_back(fit.terms);
            starts.back().push_back({f, 0.05, 0, 0});
        }
    }
    std::vector<Refined> fits;
    fits.reserve(starts.size());
    for (auto& start : starts)
        fits.push_back(refineModes(lines, std::move(start), complex_residues, Refinement::Rough, progress));
    std::stable_sort(fits.begin(), fits.end(), [](const Refined& a, const Refined& b) { return a.chi2 < b.chi2; });
    return fits;
}

}  // namespace

double uncertaintyOf(const Refined& fit, const FitLines& lines, std::size_t k, int j, bool complex_residues)
{
    const double rows = 2 * static_cast<double>(lines.value.size());
    const double freedom = std::max(1.0, rows - static_cast<double>(fit.covariance.rows()));
    const auto at = static_cast<Eigen::Index>(k) * perTerm(complex_residues) + j;
    return std::sqrt(std::max(0.0, fit.covariance(at, at)) * fit.chi2 / freedom);
}

bool isAtEndOfReach(const PoleTerm& term, const FitLines& lines)
{
    const Interval reach = reachOf(lines);
    return term.frequency_hz < (1 + nearEnd) * reach.from || term.frequency_hz > (1 - nearEnd) * reach.to;
}

bool isSound(const Refined& fit, const FitLines& lines, std::size_t k, bool complex_residues)
{
    const PoleTerm& term = fit.terms[k];
    const double residue = std::hypot(term.a_mm_N, term.b_mm_N);
    double error = uncertaintyOf(fit, lines, k, 2, complex_residues);
    if (complex_residues) error = std::hypot(error, uncertaintyOf(fit, lines, k, 3, true));
    if (!(error <= largestResidueError * residue) || term.damping > largestDamping ||
        !(uncertaintyOf(fit, lines, k, 1, complex_residues) <= largestDampingError))
        return false;
    const double here = std::abs(valueOf(fit, term.frequency_hz)), alone = residue / (2 * term.damping);
    if (alone < leastShare * here || alone > cancelling * here) return false;
    const double step =
        (lines.frequency_hz.back() - lines.frequency_hz.front()) / static_cast<double>(lines.frequency_hz.size());
    if (2 * term.damping * term.frequency_hz < leastLines * step) return false;
    for (std::size_t other = 0; other < fit.terms.size(); ++other) {
        const PoleTerm& t = fit.terms[other];
        if (other != k && std::abs(t.frequency_hz - term.frequency_hz) <
                              modesApart * std::max(t.damping * t.frequency_hz, term.damping * term.frequency_hz))
            return false;
    }
    return true;
}

Refined fitByOrder(const FitLines& lines, const OrderRequest& request, const Progress& progress)
{
    const bool complex_residues = request.complex_residues;
    const int most = request.modes > 0 ? request.modes + 2 : mostModes + 2;
    std::optional<Refined> best;
    double least = HUGE_VAL;
    int best_modes = -1;
    std::vector<Refined> fewer;
    int idle = 0;
    for (int count = 0; count <= most; ++count) {
        const Progress part = progress.part(static_cast<double>(count) / (most + 1), (count + 1.0) / (most + 1));
        part.report(0);
        std::vector<Refined> fits = fitsWith(lines, count, fewer, request.range_hz, complex_residues, part);
        bool gained = false;
        for (const Refined& fit : fits) {
            const int modes = modesInside(fit, request.range_hz);
            if (!isSoundFit(fit, lines, request) || (request.modes > 0 && modes > request.modes)) continue;
            const double value = criterion(fit, lines, complex_residues);
            const bool better = request.modes > 0 && modes != best_modes ? modes > best_modes : value < least;
            if (!better) continue;
            best = fit;
            least = value;
            best_modes = modes;
            gained = true;
        }
        idle = gained ? 0 : idle + 1;
        if (request.modes == 0 && idle > withoutGain) break;
        fewer.assign(fits.begin(), fits.begin() + 1);
    }
    return *best;
}

}  // namespace lathelier::receptance
