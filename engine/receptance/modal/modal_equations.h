// Normal equations of one response: derivatives by poles and by the linear parameters, summed over the lines.
#pragma once

#include "engine/receptance/modal/modal_refine.h"

namespace lathelier::receptance {

/// Of σ-weighted lines, after the residues of these poles have been solved for. Index p: poles (ln f, ln ζ of each),
/// l: linear parameters (a, [b] of each, lower, upper).
struct ResponseEquations {
    Eigen::MatrixXd pp, pl, ll;  ///< sums of products of derivatives
    Eigen::VectorXd p;           ///< derivatives by poles times errors; those by linear parameters are 0
    Eigen::MatrixXd solved_lp;   ///< ll⁻¹ plᵀ
    double chi2 = 0;             ///< Σ |w (G_fit - G)|²
};

/// One pass over the lines; `terms` (a start, or zeros) receives the best linear parameters for these poles.
ResponseEquations equationsOf(const FitLines& lines, const std::vector<Pole>& poles, LinearTerms& terms,
                              bool complex_residues);

/// matrix⁻¹ right for a positive definite matrix, with its diagonal scaled to 1 and enlarged by 1 + `damping`.
Eigen::MatrixXd solvedScaled(const Eigen::MatrixXd& matrix, const Eigen::MatrixXd& right, double damping = 0);

}  // namespace lathelier::receptance
