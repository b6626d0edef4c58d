// Is it the program, the set-up, or the work that gives way? What measured diameters along z look like.
//
// Measured errors e(z) are explained by one cause each, with one size fitted by least squares: an offset (the program
// or the tool's wear), a taper that is zero at the chuck face (the tailstock stands aside, or the headstock is out of
// line), or the predicted deflection. The cause that leaves the least is named where it leaves less than half of what
// every other one does; then all three are fitted together where there are diameters enough.
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

/// One cause alone.
struct CauseFit {
    ErrorCause cause = ErrorCause::Undecided;
    double size = 0;    ///< offset in µm; taper in µm on diameter over the length; factor on the prediction
    double rms_um = 0;  ///< what it leaves
};

struct TriageResult {
    ErrorCause cause = ErrorCause::Undecided;
    std::vector<CauseFit> alone;      ///< program, alignment, deflection
    double rms_um = 0;                ///< of the measured errors
    std::optional<double> offset_um;  ///< of all three together; none: fewer than four diameters
    std::optional<double> taper_um;   ///< at the free end, likewise
    std::optional<double> scale;      ///< on the predicted deflection, likewise
};

/// Errors: tooFewMeasured (below two), measuredOutsideCut, those of predictDeflection().
TriageResult triage(const Shaft& stock, std::span<const ToolRun> runs, const TurningSetup& setup,
                    std::span<const MeasuredDiameter> measured);

}  // namespace lathelier::deflection
