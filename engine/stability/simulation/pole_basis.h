// What a response is composed of when its poles are known: for each pole the two parts of a complex mode, and strongly
// damped terms for what the modes leave, which has no peak of its own.
//
// Structural damping loses the same share of energy at every frequency; viscous modes do so at their resonance only.
// What is missing between resonances, and what modes outside the lines add, is smooth: critically damped terms, a
// factor of four apart, follow it. They cannot chatter by themselves.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "engine/core/frf.h"

namespace lathelier::stability {

/// f_n and ζ of a pole pair.
struct Pole {
    double frequency_hz = 0;
    double damping_ratio = 0;
};

/// The critically damped terms for lines from `from_hz` to `to_hz`.
std::vector<Pole> smoothTerms(double from_hz, double to_hz);

/// The response on at most some hundred lines, dense around the poles.
Frf linesAround(const Frf& frf, const std::vector<Pole>& poles);

/// 1/(1 - r² + 2iζr) and i r times it, for each pole; columns of a matrix by lines.
Eigen::MatrixXcd termsOf(const std::vector<Pole>& poles, const std::vector<double>& frequency_hz);

/// Rows of real and imaginary parts.
Eigen::MatrixXd realRows(const Eigen::MatrixXcd& lines);

/// Least squares with columns scaled to one length, by Householder's method.
Eigen::VectorXd leastSquares(Eigen::MatrixXd rows, const Eigen::VectorXd& right);

/// Eigenvalues of a small real matrix.
Eigen::VectorXcd eigenvaluesOf(const Eigen::MatrixXd& matrix);

}  // namespace lathelier::stability
