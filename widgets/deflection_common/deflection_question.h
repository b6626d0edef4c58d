// What the panels "Deflection" and "Correction" are asked: one state of the project.
#pragma once

#include <optional>

#include "engine/deflection/turning_study.h"
#include "engine/gcode/toolpath.h"

namespace lathelier::deflection_common {

/// What differs from the set-up's file; none: as the file has it.
struct SetupChanges {
    std::optional<double> tailstock_N_mm;  ///< radial
    std::optional<double> chuck_N_mm;      ///< radial
    std::optional<double> chuck_N_mm_rad;  ///< tilting
    std::optional<double> forces_percent;  ///< of all cutting coefficients
    std::optional<double> z_zero_mm;       ///< z of the program's zero
};

struct DeflectionQuestion {
    SetupChanges changes;
    deflection::StudyParameters study;
    deflection::BandParameters band;
    deflection::MapParameters map;
    deflection::IdentificationParameters identification;
    deflection::CompensationParameters compensation;
    gcode::ToolpathParameters reading;

    DeflectionQuestion();
};

const std::vector<Field<DeflectionQuestion>>& fieldsOf(const DeflectionQuestion*);

/// The set-up with what the question changes of it.
deflection::TurningSetup changed(deflection::TurningSetup setup, const SetupChanges& changes);

/// Lines that the correction leaves as they are.
inline constexpr const char* keptLinesKey = "kept_lines";

}  // namespace lathelier::deflection_common
