#include "engine/receptance/modal/modal_refine.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "engine/core/plain_complex.h"
#include "engine/receptance/modal/modal_equations.h"

namespace lathelier::receptance {
namespace {

struct Ending {
    int steps;          ///< largest number of steps
    int settled;        ///< number of consecutive small steps that ends the iteration
    double step, gain;  ///< limits of a small step: change of ln f and ln ζ, relative change of χ²
};
constexpr Ending rough{20, 1, 1e-5, 1e-4}, full{60, 2, 1e-11, 1e-13};
constexpr double leastStep = 1e-9;   ///< below this step χ² may not decrease because of rounding
constexpr int attempts = 8;          ///< attempts with increasing damping
constexpr double largestStep = 0.3;  ///< largest change of ln f and ln ζ in one step
constexpr double leastRefinedDamping = 1e-6, mostRefinedDamping = 0.7;
constexpr double widestRefined = 4;  ///< how far terms may leave the lines: factor of the first and last frequency

/// A model with the equations of its responses.
struct Iterate {
    Refined model;
    std::vector<ResponseEquations> equations;
};

void evaluate(Iterate& iterate, std::span<const FitLines> lines, bool complex_residues, const Progress& progress)
{
    iterate.equations.clear();
    iterate.model.chi2 = 0;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        progress.check();
        iterate.equations.push_back(
            equationsOf(lines[i], iterate.model.poles, iterate.model.responses[i], complex_residues));
        iterate.model.chi2 += iterate.equations.back().chi2;
    }
}

/// Sum over responses of pp - pl ll⁻¹ plᵀ: the equations of the poles with the linear parameters eliminated.
Eigen::MatrixXd poleMatrix(const Iterate& iterate)
{
    const auto count = 2 * static_cast<Eigen::Index>(iterate.model.poles.size());
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(count, count);
    for (const ResponseEquations& one : iterate.equations) matrix += one.pp - one.pl * one.solved_lp;
    return matrix;
}

Eigen::VectorXd poleRight(const Iterate& iterate)
{
    Eigen::VectorXd right = Eigen::VectorXd::Zero(2 * static_cast<Eigen::Index>(iterate.model.poles.size()));
    for (const ResponseEquations& one : iterate.equations) right += one.p;
    return right;
}

/// The model after a step of its poles, with the linear parameters the equations predict; gives the largest change.
double move(Refined& model, const Iterate& from, const Eigen::VectorXd& delta, const Interval& reach, int each)
{
    double largest = 0;
    for (std::size_t k = 0; k < model.poles.size(); ++k) {
        const auto at = 2 * static_cast<Eigen::Index>(k);
        const Pole before = model.poles[k];
        Pole& pole = model.poles[k];
        const auto factor = [&](Eigen::Index j) {
            return std::exp(std::clamp(delta(at + j), -largestStep, largestStep));
        };
        pole.frequency_hz = std::clamp(before.frequency_hz * factor(0), reach.from, reach.to);
        pole.damping = std::clamp(before.damping * factor(1), leastRefinedDamping, mostRefinedDamping);
        largest = std::max({largest, std::abs(std::log(pole.frequency_hz / before.frequency_hz)),
                            std::abs(std::log(pole.damping / before.damping))});
    }
    for (std::size_t i = 0; i < model.responses.size(); ++i) {
        const Eigen::VectorXd change = -(from.equations[i].solved_lp * delta);
        if (!change.allFinite()) continue;
        LinearTerms& terms = model.responses[i];
        for (std::size_t k = 0; k < terms.residues.size(); ++k) {
            const auto at = each * static_cast<Eigen::Index>(k);
            terms.residues[k].a_mm_N += change(at);
            if (each == 2) terms.residues[k].b_mm_N += change(at + 1);
        }
        terms.lower_mm_Ns2 += change(change.size() - 2);
        terms.upper_mm_N += change(change.size() - 1);
    }
    return largest;
}

/// One damped step with less χ². Gives its change of ln f and ln ζ; negative: none was found.
double improve(Iterate& at, std::span<const FitLines> lines, bool complex_residues, const Interval& reach,
               double& damping, const Progress& progress)
{
    const Eigen::MatrixXd matrix = poleMatrix(at);
    const Eigen::VectorXd right = poleRight(at);
    for (int attempt = 0; attempt < attempts; ++attempt) {
        const Eigen::VectorXd delta = solvedScaled(matrix, right, damping);
        if (!delta.allFinite()) return -1;
        Iterate next{at.model, {}};
        const double largest = move(next.model, at, delta, reach, perResidue(complex_residues));
        evaluate(next, lines, complex_residues, progress);
        if (next.model.chi2 < at.model.chi2) {
            at = std::move(next);
            damping = std::max(1e-12, damping / 10);
            return largest;
        }
        if (largest < leastStep) return 0;  // limited by rounding
        damping = std::max(damping, 1e-9) * 10;
    }
    return -1;
}

void sortByFrequency(Refined& model)
{
    std::vector<std::size_t> order(model.poles.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return model.poles[a].frequency_hz < model.poles[b].frequency_hz;
    });
    const Refined before = model;
    for (std::size_t k = 0; k < order.size(); ++k) {
        model.poles[k] = before.poles[order[k]];
        for (std::size_t i = 0; i < model.responses.size(); ++i)
            model.responses[i].residues[k] = before.responses[i].residues[order[k]];
    }
}

