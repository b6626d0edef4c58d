// What the panels "Deflection" and "Correction" are asked: one state of the project.
#pragma once

#include <optional>
#include <vector>

#include "engine/deflection/turning_study.h"
#include "engine/gcode/toolpath.h"
#include "widgets/chatter_common/libraries.h"
#include "widgets/deflection_common/program_draft.h"

namespace lathelier::deflection_common {

/// What differs from the set-up's file; none: as the file has it. Numbers rule over what is taken from a library.
struct SetupChanges {
    chatter_common::MaterialChoice material{};         ///< elastic part; the cutting coefficients stay
    chatter_common::MachineChoice machine{};           ///< the springs of its chuck
    chatter_common::InsertChoice insert{};             ///< lead angle, corner radius, tip angle
    std::optional<double> corner_radius_mm;            ///< of the insert
    std::optional<double> lead_angle_deg;              ///< of the insert
    std::optional<double> tailstock_N_mm;              ///< radial
    std::optional<double> chuck_N_mm;                  ///< radial
    std::optional<double> chuck_N_mm_rad;              ///< tilting
    std::optional<double> forces_percent;              ///< of all cutting coefficients
    std::optional<double> z_zero_mm;                   ///< z of the program's zero
    std::vector<deflection::SteadyRest> steady_rests;  ///< instead of those in the file; empty: those in the file
    std::optional<double> follower_N_mm;               ///< of a rest that moves with the tool; 0: without one
    std::optional<double> follower_offset_mm;          ///< from the tool toward the chuck
    std::optional<double> post_radial_N_mm;            ///< of tool, turret and slide; 0: rigid
    std::optional<double> post_tangential_N_mm;        ///< of tool, turret and slide; 0: rigid
};

struct DeflectionQuestion {
    SetupChanges changes;
    deflection::StudyParameters study;
    deflection::BandParameters band;
    deflection::MapParameters map;
    deflection::IdentificationParameters identification;
    deflection::CompensationParameters compensation;
    gcode::ToolpathParameters reading;
    std::vector<ProgramDraft> drafts;  ///< what stands in for files of programs

    DeflectionQuestion();
};

const std::vector<Field<DeflectionQuestion>>& fieldsOf(const DeflectionQuestion*);

/// The set-up with what the question changes of it. Notes: materialOfLibrary, machineOfLibrary, insertOfLibrary.
deflection::TurningSetup changed(deflection::TurningSetup setup, const SetupChanges& changes, Notes& notes);

/// Lines that the correction leaves as they are.
inline constexpr const char* keptLinesKey = "kept_lines";

}  // namespace lathelier::deflection_common
