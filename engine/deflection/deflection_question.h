// Question of the task deflection: changes of the set-up, what is computed, how the program is read. The panels
// Program, Deflection and Correction share its state in the project.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/core/library.h"
#include "engine/deflection/turning_study.h"
#include "engine/gcode/program_draft.h"
#include "engine/gcode/toolpath.h"

namespace lathelier::deflection {

/// Changes of the set-up file; none: value of the file. Numbers have precedence over library entries.
struct SetupChanges {
    std::string material = statedChoice;         ///< key of the library: elastic constants alone
    std::string machine = statedChoice;          ///< key of the library: springs of the chuck
    std::string insert = statedChoice;           ///< key of the library: lead angle, corner radius, tip angle
    std::optional<double> corner_radius_mm;      ///< corner radius of the insert
    std::optional<double> lead_angle_deg;        ///< lead angle of the insert
    std::optional<double> tailstock_N_mm;        ///< radial stiffness of the tailstock
    std::optional<double> chuck_N_mm;            ///< radial stiffness of the chuck
    std::optional<double> chuck_N_mm_rad;        ///< rotational stiffness of the chuck
    std::optional<double> forces_percent;        ///< scale of all cutting coefficients
    std::optional<double> z_zero_mm;             ///< z of the program's zero
    std::vector<SteadyRest> steady_rests;        ///< replace those of the file; empty: those of the file
    std::optional<double> follower_N_mm;         ///< stiffness of the follower rest; 0: none
    std::optional<double> follower_offset_mm;    ///< distance from the tool toward the chuck
    std::optional<double> post_radial_N_mm;      ///< stiffness of tool, turret and slide; 0: rigid
    std::optional<double> post_tangential_N_mm;  ///< stiffness of tool, turret and slide; 0: rigid
};

struct DeflectionQuestion {
    SetupChanges changes;
    StudyParameters study;
    BandParameters band;
    MapParameters map;
    IdentificationParameters identification;
    CompensationParameters compensation;
    gcode::ToolpathParameters reading;
    std::vector<gcode::ProgramDraft> drafts;  ///< edited texts used instead of program files
};

/// The details of studyTurning().
StudyDetails detailsOf(const DeflectionQuestion& question);

const std::vector<Field<SetupChanges>>& fieldsOf(const SetupChanges*);
/// Those of all members; first what is asked most. Drafts are kept by a window.
const std::vector<Field<DeflectionQuestion>>& fieldsOf(const DeflectionQuestion*);

/// The set-up with the changes of the question. Notes: materialOfLibrary, machineOfLibrary, insertOfLibrary.
TurningSetup changed(TurningSetup setup, const SetupChanges& changes, Notes& notes);

/// Lines excluded from the correction.
inline constexpr const char* keptLinesKey = "kept_lines";

}  // namespace lathelier::deflection
