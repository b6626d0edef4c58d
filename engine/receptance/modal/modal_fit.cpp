#include "engine/receptance/modal/modal_fit.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/core/core_codes.h"
#include "engine/core/units.h"
#include "engine/receptance/modal/modal_codes.h"
#include "engine/receptance/modal/modal_order.h"
#include "engine/receptance/modal/modal_weights.h"

namespace lathelier::receptance {
namespace {

constexpr std::size_t fewestFitLines = 12;
constexpr std::size_t linesToCompare = 700;  ///< lines used when fits with different numbers of modes are compared
constexpr double resolvedLines = 4;          ///< least number of lines in a half-power band of a resolved mode
constexpr double uncertain = 0.3;            ///< relative standard uncertainty of a stiffness reported as large
constexpr int reweighings = 2;

Interval rangeOf(const Frf& frf, const ModalParameters& parameters)
{
    if (parameters.range_hz.size() > 1)
        throw Error(
            errors::valueNotUnderstood,
            {{"parameter", "range_hz"}, {"found", parameters.range_hz}, {"expected", LT_TEXT("Engine", "one range")}});
    if (!parameters.range_hz.empty()) return parameters.range_hz.front();
    double low = 0, high = 0;
    for (const double f : frf.frequency_hz) {
        if (!(f > 0)) continue;
        if (low == 0) low = f;
        high = f;
    }
    return {low, high};
}

ModalMode modeOf(const PoleTerm& term)
{
    if (term.b_mm_N == 0) return {term.frequency_hz, term.damping, 1 / term.a_mm_N, 0};
    const double sign = term.a_mm_N < 0 ? -1 : 1;
    return {term.frequency_hz, term.damping, sign / std::hypot(term.a_mm_N, term.b_mm_N),
            std::atan2(sign * term.b_mm_N, sign * term.a_mm_N) * 180 / std::numbers::pi};
}

/// Standard uncertainty of |a + ib|, from the covariance of a and b.
double residueUncertainty(const Refined& fit, const FitLines& lines, std::size_t k, bool complex_residues)
{
    const double u = uncertaintyOf(fit, lines, k, 2, complex_residues);
    const PoleTerm& term = fit.terms[k];
    if (!complex_residues) return u;
    const auto at = static_cast<Eigen::Index>(k) * perTerm(true) + 2;
    const double size = std::hypot(term.a_mm_N, term.b_mm_N), a = term.a_mm_N / size, b = term.b_mm_N / size;
    const double variance = a * a * fit.covariance(at, at) + 2 * a * b * fit.covariance(at, at + 1) +
                            b * b * fit.covariance(at + 1, at + 1);
    const double all = fit.covariance(at, at);
    return all > 0 ? u * std::sqrt(std::max(0.0, variance / all)) : u;
}

/// Lines within f_n (1 ± ζ), from the local line spacing.
double halfPowerLines(const FitLines& lines, const ModalMode& mode)
{
    const auto& f = lines.frequency_hz;
    const auto above = std::lower_bound(f.begin(), f.end(), mode.frequency_hz);
    const auto at = std::clamp<std::ptrdiff_t>(above - f.begin(), 1, static_cast<std::ptrdiff_t>(f.size()) - 1);
    const double step = f[static_cast<std::size_t>(at)] - f[static_cast<std::size_t>(at - 1)];
    return 2 * mode.damping_ratio * mode.frequency_hz / step;
}

/// Refinement on all lines, without terms that have left the range.
Refined refinedFully(const FitLines& lines, const Refined& start, bool complex_residues, const Progress& progress)
{
    Refined found = refineModes(lines, start.terms, complex_residues, Refinement::Full, progress);
    const auto left = std::erase_if(found.terms, [&](const PoleTerm& term) { return isAtEndOfReach(term, lines); });
    return left > 0 ? refineModes(lines, found.terms, complex_residues, Refinement::Full, progress) : found;
}

void addNotes(ModalFit& fit, bool converged)
{
    Notes& notes = fit.notes;
    const auto count = static_cast<int>(fit.modes.size());
    if (fit.parameters.modes > count && count > 0)
        notes.push_back({notes::fewerModes,
                         {{"asked", std::int64_t{fit.parameters.modes}},
                          {"found", std::int64_t{count}},
                          {"from_hz", fit.range_hz.from},
                          {"to_hz", fit.range_hz.to}}});
    if (count == 0) notes.push_back({notes::noModes, {{"from_hz", fit.range_hz.from}, {"to_hz", fit.range_hz.to}}});
    const auto rounded = [](double value) { return std::round(100 * value) / 100; };
    for (const FittedMode& found : fit.modes) {
        const double f = rounded(found.mode.frequency_hz);
        if (found.half_power_lines < resolvedLines)
            notes.push_back({notes::modeNotResolved,
                             {{"frequency_hz", f},
                              {"lines", rounded(found.half_power_lines)},
                              {"minimum", static_cast<std::int64_t>(resolvedLines)}}});
        if (found.mode.stiffness_N_mm < 0) notes.push_back({notes::modeOutOfPhase, {{"frequency_hz", f}}});
        const double share = found.stiffness_uncertainty_N_mm / std::abs(found.mode.stiffness_N_mm);
        if (share > uncertain)
            notes.push_back({notes::modeUncertain, {{"frequency_hz", f}, {"percent", std::round(100 * share)}}});
    }
    for (const ModalMode& mode : fit.model.beyond)
        notes.push_back({notes::modesBeyond, {{"frequency_hz", rounded(mode.frequency_hz)}}});
    if (!converged) notes.push_back({notes::fitNotConverged, {}});
}

void describe(ModalFit& fit, const Refined& found, const FitLines& lines, bool complex_residues)
{
    for (std::size_t k = 0; k < found.terms.size(); ++k) {
        const ModalMode mode = modeOf(found.terms[k]);
        if (mode.frequency_hz < fit.range_hz.from || mode.frequency_hz > fit.range_hz.to) {
            fit.model.beyond.push_back(mode);
            continue;
        }
        const auto uncertainty = [&](int j) { return uncertaintyOf(found, lines, k, j, complex_residues); };
        fit.model.modes.push_back(mode);
        fit.modes.push_back(
            {mode, mode.frequency_hz * uncertainty(0), mode.damping_ratio * uncertainty(1),
             mode.stiffness_N_mm * mode.stiffness_N_mm * residueUncertainty(found, lines, k, complex_residues),
             halfPowerLines(lines, mode), flexibilityOf(mode)});
    }
    fit.model.residuals = {found.lower_mm_Ns2, found.upper_mm_N};
    fit.lower_uncertainty_mm_Ns2 = uncertaintyOf(found, lines, found.terms.size(), 0, complex_residues);
    fit.upper_uncertainty_mm_N = uncertaintyOf(found, lines, found.terms.size(), 1, complex_residues);
}

void compare(ModalFit& fit, const FitLines& lines)
{
    fit.lines = lines.value.size();
    fit.synthesised = synthesised(fit.model, lines.frequency_hz);
    fit.error_percent.reserve(fit.lines);
    double error = 0, size = 0;
    for (std::size_t i = 0; i < fit.lines; ++i) {
        const double away = std::abs(fit.synthesised.value[i] - lines.value[i]), here = std::abs(lines.value[i]);
        fit.error_percent.push_back(here > 0 ? 100 * away / here : 0);
        error += away * away;
        size += here * here;
    }
    fit.error_rms_percent = size > 0 ? 100 * std::sqrt(error / size) : 0;
}

}  // namespace

const std::vector<Field<ModalParameters>>& fieldsOf(const ModalParameters*)
{
    static const std::vector<Field<ModalParameters>> all{
        field("number_of_modes", &ModalParameters::modes, {0, mostModes},
              Label{LT_TEXT("Engine", "Number of modes"), LT_TEXT("Engine", "1 to 6; 0: as many as the data tell.")}),
        field("range_hz", &ModalParameters::range_hz, {0, 1e6},
              Label{LT_TEXT("Engine", "Range of frequencies"),
                    LT_TEXT("Engine", "Whose lines are fitted, as 100:800; empty: all."), unit::hz}),
        field("complex_residues", &ModalParameters::complex_residues,
              Label{LT_TEXT("Engine", "Complex residues"),
                    LT_TEXT("Engine", "For modes whose places do not move in phase or against each other."),
                    {},
                    true})};
    return all;
}

double flexibilityOf(const ModalMode& mode)
{
    // Re of 1/(k (1 - r² + 2iζr)) is least at r² = 1 + 2ζ; for a negative k: r² = 1 - 2ζ.
    double least = 0;
    for (const double r2 : {1 + 2 * mode.damping_ratio, std::max(0.0, 1 - 2 * mode.damping_ratio), 1.0})
        least = std::min(least, receptanceOf(mode, mode.frequency_hz * std::sqrt(r2)).real());
    return -least;
}

ModalFit fitModes(const Frf& frf, const ModalParameters& parameters, const Progress& progress)
{
    if (frf.quantity != FrfQuantity::Receptance) throw Error(errors::fitNeedsReceptance, {});
    ModalFit fit;
    fit.parameters = parameters;
    const Interval asked = rangeOf(frf, parameters);
    FitLines lines = linesToFit(frf, asked);
    if (lines.value.size() < fewestFitLines)
        throw Error(errors::tooFewLinesToFit, {{"found", static_cast<std::int64_t>(lines.value.size())},
                                               {"from_hz", asked.from},
                                               {"to_hz", asked.to},
                                               {"minimum", static_cast<std::int64_t>(fewestFitLines)}});
    fit.range_hz = {lines.frequency_hz.front(), lines.frequency_hz.back()};
    const bool complex_residues = parameters.complex_residues, by_errors = frf.coherence.empty();
    const OrderRequest request{fit.range_hz, parameters.modes, complex_residues};

    Refined found = fitByOrder(thinned(lines, linesToCompare), request, progress.part(0, by_errors ? 0.45 : 0.9));
    if (by_errors) {
        reweigh(lines, found);
        found = fitByOrder(thinned(lines, linesToCompare), request, progress.part(0.45, 0.9));
    }
    const Progress last = progress.part(0.9, 1);
    found = refinedFully(lines, found, complex_residues, last);
    for (int pass = 0; by_errors && pass < reweighings; ++pass) {
        reweigh(lines, found);
        found = refinedFully(lines, found, complex_residues, last);
    }
    describe(fit, found, lines, complex_residues);
    compare(fit, lines);
    addNotes(fit, found.converged);
    progress.report(1);
    return fit;
}

}  // namespace lathelier::receptance
