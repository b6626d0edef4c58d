// Gauss and Newton on all parameters of a modal model, damped as by Levenberg and Marquardt (Nocedal and Wright,
// "Numerical Optimization", 2nd ed., chapter 10). Frequencies and damping ratios are varied in their logarithms, so
// that they stay positive; residues and residual terms are linear and solved exactly after each step.
#pragma once

#include <Eigen/Core>
#include <complex>
#include <span>
#include <vector>

#include "engine/core/progress.h"
#include "engine/core/value.h"

namespace lathelier::receptance {

/// One term (a + i b r)/(1 - r² + 2iζr), r = f/f_n.
struct PoleTerm {
    double frequency_hz = 0;  ///< natural frequency f_n, > 0
    double damping = 0;       ///< damping ratio ζ, > 0
    double a_mm_N = 0;        ///< real residue a: static compliance
    double b_mm_N = 0;        ///< quadrature residue b; 0 for real residues
};

/// Lines with their weights.
struct FitLines {
    std::vector<double> frequency_hz;         ///< > 0, ascending
    std::vector<std::complex<double>> value;  ///< receptance, mm/N
    std::vector<double> weight;               ///< weight 1/σ
};

struct Refined {
    std::vector<PoleTerm> terms;  ///< frequencies ascending
    double lower_mm_Ns2 = 0;      ///< mass line 1/M
    double upper_mm_N = 0;        ///< compliance 1/K
    double chi2 = 0;              ///< Σ |w (G_fit - G)|²
    bool converged = false;       ///< the last step was below the convergence limit
    /// Covariance of (ln f, ln ζ, a, [b]) of each term in order, then lower and upper, for σ = 1/w.
    Eigen::MatrixXd covariance;
};

/// Parameters of one term.
inline int perTerm(bool complex_residues)
{
    return complex_residues ? 4 : 3;
}

/// Rough: sufficient to compare fits with different numbers of terms. Full: until limited by rounding.
enum class Refinement { Rough, Full };

/// From the frequencies and damping ratios of `start`; its residues are computed. Throws Cancelled.
Refined refineModes(const FitLines& lines, std::vector<PoleTerm> start, bool complex_residues,
                    Refinement refinement = Refinement::Full, const Progress& progress = {});

/// Bounds of the frequencies during refinement: somewhat beyond the lines.
Interval reachOf(const FitLines& lines);

/// G_fit at one frequency.
std::complex<double> valueOf(const Refined& model, double frequency_hz);

}  // namespace lathelier::receptance
