// A modal model with the standard uncertainties of its modes: what a fit hands on to limits and simulations, alone or
// within an item of the project.
#pragma once

#include <optional>
#include <vector>

#include "engine/core/value.h"
#include "engine/receptance/modal/modal_fit.h"
#include "engine/receptance/modal/modal_model.h"
#include "engine/receptance/modal/response_study.h"

namespace lathelier::receptance {

/// Standard uncertainties (k = 1) of a mode.
struct ModeUncertainty {
    double frequency_hz = 0;
    double damping_ratio = 0;
    double stiffness_N_mm = 0;
    double correlation = 0;  ///< of the errors of damping and stiffness, -1 to 1
    friend bool operator==(const ModeUncertainty&, const ModeUncertainty&) = default;
};

/// The modes that a response consists of, with what is known of their uncertainties.
struct UncertainModel {
    ModalModel model;                    ///< without modes: the response is not known by its modes
    std::vector<ModeUncertainty> own;    ///< of model.modes, in their order; empty: not known
    std::optional<Interval> range_hz{};  ///< where the model holds; none: everywhere

    bool isKnown() const { return !model.modes.empty(); }
    friend bool operator==(const UncertainModel&, const UncertainModel&) = default;
};

/// Without residual terms within twice their standard uncertainty.
UncertainModel uncertainModelOf(const ModalFit& fit);

/// The shown model. Precondition: there is a fit. Modes changed by hand have no uncertainties.
UncertainModel uncertainModelOf(const ResponseStudy& study);

/// Adds the model to the values of a response's item, and takes it back; nothing where the item holds none, or rows
/// that are not modes.
void addModel(const UncertainModel& model, Values& item);
std::optional<UncertainModel> modelIn(const Values& item);

}  // namespace lathelier::receptance
