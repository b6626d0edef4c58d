#include "engine/receptance/modal/modal_refine.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/core/plain_complex.h"

namespace lathelier::receptance {
namespace {

using Complex = std::complex<double>;
struct Ending {
    int steps;          ///< largest number of steps
    int settled;        ///< number of consecutive small steps that ends the iteration
    double step, gain;  ///< limits of a small step: change of ln f and ln ζ, relative change of χ²
};
constexpr Ending rough{20, 1, 1e-5, 1e-5}, full{60, 2, 1e-11, 1e-13};
constexpr double leastStep = 1e-9;   ///< below this step χ² may not decrease because of rounding
constexpr int attempts = 8;          ///< attempts with increasing damping
constexpr double largestStep = 0.3;  ///< largest change of ln f and ln ζ in one step
constexpr double leastRefinedDamping = 1e-6, mostRefinedDamping = 0.7;
constexpr double widestRefined = 4;  ///< how far terms may leave the lines: factor of the first and last frequency

struct Term {
    Complex d_frequency, d_damping, d_a, d_b;  ///< derivatives by ln f, ln ζ, a, b
    Complex value;
};

/// The pole's part of a receptance for a residue of 1.
Complex unitTerm(const PoleTerm& p, double r)
{
    return reciprocal(Complex(1 - r * r, 2 * p.damping * r));
}

Term termAt(const PoleTerm& p, double frequency_hz)
{
    const double r = frequency_hz / p.frequency_hz;
    const Complex inverse = unitTerm(p, r);
    const Complex numerator(p.a_mm_N, p.b_mm_N * r);
    const Complex by_r =
        Complex(0, p.b_mm_N) * inverse - numerator * Complex(-2 * r, 2 * p.damping) * inverse * inverse;
    return {-r * by_r, -numerator * Complex(0, 2 * p.damping * r) * inverse * inverse, inverse, Complex(0, r) * inverse,
            numerator * inverse};
}

double massLine(double frequency_hz)
{
    const double w = 2 * std::numbers::pi * frequency_hz;
    return -1 / (w * w);
}

/// Normal equations over the lines: `columns` are the derivatives of one line, `rest` its residual.
struct NormalEquations {
    Eigen::MatrixXd matrix;
    Eigen::VectorXd right;
    Eigen::VectorXd scale;  ///< square roots of the diagonal

