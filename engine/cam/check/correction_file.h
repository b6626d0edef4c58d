// The deflection correction of a program, as radii added to the nominal contour.
#pragma once

#include <span>
#include <string>

#include "engine/cam/check/drawn_contour.h"

namespace lathelier::cam {

/// A corner of a corrected run.
struct CorrectedCorner {
    double z_mm = 0;       ///< from the free end of the clamping
    double radius_mm = 0;  ///< added to the nominal radius
};

/// Corners of all corrected runs one after the other, each run from the free end toward the chuck; straight between the
/// corners of a run. Where runs overlap, the last one counts.
StatedCorrection correctionOf(std::span<const CorrectedCorner> corners);

/// What `deflection --compensate --json` writes: `nodes` [{`z_mm`, `x_mm`, `programmed_mm`}…], in
/// the order of correctionOf(). The correction is x - programmed. Errors with line and column: malformed, keyMissing.
StatedCorrection readCorrection(const std::string& json);

}  // namespace lathelier::cam
