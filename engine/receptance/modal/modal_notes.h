// What a modal fit remarks about itself.
#pragma once

#include "engine/receptance/modal/modal_fit.h"

namespace lathelier::receptance {

/// Notes on the modes, the error and the terms beyond the range of a fit, appended to its notes.
void addNotes(ModalFit& fit, bool converged);

}  // namespace lathelier::receptance
