// The modes of a response in its item of the project, for tasks that take modes with their uncertainties.
#pragma once

#include <vector>

#include "engine/core/value.h"
#include "engine/receptance/modal/modal_fit.h"

namespace lathelier::receptance {

/// Adds the rows "modes" to the values of an item: frequency, damping, stiffness, phase, their standard uncertainties
/// and the correlation of damping and stiffness.
void addModes(Values& values, const std::vector<FittedMode>& modes);

/// The same back; empty where the item has none, or rows that are no modes.
std::vector<FittedMode> modesOf(const Values& values);

}  // namespace lathelier::receptance