    /// Solves with the diagonal enlarged by 1 + damping.
    Eigen::VectorXd solved(double damping) const
    {
        const Eigen::VectorXd inverse = scale.cwiseInverse();
        Eigen::MatrixXd scaled = inverse.asDiagonal() * matrix * inverse.asDiagonal();
        scaled.diagonal().array() += damping;
        return inverse.asDiagonal() * scaled.ldlt().solve(inverse.asDiagonal() * right);
    }
};

template <class Columns>
NormalEquations normalEquations(const FitLines& lines, Eigen::Index count, Columns columns)
{
    NormalEquations normal{Eigen::MatrixXd::Zero(count, count), Eigen::VectorXd::Zero(count), {}};
    constexpr Eigen::Index batch = 64;
    Eigen::MatrixXd rows(2 * batch, count);
    Eigen::VectorXd rest(2 * batch);
    Eigen::VectorXcd line(count);
    const std::size_t all = lines.frequency_hz.size();
    for (std::size_t begin = 0; begin < all; begin += static_cast<std::size_t>(batch)) {
        const std::size_t end = std::min(all, begin + static_cast<std::size_t>(batch));
        Eigen::Index row = 0;
        for (std::size_t i = begin; i < end; ++i) {
            const Complex left = lines.weight[i] * columns(i, line);
            rows.row(row) = lines.weight[i] * line.real().transpose();
            rest(row++) = left.real();
            rows.row(row) = lines.weight[i] * line.imag().transpose();
            rest(row++) = left.imag();
        }
        const auto used = rows.topRows(row);
        normal.matrix.selfadjointView<Eigen::Lower>().rankUpdate(used.transpose());
        normal.right += used.transpose() * rest.head(row);
    }
    normal.matrix = Eigen::MatrixXd(normal.matrix.selfadjointView<Eigen::Lower>());
    normal.scale = normal.matrix.diagonal().cwiseMax(1e-300).cwiseSqrt();
    return normal;
}

void solveResidues(const FitLines& lines, Refined& model, bool complex_residues)
{
    const Eigen::Index each = complex_residues ? 2 : 1,
                       count = each * static_cast<Eigen::Index>(model.terms.size()) + 2;
    for (int pass = 0; pass < 2; ++pass) {  // the second pass corrects rounding
        const NormalEquations normal = normalEquations(lines, count, [&](std::size_t i, Eigen::VectorXcd& line) {
            const double f = lines.frequency_hz[i];
            for (std::size_t k = 0; k < model.terms.size(); ++k) {
                const double r = f / model.terms[k].frequency_hz;
                const Complex inverse = unitTerm(model.terms[k], r);
                const auto at = each * static_cast<Eigen::Index>(k);
                line(at) = inverse;
                if (complex_residues) line(at + 1) = Complex(0, r) * inverse;
            }
            line(count - 2) = massLine(f);
            line(count - 1) = 1;
            return lines.value[i] - valueOf(model, f);
        });
        const Eigen::VectorXd step = normal.solved(0);
        if (!step.allFinite()) return;
        for (std::size_t k = 0; k < model.terms.size(); ++k) {
            const auto at = each * static_cast<Eigen::Index>(k);
            model.terms[k].a_mm_N += step(at);
            if (complex_residues) model.terms[k].b_mm_N += step(at + 1);
        }
        model.lower_mm_Ns2 += step(count - 2);
        model.upper_mm_N += step(count - 1);
    }
}

double chi2Of(const FitLines& lines, const Refined& model)
{
    double sum = 0;
    for (std::size_t i = 0; i < lines.frequency_hz.size(); ++i)
        sum += std::norm(lines.weight[i] * (valueOf(model, lines.frequency_hz[i]) - lines.value[i]));
    return sum;
}

NormalEquations allParameters(const FitLines& lines, const Refined& model, bool complex_residues)
{
    const Eigen::Index each = perTerm(complex_residues),
                       count = each * static_cast<Eigen::Index>(model.terms.size()) + 2;
    return normalEquations(lines, count, [&](std::size_t i, Eigen::VectorXcd& line) {
        const double f = lines.frequency_hz[i];
        Complex rest = lines.value[i] - model.upper_mm_N - model.lower_mm_Ns2 * massLine(f);
        for (std::size_t k = 0; k < model.terms.size(); ++k) {
            const Term term = termAt(model.terms[k], f);
            const auto at = each * static_cast<Eigen::Index>(k);
            line(at) = term.d_frequency;
            line(at + 1) = term.d_damping;
            line(at + 2) = term.d_a;
            if (complex_residues) line(at + 3) = term.d_b;
            rest -= term.value;
        }
        line(count - 2) = massLine(f);
        line(count - 1) = 1;
        return rest;
    });
}

}  // namespace

Interval reachOf(const FitLines& lines)
{
    return {lines.frequency_hz.front() / widestRefined, lines.frequency_hz.back() * widestRefined};
}

Complex valueOf(const Refined& model, double frequency_hz)
{
    Complex sum = model.upper_mm_N + model.lower_mm_Ns2 * massLine(frequency_hz);
    for (const PoleTerm& p : model.terms) {
        const double r = frequency_hz / p.frequency_hz;
        sum += Complex(p.a_mm_N, p.b_mm_N * r) * unitTerm(p, r);
    }
    return sum;
}

Refined refineModes(const FitLines& lines, std::vector<PoleTerm> start, bool complex_residues, Refinement refinement,
                    const Progress& progress)
{
    const Ending& ending = refinement == Refinement::Rough ? rough : full;
    const Eigen::Index each = perTerm(complex_residues);
    const Interval reach = reachOf(lines);
    Refined model;
    model.terms = std::move(start);
    for (PoleTerm& term : model.terms) term.a_mm_N = term.b_mm_N = 0;
    solveResidues(lines, model, complex_residues);
    model.chi2 = chi2Of(lines, model);

    double damping = 1e-3;
    int settled = 0;
    for (int step = 0; step < ending.steps && settled < ending.settled && !model.terms.empty(); ++step) {
        progress.check();
        const NormalEquations normal = allParameters(lines, model, complex_residues);
        bool moved = false;
        for (int attempt = 0; attempt < attempts && !moved; ++attempt) {
            const Eigen::VectorXd delta = normal.solved(damping);
            Refined next = model;
            double largest = 0;
            for (std::size_t k = 0; k < model.terms.size(); ++k) {
                const auto at = each * static_cast<Eigen::Index>(k);
                const PoleTerm before = model.terms[k];
                PoleTerm& term = next.terms[k];
                const auto moved_by = [&](Eigen::Index j) {
                    return std::exp(std::clamp(delta(at + j), -largestStep, largestStep));
                };
                term.frequency_hz = std::clamp(before.frequency_hz * moved_by(0), reach.from, reach.to);
                term.damping = std::clamp(before.damping * moved_by(1), leastRefinedDamping, mostRefinedDamping);
                largest = std::max({largest, std::abs(std::log(term.frequency_hz / before.frequency_hz)),
                                    std::abs(std::log(term.damping / before.damping))});
            }
            solveResidues(lines, next, complex_residues);
            next.chi2 = chi2Of(lines, next);
            if (next.chi2 < model.chi2) {
                settled = largest < ending.step || next.chi2 > (1 - ending.gain) * model.chi2 ? settled + 1 : 0;
                model = std::move(next);
                damping = std::max(1e-12, damping / 10);
                moved = true;
            } else {
                if (largest < leastStep) {  // limited by rounding
                    settled = ending.settled;
                    break;
                }
                damping = std::max(damping, 1e-9) * 10;
            }
        }
        if (!moved) break;
    }
    model.converged = model.terms.empty() || settled >= ending.settled;
    std::sort(model.terms.begin(), model.terms.end(),
              [](const PoleTerm& a, const PoleTerm& b) { return a.frequency_hz < b.frequency_hz; });
    const NormalEquations normal = allParameters(lines, model, complex_residues);
    const Eigen::VectorXd inverse = normal.scale.cwiseInverse();
    const Eigen::MatrixXd scaled = inverse.asDiagonal() * normal.matrix * inverse.asDiagonal();
    const Eigen::MatrixXd identity = Eigen::MatrixXd::Identity(scaled.rows(), scaled.cols());
    model.covariance = inverse.asDiagonal() * scaled.ldlt().solve(identity) * inverse.asDiagonal();
    return model;
}

}  // namespace lathelier::receptance
