// A closed profile between its points.
#pragma once

#include <vector>

#include "engine/signal/angular_sampling.h"

namespace lathelier {

/// The value at any angle: that of the point that is there; a cubic through four neighbours; a line beside a gap; NaN
/// across one. Holds on to what it is given.
class ClosedInterpolation {
public:
    /// `values` in the order of the sampling's angles.
    ClosedInterpolation(const AngularSampling& sampling, const std::vector<double>& values);

    double operator()(double angle_rad) const;

private:
    std::size_t wrapped(std::ptrdiff_t i) const;
    double valueAt(std::ptrdiff_t i) const { return values_[wrapped(i)]; }
    double angleAt(std::ptrdiff_t i) const;
    bool isRegular(std::ptrdiff_t left) const;  ///< spacing fit for a cubic

    const std::vector<double>& angle_;
    const std::vector<double>& values_;
    double widest_;
};

}  // namespace lathelier
