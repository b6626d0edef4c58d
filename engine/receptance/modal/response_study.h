// A measured response beside the computed one and its modal model: what the panel FRF shows and reports.
#pragma once

#include <optional>

#include "engine/receptance/modal/modal_fit.h"

namespace lathelier::receptance {

struct ResponseStudy {
    FrfPtr measured;                      ///< receptance; null: none was measured
    FrfPtr computed;                      ///< receptance of the shaft on its spindle; null: not asked for
    std::shared_ptr<const ModalFit> fit;  ///< of the measured response, else of the computed one; null: not asked for
    ModalModel model;                     ///< what is shown: that of the fit, or its modes changed by hand
    bool is_changed = false;              ///< the modes were changed by hand
    Frf synthesised;                      ///< of `model` on the lines of the fit; empty without a fit
    std::vector<double> error_percent;    ///< 100 · |G_model - G| / |G| on these lines
    double error_rms_percent = 0;         ///< 100 · rms|G_model - G| / rms|G| over them

    /// The response that the fit is of.
    const Frf* basis() const { return measured ? measured.get() : computed.get(); }
};

/// `changed`: modes in place of those of the fit; what lies beyond the range and the residuals stay. Empty: the fit's.
ResponseStudy studyResponse(FrfPtr measured, FrfPtr computed, std::shared_ptr<const ModalFit> fit,
                            const std::vector<ModalMode>& changed = {});

/// Mode `index` so that the model's magnitude at `frequency_hz`, its new natural frequency, is `magnitude_mm_N`: the
/// damping follows, stiffness and phase stay.
ModalMode draggedMode(const ModalModel& model, std::size_t index, double frequency_hz, double magnitude_mm_N);

/// Indices of the modes, the most flexible one (with the least real part of its own) first.
std::vector<std::size_t> byFlexibility(const std::vector<ModalMode>& modes);

}  // namespace lathelier::receptance
