// How points are spread over the turn: order, spacing, gaps, weights.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace lathelier::signal {

/// Points sorted by angle, and what their spacing is like.
struct AngularSampling {
    std::vector<std::size_t> order;  ///< of the given points by angle; equal angles keep their order
    std::vector<double> angle_rad;   ///< in that order, ascending, in [first, first + 2π)
    std::vector<double> weight;      ///< share of the turn each point stands for; gaps count no more than
                                     ///< 1.5 median spacings on each side, so the sum may be below 1
    std::size_t different = 0;       ///< number of different angles
    double largest_gap_rad = 0;      ///< largest spacing of neighbouring angles
    double median_spacing_rad = 0;   ///< median spacing of neighbouring angles
    double largest_regular_rad = 0;  ///< largest spacing that is no gap
    double missing_rad = 0;          ///< what the gaps leave out in all
    std::size_t gaps = 0;            ///< spacings above gapFactor medians
    bool uniform = false;            ///< evenly spaced to a millionth of the spacing
    double displacement = 0;         ///< largest distance of a different angle from its place among evenly spaced ones,
                                     ///< in their spacing; 0 when uniform

    static constexpr double gapFactor = 5;
    static constexpr double nearlyEven = 0.15;  ///< displacement up to which all orders of even spacing are carried
};

/// Angles of any range and order, at least one.
AngularSampling sampleAngles(std::span<const double> angle_rad);

/// Orders (UPR) of a trigonometric polynomial that a sampling carries.
struct CarriedOrders {
    int determined = 0;  ///< determined everywhere: a least-squares fit is well conditioned up to here
    int estimated = 0;  ///< carried but for gaps, which let a share `leakage` of other orders in. As `determined` where
                        ///< gaps are too large; one more for an even number of nearly even angles (n/2)
    double leakage = 0;  ///< missing share of the turn over the share that is there
};

/// Displacements up to `nearlyEven` (Kadec's bound is 1/4) carry as many orders as even spacing; else the half wave
/// has to be longer than the largest spacing by a tenth (Groechenig, Math. Comp. 59 (1992) 181-194).
CarriedOrders carriedOrders(const AngularSampling& sampling);

/// `values` in the order of the sampling.
std::vector<double> inOrder(const AngularSampling& sampling, std::span<const double> values);

}  // namespace lathelier::signal
