// A closed profile between its points.
#pragma once

#include <vector>

#include "engine/signal/angular_sampling.h"

namespace lathelier::signal {

/// The value at any angle: that of the point that is there; between evenly spaced points a cubic through four
/// neighbours; between unevenly spaced ones, whose cubic may overshoot, a monotone cubic (Fritsch and Carlson, SIAM J.
/// Numer. Anal. 17 (1980) 238-246, with harmonic mean slopes); a line beside a gap; NaN across one. Never beyond the
/// extremes of all values. Holds on to what it is given.
class ClosedInterpolation {
public:
    /// `values` in the order of the sampling's angles.
    ClosedInterpolation(const AngularSampling& sampling, const std::vector<double>& values);

    double operator()(double angle_rad) const;

private:
    std::ptrdiff_t firstBeyond(double angle) const;
    std::size_t wrapped(std::ptrdiff_t i) const;
    double valueAt(std::ptrdiff_t i) const { return values_[wrapped(i)]; }
    double angleAt(std::ptrdiff_t i) const;
    double spacingAt(std::ptrdiff_t left) const { return angleAt(left + 1) - angleAt(left); }
    double slopeAt(std::ptrdiff_t i) const;  ///< that keeps the cubic monotone
    double throughFour(std::ptrdiff_t first, double angle) const;
    double monotone(std::ptrdiff_t left, double angle) const;

    const std::vector<double>& angle_;
    const std::vector<double>& values_;
    double widest_;
};

}  // namespace lathelier::signal
