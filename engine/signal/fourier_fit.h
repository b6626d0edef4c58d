// Least-squares trigonometric polynomial through values at any angles.
// Source: Feichtinger, Groechenig, Strohmer, "Efficient numerical methods in non-uniform sampling theory", Numer. Math.
// 69 (1995) 423-440: adaptive weights, and conjugate gradients on the Toeplitz normal equations.
#pragma once

#include <complex>
#include <span>
#include <vector>

#include "engine/core/progress.h"
#include "engine/signal/angular_sampling.h"

namespace lathelier::signal {

/// Coefficients c_0…c_K of value(θ) = c_0 + 2 Re Σ_{k>0} c_k e^{ikθ} that fit best, `values` being in the sampling's
/// order. K is `limit`, or less where the sampling does not determine it (carriedOrders()) or where the normal
/// equations are worse conditioned than 30; at least 0.
std::vector<std::complex<double>> fitFourier(const AngularSampling& sampling, std::span<const double> values, int limit,
                                             const Progress& progress = {});

}  // namespace lathelier::signal
