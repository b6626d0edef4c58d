// Interpolation of a closed profile.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "engine/signal/angular_sampling.h"

namespace lathelier::signal {

/// The value at any angle: at a point its value; between evenly spaced points a cubic through four neighbours; between
/// unevenly spaced ones, whose cubic may overshoot, a monotone cubic (Fritsch and Carlson, SIAM J. Numer. Anal. 17
/// (1980) 238-246, with harmonic mean slopes); a line beside a gap; NaN across one. Never beyond the extremes of all
/// values. Keeps references to its arguments.
class ClosedInterpolation {
public:
    /// `values` in the order of the sampling's angles.
    ClosedInterpolation(const AngularSampling& sampling, const std::vector<double>& values);

    double operator()(double angle_rad) const;
    /// The same, faster for ascending angles: `place` is the index of the previous one, 0 at first.
    double operator()(double angle_rad, std::size_t& place) const;

private:
    /// The four points about an angle, their angles ascending.
    struct Neighbours {
        std::array<double, 4> angle, value;
        double spacing(std::size_t left) const { return angle[left + 1] - angle[left]; }
        double slope(std::size_t i) const;  ///< slope that keeps the cubic monotone
        double throughFour(double at) const;
        double monotone(double at) const;
    };
    std::size_t firstBeyond(double angle, std::size_t place) const;
    Neighbours about(std::size_t right) const;

    const std::vector<double>& angle_;
    const std::vector<double>& values_;
    double widest_;
};

}  // namespace lathelier::signal
