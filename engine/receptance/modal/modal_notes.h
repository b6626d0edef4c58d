// What a modal fit remarks about itself.
#pragma once

#include "engine/receptance/modal/modal_fit.h"

namespace lathelier::receptance {

/// Whether the fit leaves more of the response than the scatter of its lines explains.
bool leavesMore(const ModalFit& fit);

/// Adds complexModes: real modes left `real_error_percent`.
void noteComplexModes(ModalFit& fit, double real_error_percent);

/// Notes on the modes, the error and the terms beyond the range of a fit, appended to its notes.
void addNotes(ModalFit& fit, bool converged);

}  // namespace lathelier::receptance
