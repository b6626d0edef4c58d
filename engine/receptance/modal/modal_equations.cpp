#include "engine/receptance/modal/modal_equations.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/core/plain_complex.h"

namespace lathelier::receptance {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;
constexpr Index batch = 64;  ///< lines whose derivatives are held at a time

/// Columns of one batch of lines: derivatives by poles for residues of 1, linear columns, the error. Real parts above
/// imaginary parts.
struct Columns {
    bool complex_residues;
    Index poles;  ///< number of poles
    Eigen::MatrixXd rows;

    Index each() const { return complex_residues ? 2 : 1; }
    Index linear() const { return 2 * each() * poles; }  ///< first linear column
    Index lower() const { return linear() + each() * poles; }
    Index count() const { return lower() + 3; }

    void put(Index line, Index column, const Complex& value)
    {
        rows(line, column) = value.real();
        rows(line + batch, column) = value.imag();
    }
};

void putPole(Columns& columns, const FitLines& lines, std::size_t begin, Index used, Index k, const Pole& pole,
             const Residue& residue)
{
    const Index each = columns.each(), at = 2 * each * k, linear = columns.linear() + each * k,
                error = columns.count() - 1;
    const double z2 = 2 * pole.damping, inverse_f = 1 / pole.frequency_hz;
    for (Index line = 0; line < used; ++line) {
        const auto i = begin + static_cast<std::size_t>(line);
        const double w = lines.weight[i], r = lines.frequency_hz[i] * inverse_f;
        const Complex inverse = reciprocal(Complex(1 - r * r, z2 * r)), squared = product(inverse, inverse);
        const Complex by_f = w * product(squared, Complex(-2 * r * r, z2 * r)),
                      by_z = w * product(squared, Complex(0, -z2 * r));
        const Complex unit = w * inverse;
        columns.put(line, at, by_f);
        columns.put(line, at + 1, by_z);
        columns.put(line, linear, unit);
        Complex part = residue.a_mm_N * unit;
        if (columns.complex_residues) {
            const auto turned = [r](const Complex& c) { return Complex(-r * c.imag(), r * c.real()); };
            const Complex quadrature = turned(unit);
            columns.put(line, at + 2, turned(by_f) - quadrature);
            columns.put(line, at + 3, turned(by_z));
            columns.put(line, linear + 1, quadrature);
            part += residue.b_mm_N * quadrature;
        }
        columns.rows(line, error) -= part.real();
        columns.rows(line + batch, error) -= part.imag();
    }
}

/// Σ of products of all columns over all lines.
Eigen::MatrixXd productsOf(Columns& columns, const FitLines& lines, const std::vector<Pole>& poles,
                           const LinearTerms& terms)
{
    const Index count = columns.count(), lower = columns.lower();
    Eigen::MatrixXd products = Eigen::MatrixXd::Zero(count, count);
    columns.rows = Eigen::MatrixXd::Zero(2 * batch, count);
    const std::size_t all = lines.frequency_hz.size();
    for (std::size_t begin = 0; begin < all; begin += static_cast<std::size_t>(batch)) {
        const Index used = std::min<Index>(batch, static_cast<Index>(all - begin));
        if (used < batch) columns.rows.setZero();
        for (Index line = 0; line < used; ++line) {
            const auto i = begin + static_cast<std::size_t>(line);
            const double w = lines.weight[i], circular = 2 * std::numbers::pi * lines.frequency_hz[i];
            const double mass = -w / (circular * circular);
            columns.put(line, lower, mass);
            columns.put(line, lower + 1, w);
            columns.put(line, lower + 2, w * lines.value[i] - terms.lower_mm_Ns2 * mass - terms.upper_mm_N * w);
        }
        for (std::size_t k = 0; k < poles.size(); ++k)
            putPole(columns, lines, begin, used, static_cast<Index>(k), poles[k], terms.residues[k]);
        products.selfadjointView<Eigen::Lower>().rankUpdate(columns.rows.transpose());
    }
    return products.selfadjointView<Eigen::Lower>();
}

void addTo(LinearTerms& terms, const Eigen::VectorXd& step, Index each)
{
    for (std::size_t k = 0; k < terms.residues.size(); ++k) {
        const auto at = each * static_cast<Index>(k);
        terms.residues[k].a_mm_N += step(at);
        if (each == 2) terms.residues[k].b_mm_N += step(at + 1);
    }
    terms.lower_mm_Ns2 += step(step.size() - 2);
    terms.upper_mm_N += step(step.size() - 1);
}

/// Derivatives by poles from those for residues of 1.
Eigen::MatrixXd byResidues(const LinearTerms& terms, Index each)
{
    const auto count = static_cast<Index>(terms.residues.size());
    Eigen::MatrixXd combined = Eigen::MatrixXd::Zero(2 * each * count, 2 * count);
    for (Index k = 0; k < count; ++k) {
        const Residue& residue = terms.residues[static_cast<std::size_t>(k)];
        for (Index j = 0; j < 2; ++j) {
            combined(2 * each * k + j, 2 * k + j) = residue.a_mm_N;
            if (each == 2) combined(2 * each * k + 2 + j, 2 * k + j) = residue.b_mm_N;
        }
    }
    return combined;
}

}  // namespace

Eigen::MatrixXd solvedScaled(const Eigen::MatrixXd& matrix, const Eigen::MatrixXd& right, double damping)
{
    if (right.size() == 0) return right;  // without modes, or without terms
    const Eigen::VectorXd inverse = matrix.diagonal().cwiseMax(1e-300).cwiseSqrt().cwiseInverse();
    Eigen::MatrixXd scaled = inverse.asDiagonal() * matrix * inverse.asDiagonal();
    scaled.diagonal().array() += damping;
    return inverse.asDiagonal() * scaled.ldlt().solve(inverse.asDiagonal() * right);
}

ResponseEquations equationsOf(const FitLines& lines, const std::vector<Pole>& poles, LinearTerms& terms,
                              bool complex_residues)
{
    terms.residues.resize(poles.size());
    Columns columns{complex_residues, static_cast<Index>(poles.size()), {}};
    const Eigen::MatrixXd products = productsOf(columns, lines, poles, terms);
    const Index first = columns.linear(), linear = columns.count() - 1 - first, error = columns.count() - 1;
    ResponseEquations equations;
    equations.ll = products.block(first, first, linear, linear);
    const Eigen::VectorXd right = products.block(first, error, linear, 1);
    const Eigen::VectorXd step = solvedScaled(equations.ll, right);
    equations.chi2 = products(error, error);
    Eigen::VectorXd by_unit = products.block(0, error, first, 1);
    if (step.allFinite()) {
        addTo(terms, step, columns.each());
        equations.chi2 = std::max(0.0, equations.chi2 - step.dot(right));
        by_unit -= products.block(0, first, first, linear) * step;
    }
    const Eigen::MatrixXd combined = byResidues(terms, columns.each());
    equations.pp = combined.transpose() * products.topLeftCorner(first, first) * combined;
    equations.pl = combined.transpose() * products.block(0, first, first, linear);
    equations.p = combined.transpose() * by_unit;
    equations.solved_lp = solvedScaled(equations.ll, equations.pl.transpose());
    return equations;
}

}  // namespace lathelier::receptance
