// Where along the axis the points change from one wall to the next.
#pragma once

#include <optional>
#include <vector>

#include "engine/features/outline/edges.h"

namespace lathelier::features {

/// Log-likelihood ratio L of one point: on the wall behind against on the wall before an edge at z_e. A ray at z is
/// read anywhere within its spot of width s and shows the wall behind with the probability P = clamp((z - z_e)/s + ½,
/// 0, 1); the likelihood of z_e is the product of P·exp(L) + 1 - P. Its posterior mean and standard deviation with a
/// uniform prior over the stretch minimise the mean square error of a change point (Ibragimov and Has'minskii 1981,
/// VII).
struct LogLikelihoodRatio {
    double z_mm, log_ratio;
};

/// Nothing with few points. `spot_mm`: width of the spot.
std::optional<PlanePlace> placeOfChange(std::vector<LogLikelihoodRatio> points, double from_mm, double to_mm,
                                        double spot_mm);

}  // namespace lathelier::features
