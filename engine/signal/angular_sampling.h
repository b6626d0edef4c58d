// How points are spread over the turn: order, spacing, gaps, weights.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace lathelier {

/// Points sorted by angle, and what their spacing is like.
struct AngularSampling {
    std::vector<std::size_t> order;  ///< of the given points by angle; equal angles keep their order
    std::vector<double> angle_rad;   ///< in that order, ascending, in [first, first + 2π)
    std::vector<double> weight;      ///< share of the turn each point stands for; gaps count no more than
                                     ///< 1.5 median spacings on each side, so the sum may be below 1
    std::size_t different = 0;       ///< number of different angles
    double largest_gap_rad = 0;
    double median_spacing_rad = 0;
    std::size_t gaps = 0;  ///< spacings above gapFactor medians
    bool uniform = false;  ///< evenly spaced to a millionth of the spacing

    static constexpr double gapFactor = 5;
};

/// Angles of any range and order, at least one.
AngularSampling sampleAngles(std::span<const double> angle_rad);

/// `values` in the order of the sampling.
std::vector<double> inOrder(const AngularSampling& sampling, std::span<const double> values);

}  // namespace lathelier
