// Errors and notes for points that are not, or barely, a body of revolution.
#pragma once

#include "engine/core/error.h"
#include "engine/registration/revolution/revolution_axis.h"

namespace lathelier::registration {

/// Throws coverageTooSmall or notABodyOfRevolution with `reason` for scripts and `why` for people. `role`: "reference",
/// "copy", "scan".
[[noreturn]] void refuseRevolution(const RevolutionFit& fit, const char* role);

/// Checks for every use of a fit: a line of noise is the error pointsDegenerate; a bend and a coverage below 180° are
/// noted.
void remarkRevolution(const RevolutionFit& fit, const char* role, Notes& notes);

/// Turns the frame so that z runs toward the larger coordinate on the axis' dominant one.
void orientAxis(RevolutionFit& fit);

}  // namespace lathelier::registration
