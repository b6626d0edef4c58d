// From Monte Carlo draws of a form deviation to its expanded uncertainty.
// Source: JCGM 101 (propagation of distributions), JCGM 100 (coverage interval of 95 %).
#pragma once

#include <vector>

namespace lathelier::form {

/// Half-width of an interval about the measured deviation that holds the one without noise in 95 of 100 measurements.
/// `changes`: how much noise changed the deviation in each of at least two draws. Their mean counts, for extremes of
/// noise always add, and their spread with that of the noise's own estimate (`relative_u`, relative standard
/// uncertainty); or, where it is wider, the interval as counted, which single spikes need.
double coverageHalfWidth(std::vector<double> changes, double relative_u);

}  // namespace lathelier::form
