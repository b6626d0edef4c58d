#include "engine/receptance/modal/modal_fit.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/core/core_codes.h"
#include "engine/core/units.h"
#include "engine/receptance/modal/modal_codes.h"
#include "engine/receptance/modal/modal_notes.h"
#include "engine/receptance/modal/modal_order.h"
#include "engine/receptance/modal/modal_weights.h"

namespace lathelier::receptance {
namespace {

constexpr std::size_t fewestFitLines = 12;
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

FitLines enoughLines(const Frf& frf, const ModalParameters& parameters)
{
    if (frf.quantity != FrfQuantity::Receptance) throw Error(errors::fitNeedsReceptance, {});
    const Interval asked = rangeOf(frf, parameters);
    FitLines lines = linesToFit(frf, asked);
    if (lines.value.size() < fewestFitLines)
        throw Error(errors::tooFewLinesToFit, {{"found", static_cast<std::int64_t>(lines.value.size())},
                                               {"from_hz", asked.from},
                                               {"to_hz", asked.to},
                                               {"minimum", static_cast<std::int64_t>(fewestFitLines)}});
    return lines;
}

ResidueSign signOf(const ResponseToFit& response, DrivingPoint asked)
{
    const bool is_driving_point =
        asked == DrivingPoint::Yes || (asked == DrivingPoint::Automatic && response.is_driving_point);
    return is_driving_point ? ResidueSign::Positive : ResidueSign::Any;
}

ModalMode modeOf(const Pole& pole, const Residue& residue)
{
    if (residue.b_mm_N == 0) return {pole.frequency_hz, pole.damping, 1 / residue.a_mm_N, 0};
    const double sign = residue.a_mm_N < 0 ? -1 : 1;
    return {pole.frequency_hz, pole.damping, sign / std::hypot(residue.a_mm_N, residue.b_mm_N),
            std::atan2(sign * residue.b_mm_N, sign * residue.a_mm_N) * 180 / std::numbers::pi};
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
Refined refinedFully(std::span<const FitLines> lines, const Refined& start, bool complex_residues,
                     const Progress& progress)
{
    Refined found = refineModes(lines, start.poles, complex_residues, Refinement::Full, progress);
    const auto left = std::erase_if(found.poles, [&](const Pole& pole) { return isAtEndOfReach(pole, lines); });
    return left > 0 ? refineModes(lines, found.poles, complex_residues, Refinement::Full, progress) : found;
}

/// Of the errors of ζ and k = 1/a.
double dampingStiffnessCorrelation(const Refined& found, std::size_t response, std::size_t k, int each)
{
    const Eigen::MatrixXd& c = found.covariance[response];
    const auto damping = 2 * static_cast<Eigen::Index>(k) + 1;
    const auto residue = 2 * static_cast<Eigen::Index>(found.poles.size()) + each * static_cast<Eigen::Index>(k);
    const double size = std::sqrt(c(damping, damping) * c(residue, residue));
    return size > 0 ? std::clamp(-c(damping, residue) / size, -1.0, 1.0) : 0;
}

void describe(ModalFit& fit, const Refined& found, std::span<const FitLines> all, std::size_t response)
{
    const bool complex_residues = fit.parameters.complex_residues;
    const double scale = scaleOf(found, all, complex_residues);
    const LinearTerms& terms = found.responses[response];
    for (std::size_t k = 0; k < found.poles.size(); ++k) {
        const ModalMode mode = modeOf(found.poles[k], terms.residues[k]);
        if (mode.frequency_hz < fit.range_hz.from || mode.frequency_hz > fit.range_hz.to) {
            fit.model.beyond.push_back(mode);
            continue;
        }
        fit.model.modes.push_back(mode);
        fit.modes.push_back({mode, mode.frequency_hz * poleUncertainty(found, k, 0, scale),
                             mode.damping_ratio * poleUncertainty(found, k, 1, scale),
                             mode.stiffness_N_mm * mode.stiffness_N_mm *
                                 residueUncertainty(found, response, k, complex_residues, scale),
                             halfPowerLines(all[response], mode), flexibilityOf(mode),
                             dampingStiffnessCorrelation(found, response, k, perResidue(complex_residues))});
    }
    fit.model.residuals = {terms.lower_mm_Ns2, terms.upper_mm_N};
    const Eigen::MatrixXd& covariance = found.covariance[response];
    const Eigen::Index lower = covariance.rows() - 2;
    fit.lower_uncertainty_mm_Ns2 = std::sqrt(std::max(0.0, covariance(lower, lower)) * scale);
    fit.upper_uncertainty_mm_N = std::sqrt(std::max(0.0, covariance(lower + 1, lower + 1)) * scale);
}

/// Lines that stand out of the noise: |G|² four times that of the noise in the mean of nine. All where none does.
std::vector<bool> linesThatStandOut(const FitLines& lines, const std::vector<double>& noise2)
{
    constexpr double leastRatio = 4;
    constexpr std::size_t around = 4;
    const std::size_t count = lines.value.size();
    std::vector<bool> stands(count);
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t from = i > around ? i - around : 0, to = std::min(count - 1, i + around);
        double ratio = 0;
        for (std::size_t j = from; j <= to; ++j) ratio += std::norm(lines.value[j]) / std::max(noise2[j], 1e-300);
        stands[i] = ratio > leastRatio * static_cast<double>(to - from + 1);
    }
    if (std::find(stands.begin(), stands.end(), true) == stands.end()) stands.assign(count, true);
    return stands;
}

void compare(ModalFit& fit, const Refined& found, const FitLines& lines, std::size_t response)
{
    fit.lines = lines.value.size();
    fit.synthesised = synthesised(fit.model, lines.frequency_hz);
    fit.error_percent.reserve(fit.lines);
    std::vector<double> noise2 = scatterOf(lines, found, response);
    for (std::size_t i = 0; i < fit.lines; ++i) noise2[i] *= 2 / (lines.weight[i] * lines.weight[i]);
    fit.stands_out = linesThatStandOut(lines, noise2);
    double error = 0, size = 0, noise = 0;
    for (std::size_t i = 0; i < fit.lines; ++i) {
        const double away = std::abs(fit.synthesised.value[i] - lines.value[i]), here = std::abs(lines.value[i]);
        fit.error_percent.push_back(here > 0 ? 100 * away / here : 0);
        if (!fit.stands_out[i]) continue;
        error += away * away;
        size += here * here;
        noise += noise2[i];
    }
    fit.error_rms_percent = size > 0 ? 100 * std::sqrt(error / size) : 0;
    fit.scatter_percent = size > 0 ? 100 * std::sqrt(noise / size) : 0;
}

/// Whether σ is to be found from the errors of the fit.
bool isWeighedByErrors(const Frf& frf)
{
    return frf.noise.empty() && frf.coherence.empty();
}

void reweighAll(std::vector<FitLines>& lines, std::span<const ResponseToFit> responses, const Refined& found)
{
    for (std::size_t i = 0; i < lines.size(); ++i)
        if (isWeighedByErrors(*responses[i].frf)) reweigh(lines[i], found, i);
}

/// The model, with the weights it was found with left in `lines`.
Refined foundModel(std::vector<FitLines>& lines, std::span<const ResponseToFit> responses, const OrderRequest& request,
                   const Progress& progress)
{
    const bool by_errors = std::any_of(responses.begin(), responses.end(),
                                       [](const ResponseToFit& one) { return isWeighedByErrors(*one.frf); });
    Refined found = fitByOrder(lines, request, progress.part(0, by_errors ? 0.45 : 0.9));
    if (by_errors) {
        reweighAll(lines, responses, found);
        found = fitByOrder(lines, request, progress.part(0.45, 0.9));
    }
    const Progress last = progress.part(0.9, 1);
    found = refinedFully(lines, found, request.complex_residues, last);
    for (int pass = 0; by_errors && pass < reweighings; ++pass) {
        reweighAll(lines, responses, found);
        found = refinedFully(lines, found, request.complex_residues, last);
    }
    return found;
}

/// A fit with real or complex residues, of each response.
std::vector<ModalFit> fitted(std::vector<FitLines> lines, std::span<const ResponseToFit> responses,
                             const OrderRequest& request, const Progress& progress)
{
    const Refined found = foundModel(lines, responses, request, progress);
    std::vector<ModalFit> fits;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        ModalFit& fit = fits.emplace_back();
        fit.parameters.modes = request.modes;
        fit.parameters.complex_residues = request.complex_residues;
        fit.range_hz = request.range_hz;
        describe(fit, found, lines, i);
        compare(fit, found, lines[i], i);
        addNotes(fit, found.converged);
    }
    return fits;
}

/// Half the error with no more modes.
bool isMuchBetter(const std::vector<ModalFit>& one, const std::vector<ModalFit>& other)
{
    constexpr double much = 0.5;
    double error = 0, of_other = 0;
    for (std::size_t i = 0; i < one.size(); ++i) {
        error += one[i].error_rms_percent * one[i].error_rms_percent;
        of_other += other[i].error_rms_percent * other[i].error_rms_percent;
    }
    return error < much * much * of_other && one.front().modes.size() <= other.front().modes.size();
}

}  // namespace

