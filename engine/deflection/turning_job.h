// An NC program with stock and set-up as one job, and the corrected program.
//
// The moves of the program are those of the tool's imaginary tip, assumed to be its point of largest depth; z =
// z_zero_mm - Z. The corrected text is parsed and simulated again, so that the residual is that of the file.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "engine/core/quantities.h"
#include "engine/deflection/compensation.h"
#include "engine/gcode/toolpath.h"

namespace lathelier::deflection {

/// Program, stock and set-up.
struct TurningJob {
    gcode::Program program;
    gcode::Toolpath path;       ///< its moves; free of errors
    Shaft stock;                ///< before the first cut
    TurningSetup setup;         ///< machine, tool, material
    gcode::ToolTable tools;     ///< corner radii and tips used for the moves
    std::vector<ToolRun> runs;  ///< of the moves, filled in by turningJob()
    WorkPlan plan;              ///< stock and runs on one row of nodes, filled in by turningJob()
    Notes notes;                ///< threads, several tools, feeds per minute without a speed, another material, bores
    bool is_inch = false;       ///< the program counts inches
    std::optional<std::int64_t> bore_line;  ///< first cutting block in a bore, which is in no run; none: no such block
};

/// Moves in the coordinates of the work. Feeds per minute become feeds per revolution by the speed at the end of the
/// move; threads, dwells and moves from or to a reference point do not cut. Notes threadNotPredicted, severalTools,
/// spindleSpeedUnknown. Arcs are those of a radius: the moves do not say what their block states.
std::vector<ToolMove> toolMoves(const gcode::Toolpath& path, const TurningSetup& setup, Notes& notes);

/// Errors: those of workPlan(); notModelled (`line`) for a program that cuts in bores alone. Precondition: `path` has
/// no errors.
TurningJob turningJob(gcode::Program program, gcode::Toolpath path, Shaft stock, TurningSetup setup,
                      gcode::ToolTable tools = {});

/// predictDeflection() with the notes of the job.
DeflectionResult predictJob(const TurningJob& job, const Progress& progress = {});

/// One changed or added block of the corrected program with the reason.
struct ProgramChange {
    std::int64_t line = 0;              ///< of the original block; of an added one: the block that it follows
    std::optional<std::string> before;  ///< text of the block; none: added
    std::string after;                  ///< text of the block
    Text reason;                        ///< pattern; {name} is replaced by the named value
    Values values;                      ///< z_mm, correction_um, dx_um, dy_um, F_t_N, F_ap_N, stiffness_N_mm
};

/// The reason in English.
std::string reasonOf(const ProgramChange& change);

/// A corrected program.
struct CorrectedProgram {
    CompensationResult compensation;  ///< counts, residual and robustness are those of `text`
    std::string text;                 ///< the whole program; bytes of unchanged blocks as they were
    std::vector<ProgramChange> changes;
    std::vector<gcode::Move> moves;  ///< of `text`
};

/// Only X words and those of the centres and radii of arcs change, on the grid of the program (0.001 mm of diameter,
/// 0.0001 in), and blocks are divided where a corner is needed. Blocks behind a changed one that state no X, or count
/// from it, get their original X. Errors: those of compensate(); notModelled (`line`) for passes in a bore;
/// ncBlockNotRewritable (line, block, word, reason) under nose radius compensation, in a contour of G70-G73, in blocks
/// executed more than once, for a block of a corrected pass with a word that may shape it. Throws Cancelled.
CorrectedProgram correctProgram(const TurningJob& job, const CompensationParameters& parameters = {},
                                const Progress& progress = {});

const std::vector<QuantityOf<ProgramChange>>& quantitiesOf(const ProgramChange*);
const std::vector<QuantityOf<CorrectedProgram>>& quantitiesOf(const CorrectedProgram*);

}  // namespace lathelier::deflection
