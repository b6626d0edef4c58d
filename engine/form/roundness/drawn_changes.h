// From Monte Carlo draws of a form deviation to its expanded uncertainty.
// Source: JCGM 101 (propagation of distributions), JCGM 100 (coverage interval of 95 %).
#pragma once

#include <vector>

namespace lathelier::form {

/// Half-width of an interval about the measured deviation that contains the noise-free one with 95 % probability.
/// `changes`: change of the deviation by noise in each of at least two draws. The interval includes their mean, since
/// extremes of noise always increase a peak-to-valley value, and their spread together with that of the noise estimate
/// (`relative_u`, relative standard uncertainty); or the empirical interval where it is wider, which isolated spikes
/// require.
double coverageHalfWidth(std::vector<double> changes, double relative_u);

}  // namespace lathelier::form
