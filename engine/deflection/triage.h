// Cause of measured diameter errors along z: program, alignment, or deflection.
//
// Measured errors e(z) are explained by one cause each, with one parameter fitted by least squares: an offset (the
// program or the tool's wear), a taper that is zero at the chuck face (misaligned tailstock or headstock), or the
// predicted deflection. The cause with the smallest residual is reported if its residual is less than half of every
// other one. All three are fitted together if there are enough diameters.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "engine/deflection/identification.h"

namespace lathelier::deflection {

enum class ErrorCause { Program, Alignment, Deflection, Undecided };

/// "program", "alignment", "deflection", "undecided".
const char* key(ErrorCause cause);
Text nameOf(ErrorCause cause);

/// Fit of one cause alone.
struct CauseFit {
    ErrorCause cause = ErrorCause::Undecided;
    double size = 0;    ///< offset in µm; taper in µm on diameter over the length; factor on the prediction
    double rms_um = 0;  ///< residual
};

struct TriageResult {
    ErrorCause cause = ErrorCause::Undecided;
    std::vector<CauseFit> alone;      ///< program, alignment, deflection
    double rms_um = 0;                ///< of the measured errors
    std::optional<double> offset_um;  ///< of all three together; none: fewer than four diameters
    std::optional<double> taper_um;   ///< at the free end; none as for offset_um
    std::optional<double> scale;      ///< factor on the predicted deflection; none as for offset_um
};

/// Errors: tooFewMeasured (below two), measuredOutsideCut, those of predictDeflection().
TriageResult triage(const Shaft& stock, std::span<const ToolRun> runs, const TurningSetup& setup,
                    std::span<const MeasuredDiameter> measured);

}  // namespace lathelier::deflection
