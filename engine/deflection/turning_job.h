// An NC program with stock and set-up as one job.
//
// The moves of the program are those of the tool's imaginary tip, assumed to be its point of largest depth; z =
// z_zero_mm - Z.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

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

/// Runs that generate an outside diameter, and the first cutting block in a bore.
struct TurningRuns {
    std::vector<ToolRun> runs;  ///< not facing and parting off, which end at or beyond the axis
    std::optional<std::int64_t> bore_line;
};
TurningRuns turningRuns(const gcode::Program& program, const gcode::Toolpath& path, const Shaft& stock,
                        const TurningSetup& setup, Notes& notes);

/// Error notModelled (`line`): a pass in a bore.
[[noreturn]] void refuseBore(std::int64_t line);

/// predictDeflection() with the notes of the job.
DeflectionResult predictJob(const TurningJob& job, const Progress& progress = {});

}  // namespace lathelier::deflection
