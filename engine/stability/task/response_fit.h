// The modal fit of a response that limits or simulations are computed from; once for each response.
#pragma once

#include <memory>
#include <string>

#include "engine/core/frf.h"
#include "engine/receptance/modal/modal_fit.h"
#include "engine/task/stores.h"

namespace lathelier::stability {

/// `basis`: equal for equal responses. Errors of fitModes(). Throws Cancelled.
std::shared_ptr<const receptance::ModalFit> fitOf(const Frf& frf, const std::string& basis, Stores& stores,
                                                  const Progress& progress);

}  // namespace lathelier::stability
