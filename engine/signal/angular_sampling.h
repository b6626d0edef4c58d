// Distribution of points over the revolution: order, spacing, gaps, weights.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace lathelier::signal {

/// Points sorted by angle, with the properties of their spacing.
struct AngularSampling {
    std::vector<std::size_t> order;  ///< indices of the input points sorted by angle (stable)
    std::vector<double> angle_rad;   ///< sorted angles, ascending, in [first, first + 2π)
    std::vector<double> weight;  ///< share of the revolution represented by each point, at most 1.5 median spacings on
                                 ///< each side, so that the sum may be below 1 with gaps
    std::size_t different = 0;   ///< number of different angles
    double largest_gap_rad = 0;  ///< largest spacing of neighbouring angles
    double median_spacing_rad = 0;   ///< median spacing of neighbouring angles
    double largest_regular_rad = 0;  ///< largest spacing that is not a gap
    double missing_rad = 0;          ///< total missing angle of the gaps
    std::size_t gaps = 0;            ///< spacings above gapFactor medians
    bool uniform = false;            ///< evenly spaced to a millionth of the spacing
    double displacement = 0;  ///< largest distance of a distinct angle from evenly spaced ones, in their spacing; 0
                              ///< when uniform

    static constexpr double gapFactor = 5;
    static constexpr double nearlyEven = 0.15;  ///< displacement up to which all orders of even spacing are determined
};

/// Angles of any range and order, at least one.
AngularSampling sampleAngles(std::span<const double> angle_rad);

/// Orders (UPR) of a trigonometric polynomial that a sampling determines.
struct CarriedOrders {
    int determined = 0;  ///< largest order of a well-conditioned least-squares fit
    int estimated = 0;  ///< largest order that can be estimated despite gaps, with a share `leakage` from other orders.
                        ///< Equal to `determined` where gaps are too large; one more for an even number of nearly even
                        ///< angles (n/2)
    double leakage = 0;  ///< missing over present share of the revolution
};

/// Displacements up to `nearlyEven` (Kadec's bound is 1/4) determine as many orders as even spacing; otherwise half the
/// wavelength must exceed the largest spacing by a tenth (Groechenig, Math. Comp. 59 (1992) 181-194).
CarriedOrders carriedOrders(const AngularSampling& sampling);

/// `values` in the order of the sampling.
std::vector<double> inOrder(const AngularSampling& sampling, std::span<const double> values);

}  // namespace lathelier::signal
