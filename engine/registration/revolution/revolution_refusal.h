// What is said of points that are no body of revolution, or hardly one.
#pragma once

#include "engine/core/error.h"
#include "engine/registration/revolution/revolution_axis.h"

namespace lathelier::registration {

/// Throws coverageTooSmall or notABodyOfRevolution with `reason` for scripts and `why` for people. `role`: "reference",
/// "copy", "scan".
[[noreturn]] void refuseRevolution(const RevolutionFit& fit, const char* role);

/// What the fit says whatever is done with it: a line of noise is degenerate (error pointsDegenerate), a bend and a
/// small arc are noted.
void remarkRevolution(const RevolutionFit& fit, const char* role, Notes& notes);

/// Turns the frame so that z runs toward the larger coordinate on the axis' dominant one.
void faceForward(RevolutionFit& fit);

}  // namespace lathelier::registration