const std::vector<Field<ModalParameters>>& fieldsOf(const ModalParameters*)
{
    static const std::vector<Field<ModalParameters>> all{
        field("number_of_modes", &ModalParameters::modes, {0, mostModes},
              Label{LT_TEXT("Engine", "Number of modes"), LT_TEXT("Engine", "1 to 8; 0: as many as the data tell.")}),
        field("range_hz", &ModalParameters::range_hz, {0, 1e6},
              Label{LT_TEXT("Engine", "Range of frequencies"),
                    LT_TEXT("Engine", "Whose lines are fitted, as 100:800; empty: all."), unit::hz}),
        field("complex_residues", &ModalParameters::complex_residues,
              Label{LT_TEXT("Engine", "Complex residues"),
                    LT_TEXT("Engine", "For modes whose places do not move in phase or against each other."),
                    {},
                    true}),
        field("driving_point", &ModalParameters::driving_point,
              {{"auto", LT_TEXT("Engine", "As the nodes in the file tell")},
               {"yes", LT_TEXT("Engine", "Yes")},
               {"no", LT_TEXT("Engine", "No")}},
              Label{LT_TEXT("Engine", "Driving point"),
                    LT_TEXT("Engine", "Force and response at one place in one direction: no stiffness is negative."),
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

std::vector<ModalFit> fitResponses(std::span<const ResponseToFit> responses, const ModalParameters& parameters,
                                   const Progress& progress)
{
    std::vector<FitLines> lines;
    OrderRequest request{{}, parameters.modes, parameters.complex_residues, {}, {}};
    for (const ResponseToFit& one : responses) {
        lines.push_back(enoughLines(*one.frf, parameters));
        request.signs.push_back(signOf(one, parameters.driving_point));
    }
    request.range_hz = spanOf(lines);
    const std::vector<OrderPole> orders = polesByOrder(lines, progress.part(0, 0.1));
    request.stable = stablePoles(orders);
    std::vector<ModalFit> fits = fitted(lines, responses, request, progress.part(0.1, 0.6));
    if (!request.complex_residues && std::any_of(fits.begin(), fits.end(), leavesMore)) {
        request.complex_residues = true;
        std::vector<ModalFit> complex = fitted(lines, responses, request, progress.part(0.6, 1));
        if (isMuchBetter(complex, fits)) {
            for (std::size_t i = 0; i < fits.size(); ++i) noteComplexModes(complex[i], fits[i].error_rms_percent);
            fits = std::move(complex);
        }
    }
    for (ModalFit& fit : fits) {
        fit.orders = orders;
        const bool complex_residues = fit.parameters.complex_residues;
        fit.parameters = parameters;
        fit.parameters.complex_residues = complex_residues;
    }
    progress.report(1);
    return fits;
}

ModalFit fitModes(const Frf& frf, const ModalParameters& parameters, const Progress& progress)
{
    const ResponseToFit one{&frf};
    return std::move(fitResponses({&one, 1}, parameters, progress).front());
}

}  // namespace lathelier::receptance
