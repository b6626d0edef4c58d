// Fourier sums and series at any angles, in O(n + K log K), exact to about 1e-12 of the sum of magnitudes.
// Source: Greengard and Lee, "Accelerating the nonuniform fast Fourier transform", SIAM Review 46 (2004) 443-454.
#pragma once

#include <complex>
#include <span>
#include <vector>

#include "engine/core/progress.h"

namespace lathelier::signal {

/// F_k = Σ_j values_j e^{-ikθ_j} for k = 0…limit.
std::vector<std::complex<double>> fourierSums(std::span<const double> angle_rad, std::span<const double> values,
                                              int limit, const Progress& progress = {});

/// g(θ_j) = c_0 + 2 Re Σ_{k>0} c_k e^{ikθ_j}: the real series with the coefficients c_0…c_K and their conjugates.
std::vector<double> fourierSeries(std::span<const std::complex<double>> coefficients, std::span<const double> angle_rad,
                                  const Progress& progress = {});

}  // namespace lathelier::signal
