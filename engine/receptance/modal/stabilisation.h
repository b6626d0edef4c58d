// Poles over the order of a fit: those of the structure stay, those of noise wander.
//
// Least squares complex frequency-domain estimator in the z-domain (LSCF; Guillaume, Verboven, Vanlanduit,
// "Frequency-domain maximum likelihood identification of modal parameters with confidence intervals", ISMA 23 (1998);
// Van der Auweraer et al., J. Dyn. Syst. Meas. Control 123 (2001) 651): a rational fraction with a common denominator
// of real coefficients, linear in them, whose normal equations are Toeplitz matrices over the lag.
#pragma once

#include <vector>

#include "engine/receptance/modal/modal_refine.h"

namespace lathelier::receptance {

inline constexpr int mostOrder = 16;  ///< pairs of poles

/// A pole of one order.
struct OrderPole {
    int order = 0;                   ///< number of pole pairs of the fit
    double frequency_hz = 0;         ///< natural frequency, within the lines
    double damping_ratio = 0;        ///< > 0
    bool is_stable = false;          ///< its frequency is within 1 % of one of the order before
    bool is_damping_stable = false;  ///< and its damping within 10 %
    friend bool operator==(const OrderPole&, const OrderPole&) = default;
};

/// Orders 1 to `mostOrder`, frequencies ascending within each. Throws Cancelled.
std::vector<OrderPole> polesByOrder(std::span<const FitLines> lines, const Progress& progress = {});

/// Poles that stay in frequency and damping over at least three successive orders: their last ones, the one that stays
/// longest first.
std::vector<Pole> stablePoles(const std::vector<OrderPole>& all);

}  // namespace lathelier::receptance
