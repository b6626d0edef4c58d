// Question of the panels Deflection and Correction: their common state in the project.
#pragma once

#include <optional>
#include <vector>

#include "engine/deflection/turning_study.h"
#include "engine/gcode/toolpath.h"
#include "widgets/chatter_common/libraries.h"
#include "widgets/deflection_common/program_draft.h"

namespace lathelier::deflection_common {

/// Changes of the set-up file; none: value of the file. Numbers have precedence over library entries.
struct SetupChanges {
    chatter_common::MaterialChoice material{};         ///< elastic constants only; the cutting coefficients are kept
    chatter_common::MachineChoice machine{};           ///< springs of the chuck
    chatter_common::InsertChoice insert{};             ///< lead angle, corner radius, tip angle
    std::optional<double> corner_radius_mm;            ///< corner radius of the insert
    std::optional<double> lead_angle_deg;              ///< lead angle of the insert
    std::optional<double> tailstock_N_mm;              ///< radial stiffness of the tailstock
    std::optional<double> chuck_N_mm;                  ///< radial stiffness of the chuck
    std::optional<double> chuck_N_mm_rad;              ///< rotational stiffness of the chuck
    std::optional<double> forces_percent;              ///< scale of all cutting coefficients
    std::optional<double> z_zero_mm;                   ///< z of the program's zero
    std::vector<deflection::SteadyRest> steady_rests;  ///< replace those of the file; empty: those of the file
    std::optional<double> follower_N_mm;               ///< stiffness of the follower rest; 0: none
    std::optional<double> follower_offset_mm;          ///< distance from the tool toward the chuck
    std::optional<double> post_radial_N_mm;            ///< stiffness of tool, turret and slide; 0: rigid
    std::optional<double> post_tangential_N_mm;        ///< stiffness of tool, turret and slide; 0: rigid
};

struct DeflectionQuestion {
    SetupChanges changes;
    deflection::StudyParameters study;
    deflection::BandParameters band;
    deflection::MapParameters map;
    deflection::IdentificationParameters identification;
    deflection::CompensationParameters compensation;
    gcode::ToolpathParameters reading;
    std::vector<ProgramDraft> drafts;  ///< edited texts used instead of program files

    DeflectionQuestion();
};

const std::vector<Field<DeflectionQuestion>>& fieldsOf(const DeflectionQuestion*);

/// The set-up with the changes of the question. Notes: materialOfLibrary, machineOfLibrary, insertOfLibrary.
deflection::TurningSetup changed(deflection::TurningSetup setup, const SetupChanges& changes, Notes& notes);

/// Lines excluded from the correction.
inline constexpr const char* keptLinesKey = "kept_lines";

}  // namespace lathelier::deflection_common
