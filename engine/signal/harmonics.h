// Harmonics of a closed profile: amplitude and phase of each number of undulations per revolution (UPR).
// Source: ISO/TS 12181-1 (undulations per revolution); least squares in a trigonometric basis for uneven angles.
#pragma once

#include <span>
#include <vector>

#include "engine/core/progress.h"
#include "engine/signal/angular_sampling.h"

namespace lathelier::signal {

/// One harmonic; r contains amplitude · cos(upr · θ - phase).
struct Harmonic {
    int upr = 0;           ///< order, undulations per revolution
    double amplitude = 0;  ///< zero to peak, in the unit of the values
    double phase_rad = 0;  ///< the first crest lies at phase / upr
};

/// Harmonics k = 1…limit of values at uniform angles θ_j = 2πj/n, limit ≤ n/2. At k = n/2 only the observable part is
/// determined.
std::vector<Harmonic> harmonicsUniform(std::span<const double> values, int limit);

/// The same for any angles (with gaps, duplicates, any order), by least squares, up to the order that the sampling
/// determines (carriedOrders()). Orders undetermined because of small gaps are estimated from the residual of the lower
/// ones, those of an uneven or interrupted sampling omitted; with a third of the revolution missing there are none.
std::vector<Harmonic> harmonicsAt(std::span<const double> angle_rad, std::span<const double> values, int limit);

/// The same for values in the order of a sampling.
std::vector<Harmonic> harmonicsAt(const AngularSampling& sampling, std::vector<double> values, int limit,
                                  const Progress& progress = {});

}  // namespace lathelier::signal
