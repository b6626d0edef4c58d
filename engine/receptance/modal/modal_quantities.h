// The modes of a response, described once.
#pragma once

#include "engine/core/json.h"
#include "engine/core/quantities.h"
#include "engine/receptance/modal/response_study.h"

namespace lathelier::receptance {

/// A mode as tables show it: with uncertainties where it is that of the fit.
struct ShownMode {
    int rank = 0;                                      ///< 1: the most flexible
    ModalMode mode;                                    ///< as shown
    std::optional<double> frequency_uncertainty_hz;    ///< standard; none: changed by hand
    std::optional<double> damping_uncertainty;         ///< likewise, of ζ
    std::optional<double> stiffness_uncertainty_N_mm;  ///< likewise
    double flexibility_nm_N = 0;                       ///< least real part of this mode alone, sign reversed
};

const std::vector<QuantityOf<ShownMode>>& quantitiesOf(const ShownMode*);

/// Frequencies ascending.
std::vector<ShownMode> shownModes(const ResponseStudy& study);

/// Modes, residuals, range and error of the model; null without one.
Json toJson(const ResponseStudy& study);

}  // namespace lathelier::receptance
