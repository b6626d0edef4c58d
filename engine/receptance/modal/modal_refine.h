// Gauss and Newton on all parameters of a modal model of one or several responses, damped as by Levenberg and Marquardt
// (Nocedal and Wright, "Numerical Optimization", 2nd ed., chapter 10). The responses have common poles and residues and
// residual terms of their own. Frequencies and damping ratios are varied in their logarithms, so that they stay
// positive; residues and residual terms are linear: they are eliminated from each step and solved exactly after it
// (Golub and Pereyra, SIAM J. Numer. Anal. 10 (1973) 413).
#pragma once

#include <Eigen/Core>
#include <complex>
#include <span>
#include <vector>

#include "engine/core/progress.h"
#include "engine/core/value.h"

namespace lathelier::receptance {

/// Natural frequency and damping of one term (a + i b r)/(1 - r² + 2iζr), r = f/f_n.
struct Pole {
    double frequency_hz = 0;  ///< natural frequency f_n, > 0
    double damping = 0;       ///< damping ratio ζ, > 0
};

struct Residue {
    double a_mm_N = 0;  ///< real residue a: static compliance
    double b_mm_N = 0;  ///< quadrature residue b; 0 for real residues
};

/// Linear parameters of one response.
struct LinearTerms {
    std::vector<Residue> residues;  ///< by pole
    double lower_mm_Ns2 = 0;        ///< mass line 1/M
    double upper_mm_N = 0;          ///< compliance 1/K
};

/// Lines of one response with their weights.
struct FitLines {
    std::vector<double> frequency_hz;         ///< > 0, ascending
    std::vector<std::complex<double>> value;  ///< receptance, mm/N
    std::vector<double> weight;               ///< weight 1/σ, σ of real and imaginary part each
};

struct Refined {
    std::vector<Pole> poles;             ///< frequencies ascending
    std::vector<LinearTerms> responses;  ///< by response
    double chi2 = 0;                     ///< Σ |w (G_fit - G)|² over all lines
    bool converged = false;              ///< the last step was below the convergence limit
    /// By response: covariance of ln f, ln ζ of all poles, then a, [b] of all, lower and upper, for σ = 1/w.
    std::vector<Eigen::MatrixXd> covariance;
};

/// Residues per pole and response: a, and b for complex ones.
inline int perResidue(bool complex_residues)
{
    return complex_residues ? 2 : 1;
}

/// Rough: sufficient to compare fits with different numbers of terms. Full: until limited by rounding.
enum class Refinement { Rough, Full };

/// From these poles; residues are computed. Throws Cancelled.
Refined refineModes(std::span<const FitLines> lines, std::vector<Pole> start, bool complex_residues,
                    Refinement refinement = Refinement::Full, const Progress& progress = {});

/// Bounds of the frequencies during refinement: somewhat beyond the lines.
Interval reachOf(std::span<const FitLines> lines);

/// First and last frequency of all lines.
Interval spanOf(std::span<const FitLines> lines);

/// G_fit at one frequency.
std::complex<double> valueOf(const std::vector<Pole>& poles, const LinearTerms& terms, double frequency_hz);

/// (G - G_fit)/σ of each line.
std::vector<std::complex<double>> weightedErrors(const FitLines& lines, const Refined& fit, std::size_t response);

}  // namespace lathelier::receptance
