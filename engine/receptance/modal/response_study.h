// A measured response with the computed one and its modal model: the content of the panel FRF.
#pragma once

#include <optional>
#include <string>

#include "engine/receptance/modal/modal_fit.h"

namespace lathelier::receptance {

/// One of several responses fitted with common poles.
struct CommonFit {
    std::string name;                     ///< its nodes, "12/5" (response/force), else its number
    std::shared_ptr<const ModalFit> fit;  ///< with its stiffnesses and residuals
};

struct ResponseStudy {
    FrfPtr measured;                      ///< receptance; null: none was measured
    FrfPtr computed;                      ///< receptance of the shaft on its spindle; null: not asked for
    std::shared_ptr<const ModalFit> fit;  ///< of the measured response, else of the computed one; null: not asked for
    std::vector<CommonFit> common;        ///< fits of all responses of the file with common poles; empty: of one
    ModalModel model;                     ///< shown model: the fitted one, or with modes edited by hand
    bool is_changed = false;              ///< true: the modes were edited by hand
    Frf synthesised;                      ///< receptance of `model` on the lines of the fit; empty without a fit
    std::vector<double> error_percent;    ///< 100 · |G_model - G| / |G| by line
    double error_rms_percent = 0;         ///< 100 · rms|G_model - G| / rms|G| over those of these lines that stand
                                          ///< out of the noise

    /// The fitted response.
    const Frf* basis() const { return measured ? measured.get() : computed.get(); }
};

/// Model, synthesised response and errors of a study that has its responses and its fit. `changed`: modes replacing
/// those of the fit; terms beyond the range and residuals are kept. Empty: the fitted modes.
void completeStudy(ResponseStudy& study, const std::vector<ModalMode>& changed = {});

/// A study of these, completed.
ResponseStudy studyResponse(FrfPtr measured, FrfPtr computed, std::shared_ptr<const ModalFit> fit,
                            const std::vector<ModalMode>& changed = {});

/// Mode `index` so that the model's magnitude at `frequency_hz`, its new natural frequency, is `magnitude_mm_N`: the
/// damping is adapted, stiffness and phase are kept.
ModalMode draggedMode(const ModalModel& model, std::size_t index, double frequency_hz, double magnitude_mm_N);

/// Indices of the modes by flexibility (least real part), the most flexible first.
std::vector<std::size_t> byFlexibility(const std::vector<ModalMode>& modes);

}  // namespace lathelier::receptance