/// From the block inverse: poles (Σ S)⁻¹, linear ll⁻¹ + ll⁻¹ plᵀ (Σ S)⁻¹ pl ll⁻¹.
void findCovariance(Iterate& at)
{
    const Eigen::MatrixXd matrix = poleMatrix(at);
    const Eigen::Index poles = matrix.rows();
    const Eigen::MatrixXd of_poles = solvedScaled(matrix, Eigen::MatrixXd::Identity(poles, poles));
    for (const ResponseEquations& one : at.equations) {
        const Eigen::Index linear = one.ll.rows();
        Eigen::MatrixXd covariance(poles + linear, poles + linear);
        covariance.topLeftCorner(poles, poles) = of_poles;
        covariance.bottomLeftCorner(linear, poles) = -one.solved_lp * of_poles;
        covariance.topRightCorner(poles, linear) = covariance.bottomLeftCorner(linear, poles).transpose();
        covariance.bottomRightCorner(linear, linear) = solvedScaled(one.ll, Eigen::MatrixXd::Identity(linear, linear)) +
                                                       one.solved_lp * of_poles * one.solved_lp.transpose();
        at.model.covariance.push_back(std::move(covariance));
    }
}

}  // namespace

Interval spanOf(std::span<const FitLines> lines)
{
    Interval all{lines.front().frequency_hz.front(), lines.front().frequency_hz.back()};
    for (const FitLines& one : lines)
        all = {std::min(all.from, one.frequency_hz.front()), std::max(all.to, one.frequency_hz.back())};
    return all;
}

Interval reachOf(std::span<const FitLines> lines)
{
    const Interval all = spanOf(lines);
    return {all.from / widestRefined, all.to * widestRefined};
}

std::complex<double> valueOf(const std::vector<Pole>& poles, const LinearTerms& terms, double frequency_hz)
{
    const double circular = 2 * std::numbers::pi * frequency_hz;
    std::complex<double> sum = terms.upper_mm_N - terms.lower_mm_Ns2 / (circular * circular);
    for (std::size_t k = 0; k < poles.size(); ++k) {
        const double r = frequency_hz / poles[k].frequency_hz;
        sum += product({terms.residues[k].a_mm_N, terms.residues[k].b_mm_N * r},
                       reciprocal(std::complex<double>(1 - r * r, 2 * poles[k].damping * r)));
    }
    return sum;
}

std::vector<std::complex<double>> weightedErrors(const FitLines& lines, const Refined& fit, std::size_t response)
{
    std::vector<std::complex<double>> errors;
    errors.reserve(lines.value.size());
    for (std::size_t i = 0; i < lines.value.size(); ++i)
        errors.push_back(lines.weight[i] *
                         (lines.value[i] - valueOf(fit.poles, fit.responses[response], lines.frequency_hz[i])));
    return errors;
}

Refined refineModes(std::span<const FitLines> lines, std::vector<Pole> start, bool complex_residues,
                    Refinement refinement, const Progress& progress)
{
    const Ending& ending = refinement == Refinement::Rough ? rough : full;
    const Interval reach = reachOf(lines);
    Iterate at;
    at.model.poles = std::move(start);
    at.model.responses.resize(lines.size());
    evaluate(at, lines, complex_residues, progress);
    evaluate(at, lines, complex_residues, progress);  // corrects rounding

    double damping = 1e-3;
    int settled = 0;
    for (int step = 0; step < ending.steps && settled < ending.settled && !at.model.poles.empty(); ++step) {
        const double before = at.model.chi2;
        const double moved = improve(at, lines, complex_residues, reach, damping, progress);
        if (moved < 0) break;
        if (moved == 0) settled = ending.settled;
        const bool is_small = moved < ending.step || at.model.chi2 > (1 - ending.gain) * before;
        settled = is_small ? settled + 1 : 0;
    }
    at.model.converged = at.model.poles.empty() || settled >= ending.settled;
    findCovariance(at);
    Refined found = std::move(at.model);
    if (std::is_sorted(found.poles.begin(), found.poles.end(),
                       [](const Pole& a, const Pole& b) { return a.frequency_hz < b.frequency_hz; }))
        return found;
    sortByFrequency(found);
    Iterate sorted{std::move(found), {}};
    sorted.model.covariance.clear();
    evaluate(sorted, lines, complex_residues, progress);
    findCovariance(sorted);
    return sorted.model;
}

}  // namespace lathelier::receptance
