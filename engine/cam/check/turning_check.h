// Any turning program against its drawing and its job: what it cuts too deep, what it leaves and why, and where the
// tool meets what it must not. The text of the program is read; nothing is known of where it came from.
//
// 1. Nose against drawing, exactly (surface_deviation.h): gouge and what is left.
// 2. Insert, holder, chuck and tailstock in the meridian plane (insert_check.h; engine/stock): findings.
// 3. A program that deflection corrected differs from the drawing on purpose: it is checked against the drawing with
// the
//    stated correction.
// 4. The second clamping is checked on the mirrored part, on the stock that the first program left.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "engine/cam/check/rest_cause.h"
#include "engine/cam/job.h"
#include "engine/core/conformity.h"
#include "engine/core/error.h"
#include "engine/core/progress.h"
#include "engine/gcode/toolpath.h"
#include "engine/stock/stock_check.h"

namespace lathelier::cam {

/// What fields of the check describe: what a person chooses.
struct CheckParameters {
    gcode::ToolpathParameters program;       ///< dialect and integer words; noses are those of the job
    int setup = 1;                           ///< 1, or 2: the part is turned round, z counts from its other end
    double z_zero_mm = 0;                    ///< z of the program's Z0 in its clamping: z = z_zero_mm - Z
    std::optional<double> finished_from_mm;  ///< what is left counts from this z; none: from the free end
    std::optional<double> finished_to_mm;    ///< what is left counts up to this z; none: up to the end
    std::optional<double> chuck_face_z_mm;   ///< none: as the job states (setup 1), not looked at (setup 2)
    bool dog_leg = true;                     ///< test the dog-leg of rapid moves too
    bool keeps_outlines = false;  ///< of the stock after each pass, not only the last; costs more than the check itself
};

const std::vector<Field<CheckParameters>>& fieldsOf(const CheckParameters*);

/// What goes with the program besides part and job.
struct CheckInputs {
    StatedCorrection correction;                   ///< of the program; none: it follows the drawing
    std::optional<std::string> before;             ///< program of the first clamping, for the second one
    std::optional<gcode::Dialect> before_dialect;  ///< of `before`; none: that of the program
};

enum class CheckKind : std::uint8_t { RapidThroughStock, HolderInStock, InsertBelowDrawing, Chuck, Tailstock };

/// "rapid_through_stock", "holder_in_stock", "insert_below_drawing", "chuck", "tailstock".
const char* key(CheckKind kind);
Text nameOf(CheckKind kind);

/// Something that a program must not do, at its deepest place. One for each move and kind.
struct CheckFinding {
    std::int64_t line = 0;                          ///< block that caused the move
    CheckKind kind = CheckKind::RapidThroughStock;  ///< what was met
    double z_mm = 0;                                ///< from the free end of the clamping
    double x_mm = 0;                                ///< radius
    double depth_mm = 0;  ///< stock: radial; drawing: normal; chuck, tailstock: the smaller extent
};

/// Material that stays on the drawing.
struct RestInterval {
    double z_start_mm = 0;               ///< from the free end of the clamping
    double z_end_mm = 0;                 ///< on a wall the same as its start
    double left_mm = 0;                  ///< largest, normal to the surface
    RestCause cause = RestCause::Uncut;  ///< why
    int tool = 0;                        ///< that comes nearest there; 0: none
    std::int64_t line = 0;  ///< of the block that comes nearest there, or of the one that should have cut; 0: none
    std::optional<double> corner_radius_mm;  ///< R of a drawn hollow arc that is sharper than the nose
    std::optional<double> nose_radius_mm;    ///< r of that tool, where its nose is the cause
};

inline constexpr double gougeLimit_mm = 0.002;  ///< a deeper one is a finding
inline constexpr double leftLimit_mm = 0.003;   ///< less is no rest: rounding leaves about 1 µm

struct CheckResult {
    CheckParameters parameters;               ///< as asked
    gcode::Program program;                   ///< as read
    gcode::Toolpath path;                     ///< its moves; with errors nothing else is there
    double gouge_um = 0;                      ///< deepest cut of the nose below the drawing
    std::optional<double> gouge_z_mm;         ///< where; none: no gouge
    std::optional<std::int64_t> gouge_line;   ///< which block; none: no gouge
    double left_max_mm = 0;                   ///< most that is left anywhere
    std::vector<RestInterval> rest;           ///< in the order of z
    std::vector<CheckFinding> findings;       ///< in the order of moves
    std::int64_t findings_not_listed = 0;     ///< beyond stock::mostFindings
    std::optional<stock::StockResult> stock;  ///< its z counts from the raw end
    double stock_zero_mm = 0;                 ///< z of the stock less z of the part
    std::optional<Verdict> verdict;           ///< fail: a finding, a gouge, or a rest; none: the program has errors;
                                              ///< undecided: a tool is not in the job, nothing else fails
    Notes notes;
};

/// Tools are taken by their T number. Errors: those of checkPart(), checkStock(), checkTools(), gcode::readProgram();
/// an error within the program is a diagnostic of `path`. Throws Cancelled.
CheckResult checkTurning(std::string text, const Shaft& part, const Job& job, const CheckParameters& parameters = {},
                         const CheckInputs& inputs = {}, const Progress& progress = {});

}  // namespace lathelier::cam
