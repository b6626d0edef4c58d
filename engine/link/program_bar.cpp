#include "engine/link/program_bar.h"

#include <cmath>
#include <filesystem>

#include "engine/gcode/program.h"
#include "engine/gcode/toolpath.h"
#include "engine/io/file.h"
#include "engine/link/link_codes.h"

namespace lathelier::link {
namespace {

/// Place of a feed move that the tool is known to reach.
bool isTurned(const gcode::Move& move)
{
    return move.kind != gcode::MoveKind::Rapid && move.kind != gcode::MoveKind::Dwell && gcode::isKnown(move.x_mm) &&
           gcode::isKnown(move.z_mm);
}

void requireWhole(const gcode::Toolpath& path)
{
    const NotModelled* const gap = path.understanding.first();
    if (gap) throw Error(errors::linkProgramNotWhole, {{"line", gap->line}, {"word", gap->word}});
    for (const gcode::Diagnostic& one : path.diagnostics)
        if (one.is_error && one.error) throw Error(*one.error);
}

}  // namespace

ProgramBar barOfProgram(const std::string& path, const OfProgram& asked, const Progress& progress)
{
    try {
        const io::FileBytes file(path, progress);
        ProgramBar bar{path, io::sha256(file.view()), 0, 0, {}};
        gcode::Program program = gcode::readProgram(std::string(file.view()), nullptr, progress,
                                                    std::filesystem::path(path).filename().string());
        const gcode::Toolpath toolpath = gcode::findToolpath(program, {}, {}, progress);
        requireWhole(toolpath);
        bar.assumed = toolpath.understanding.assumed;
        double least = INFINITY;
        double greatest = -INFINITY;
        for (const gcode::Move& move : toolpath.moves) {
            if (!isTurned(move)) continue;
            bar.diameter_mm = std::fmax(bar.diameter_mm, 2 * std::fabs(move.x_mm));
            least = std::fmin(least, move.z_mm);
            greatest = std::fmax(greatest, move.z_mm);
        }
        if (!(greatest >= least) || bar.diameter_mm <= 0) throw Error(errors::linkProgramEmpty, {});
        bar.length_mm = greatest - least + asked.clearance_mm;
        return bar;
    } catch (Error& error) {
        throw error.with("path", path);
    }
}

}  // namespace lathelier::link
