// The last steps of a recognition, which a fit with another structure repeats (refit.h).
#pragma once

#include "engine/features/outline/outline.h"

namespace lathelier::features {

/// Ends of the outside from its planes, and the length; notes endConfirmed, endNotSeen, endUndecided. Before it:
/// `parameters`, `variance_ratio`. Without a length `complete` becomes false.
void describeEnds(const Outline& outline, Recognition& result);

/// Rows that marks cover get their role, and over a knurl its diameter.
void nameRoughRows(Recognition& result);

/// How well the outline fits, the order of the meridian, roles, features and suggestions (describeRows()), the shaft.
void finishRows(const Outline& outline, Recognition& result);

}  // namespace lathelier::features
