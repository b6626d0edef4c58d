// Description of the modes of a response.
#pragma once

#include "engine/core/json.h"
#include "engine/core/quantities.h"
#include "engine/receptance/modal/response_study.h"

namespace lathelier::receptance {

/// A row of the table of modes, with uncertainties for fitted modes.
struct ShownMode {
    int rank = 0;  ///< 1: the most flexible
    ModalMode mode;
    std::optional<double> frequency_uncertainty_hz;       ///< standard; none: changed by hand
    std::optional<double> damping_uncertainty;            ///< standard, of ζ; none: changed by hand
    std::optional<double> stiffness_uncertainty_N_mm;     ///< standard, of k; none: changed by hand
    std::optional<double> damping_stiffness_correlation;  ///< of these errors; none: changed by hand
    double flexibility_nm_N = 0;                          ///< least real part of this mode alone, sign reversed
};

const std::vector<QuantityOf<ShownMode>>& quantitiesOf(const ShownMode*);

/// A row of the stability chart.
const std::vector<QuantityOf<OrderPole>>& quantitiesOf(const OrderPole*);

/// Frequencies ascending.
std::vector<ShownMode> shownModes(const ResponseStudy& study);

/// Modes, residuals, range, error of the model and scatter of the lines, poles by order, and where several responses
/// were fitted those of each; null without a fit.
Json toJson(const ResponseStudy& study);

}  // namespace lathelier::receptance
