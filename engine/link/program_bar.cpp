#include "engine/link/program_bar.h"

#include <cmath>
#include <filesystem>
#include <utility>

#include "engine/gcode/program.h"
#include "engine/gcode/toolpath.h"
#include "engine/io/file.h"
#include "engine/link/link_codes.h"

namespace lathelier::link {
namespace {

bool isFeed(const gcode::Move& move)
{
    return move.kind != gcode::MoveKind::Rapid && move.kind != gcode::MoveKind::Dwell;
}

bool hasPlace(const gcode::Move& move)
{
    return gcode::isKnown(move.x_mm) && gcode::isKnown(move.z_mm);
}

void requireWhole(const gcode::Toolpath& path)
{
    const NotModelled* const gap = path.understanding.first();
    if (gap) throw Error(errors::linkProgramNotWhole, {{"line", gap->line}, {"word", gap->word}});
    for (const gcode::Diagnostic& one : path.diagnostics)
        if (one.is_error && one.error) throw Error(*one.error);
    // On the machine it may have the value that another program left in it.
    for (const Assumed& one : path.understanding.assumed)
        if (one.what.starts_with('#'))
            throw Error(errors::linkProgramNotWhole, {{"line", one.line}, {"word", one.what}});
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
        // Feed across the axis may begin above the bar, in the air: that place states D only where no feed is along it.
        double begun_mm = 0;
        bool is_along = false;
        double least = INFINITY;
        double greatest = -INFINITY;
        const gcode::Move* before = nullptr;  // where a feed move begins
        for (const gcode::Move& move : toolpath.moves) {
            if (move.kind == gcode::MoveKind::Dwell) continue;
            const gcode::Move* const begin = std::exchange(before, &move);
            if (!isFeed(move)) continue;
            const bool is_across = begin && begin->z_mm == move.z_mm;
            is_along = is_along || !is_across;
            for (const gcode::Move* place : {begin, &move}) {
                if (!place || !hasPlace(*place)) continue;
                double& diameter_mm = is_across && place == begin ? begun_mm : bar.diameter_mm;
                diameter_mm = std::fmax(diameter_mm, 2 * std::fabs(place->x_mm));
                least = std::fmin(least, place->z_mm);
                greatest = std::fmax(greatest, place->z_mm);
            }
        }
        if (!is_along) bar.diameter_mm = std::fmax(bar.diameter_mm, begun_mm);
        if (!(greatest >= least) || bar.diameter_mm <= 0) throw Error(errors::linkProgramEmpty, {});
        bar.length_mm = greatest - least + asked.clearance_mm;
        return bar;
    } catch (Error& error) {
        throw error.with("path", path);
    }
}

}  // namespace lathelier::link
