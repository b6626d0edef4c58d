// What later steps of a chain take from the result of a step. It is read from the result as it was written (ID.json),
// so that a step that is reused hands on the same as one that ran.
#pragma once

#include <optional>
#include <vector>

#include "engine/core/json.h"

namespace lathelier::chain {

/// A stretch of the finish with one speed.
struct PlannedSection {
    double z_start_mm = 0, z_end_mm = 0;  ///< from the free end
    double diameter_mm = 0;
    double speed_rpm = 0;
};

/// Of the step program; without a result no clampings.
struct PlannedProgram {
    std::size_t clampings = 0;
    std::vector<PlannedSection> sections;  ///< those with a fixed speed
};

PlannedProgram plannedProgram(const Json& result);

/// Chatter frequency at the limiting depth at this speed, from the step speeds; none: outside the chart.
std::optional<double> chatterFrequencyAt(const Json& result, double speed_rpm);

/// Whether the step deflection wrote a corrected program.
bool hasCorrection(const Json& result);

/// Chatter marks of the first photograph.
struct ChatterMarks {
    double frequency_hz = 0;
    double uncertainty_hz = 0;  ///< standard
};

/// Of the step surface; none: no chatter marks were found.
std::optional<ChatterMarks> chatterMarks(const Json& result);

}  // namespace lathelier::chain
