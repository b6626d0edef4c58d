// Check of any turning program against drawing and job: gouges, residual material with its cause, collisions. Only the
// program text is used, not how it was generated.
//
// 1. Nose against drawing, exactly (surface_deviation.h): gouge and residual material.
// 2. Insert, holder, chuck and tailstock in the meridian plane (insert_check.h; engine/stock): findings.
// 3. A program that deflection corrected differs from the drawing on purpose: it is checked against the drawing with
// the
//    stated correction.
// 4. The second clamping is checked on the mirrored part, on the stock that the first program left.
// 5. What turning the outside does not make (drawn_features.h) is not looked at: it is listed, and nothing is "as
// drawn" while there is any.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "engine/cam/check/rest_cause.h"
#include "engine/cam/drawn_features.h"
#include "engine/cam/job.h"
#include "engine/core/conformity.h"
#include "engine/core/error.h"
#include "engine/core/progress.h"
#include "engine/gcode/toolpath.h"
#include "engine/stock/stock_check.h"

namespace lathelier::cam {

/// User parameters of the check.
struct CheckParameters {
    gcode::ToolpathParameters program;  ///< dialect and integer words; corners and tips are those of the job
    int setup = 1;                      ///< 1, or 2: the part is turned round, z counts from its other end
    double z_zero_mm = 0;               ///< z of the program's Z0 in its clamping: z = z_zero_mm - Z
    std::optional<double>
        finished_from_mm;  ///< start of the interval evaluated for residual material; none: the free end
    std::optional<double> finished_to_mm;   ///< end of that interval; none: end of the part
    std::optional<double> chuck_face_z_mm;  ///< none: that of the job (setup 1), not checked (setup 2)
    std::optional<double> work_length_mm;   ///< workLength_mm() of setup 2; none: as program or job state it
    bool dog_leg = true;                    ///< test the dog-leg of rapid moves too
    bool keeps_outlines =
        false;  ///< stores the stock outline after each pass, not only the last; costs more than the check itself
};

const std::vector<Field<CheckParameters>>& fieldsOf(const CheckParameters*);

/// Further inputs besides program, part and job.
struct CheckInputs {
    gcode::StatedCorrection correction;               ///< intended offset of the program; empty: none
    std::optional<std::string> before;                ///< program of the first clamping, for the second one
    std::optional<gcode::ControlPtr> before_control;  ///< of `before`, nullptr: from its text; none: as the program
};

enum class CheckKind : std::uint8_t {
    RapidThroughStock,
    HolderInStock,
    InsertBelowDrawing,
    Chuck,
    Tailstock,
    StandingEnd  ///< of the second clamping: the end beyond the part is still there
};

/// "rapid_through_stock", "holder_in_stock", "insert_below_drawing", "chuck", "tailstock", "standing_end".
const char* key(CheckKind kind);
Text nameOf(CheckKind kind);

/// A collision or gouge at the point of its largest depth. One per move and kind.
struct CheckFinding {
    std::int64_t line = 0;  ///< block that caused the move
    CheckKind kind = CheckKind::RapidThroughStock;
    double z_mm = 0;      ///< from the free end of the clamping
    double x_mm = 0;      ///< radius
    double depth_mm = 0;  ///< stock: radial; drawing: normal; chuck, tailstock: the smaller extent; end: its length
};

/// Interval of the contour with residual material.
struct RestInterval {
    double z_start_mm = 0;  ///< from the free end of the clamping
    double z_end_mm = 0;    ///< equal to z_start_mm on a wall
    double left_mm = 0;     ///< largest, normal to the surface
    RestCause cause = RestCause::Uncut;
    int tool = 0;                            ///< nearest tool; 0: none
    std::int64_t line = 0;                   ///< nearest block, or the one that should have cut there; 0: none
    std::optional<double> corner_radius_mm;  ///< R of a concave arc of the drawing that is smaller than the nose radius
    std::optional<double> nose_radius_mm;    ///< r of that tool, where its nose is the cause
};

inline constexpr double gougeLimit_mm = 0.002;  ///< deeper gouges are findings
inline constexpr double leftLimit_mm =
    0.003;  ///< smaller residuals are ignored: rounding of coordinates leaves about 1 µm

struct CheckResult {
    CheckParameters parameters;
    gcode::Program program;
    gcode::Toolpath path;                     ///< its moves; if it has errors, all other results are empty
    double gouge_um = 0;                      ///< deepest gouge of the nose
    std::optional<double> gouge_z_mm;         ///< z of the deepest gouge; none: no gouge
    std::optional<std::int64_t> gouge_line;   ///< line of its block; none: no gouge
    double left_max_mm = 0;                   ///< largest residual
    std::vector<RestInterval> rest;           ///< in the order of z
    std::vector<CheckFinding> findings;       ///< in the order of moves
    std::int64_t findings_not_listed = 0;     ///< beyond stock::mostFindings
    std::optional<stock::StockResult> stock;  ///< its z counts from the raw end
    double stock_zero_mm = 0;                 ///< z of the stock less z of the part
    std::vector<DrawnFeature> not_checked;    ///< drawn, but not looked at
    std::optional<Verdict> verdict;           ///< fail: a finding, a gouge, or a rest; none: the program has errors;
                                              ///< undecided, without another failure: a tool is missing in the job, or
                                              ///< something drawn is not looked at
    Understanding before_understanding;       ///< of the program that ran in the first clamping
    Notes notes;
};

/// Tools are identified by their T number. Errors: those of checkPart(), checkStock(), checkTools(),
/// gcode::readProgram(); an error within the program is a diagnostic of `path`. Throws Cancelled.
CheckResult checkTurning(std::string text, const Shaft& part, const Job& job, const CheckParameters& parameters = {},
                         const CheckInputs& inputs = {}, const Progress& progress = {});

}  // namespace lathelier::cam
