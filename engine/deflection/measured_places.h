// Measured places on a final contour.
#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "engine/deflection/identification.h"

namespace lathelier::deflection {

/// Interpolation of contour values at the measured positions.
class MeasuredPlaces {
public:
    /// Error measuredOutsideCut. Precondition: the contour is not empty.
    MeasuredPlaces(const FinalContour& contour, std::span<const MeasuredDiameter> measured);

    /// Linearly interpolated values of the contour.
    Eigen::VectorXd of(const std::vector<double>& values) const;

private:
    struct Place {
        std::size_t before, after;
        double share;
    };
    std::vector<Place> places_;
};

}  // namespace lathelier::deflection
