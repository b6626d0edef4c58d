#include "engine/deflection/turning_job.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "engine/core/core_codes.h"
#include "engine/core/texts.h"
#include "engine/core/units.h"
#include "engine/deflection/bore_passes.h"
#include "engine/deflection/deflection_codes.h"
#include "engine/deflection/deflection_quantities.h"
#include "engine/gcode/gcode_codes.h"

namespace lathelier::deflection {
namespace {

constexpr double mm_per_m = 1000;
/// In 1/min; NaN: no speed stated.
double speedOf(const gcode::Move& move)
{
    double speed = move.speed_rpm;
    if (gcode::isKnown(move.cutting_speed_m_min)) {
        speed = mm_per_m * move.cutting_speed_m_min / (2 * std::numbers::pi * std::abs(move.x_mm));
        if (gcode::isKnown(move.speed_limit_rpm)) speed = std::min(speed, move.speed_limit_rpm);
    }
    return speed;
}

/// In mm per revolution; 0: not stated.
double feedOf(const gcode::Move& move)
{
    if (gcode::isKnown(move.feed_mm_rev)) return move.feed_mm_rev;
    const double feed = move.feed_mm_min / speedOf(move);
    return std::isfinite(feed) ? feed : 0;
}

/// Builds the list of moves and notes on them.
class MoveMaker {
public:
    MoveMaker(const TurningSetup& setup, Notes& notes) : zZero_mm_(setup.z_zero_mm), notes_(notes) {}

    void add(const gcode::Move& move)
    {
        if (move.kind == gcode::MoveKind::Dwell) return;
        if (!gcode::isKnown(gcode::Point{move.x_mm, move.z_mm})) {
            isKnown_ = false;
            return;
        }
        const bool cuts = isKnown_ && (move.kind == gcode::MoveKind::Feed || move.kind == gcode::MoveKind::Arc);
        isKnown_ = true;
        ToolMove made{zZero_mm_ - move.z_mm, move.x_mm, cuts, 0, move.line, {}};
        if (move.kind == gcode::MoveKind::Thread && !contains(notes_, notes::threadNotPredicted))
            notes_.push_back({notes::threadNotPredicted, {{"line", move.line}}});
        if (cuts) {
            tools_.insert(move.tool);
            made.feed_mm_rev = feedOf(move);
            if (made.feed_mm_rev <= 0 && gcode::isKnown(move.feed_mm_min) &&
                !contains(notes_, notes::spindleSpeedUnknown))
                notes_.push_back({notes::spindleSpeedUnknown, {{"line", move.line}}});
            // The sense of rotation is reversed, as z points opposite to Z.
            if (move.kind == gcode::MoveKind::Arc)
                made.arc = ArcCentre{zZero_mm_ - move.centre_z_mm, move.centre_x_mm, !move.clockwise};
        }
        moves_.push_back(made);
    }

    std::vector<ToolMove> take()
    {
        if (tools_.size() > 1)
            notes_.push_back({notes::severalTools, {{"count", static_cast<std::int64_t>(tools_.size())}}});
        return std::move(moves_);
    }

private:
    double zZero_mm_;
    Notes& notes_;
    bool isKnown_ = false;
    std::set<int> tools_;
    std::vector<ToolMove> moves_;
};

/// The set-up's material is the one of the cutting coefficients; a stock of another material may be the wrong file.
void noteOtherMaterial(const Shaft& stock, const TurningSetup& setup, Notes& list)
{
    if (!stock.material) return;
    constexpr double same = 0.001;
    const double stated_MPa = stock.material->elastic_modulus_MPa;
    const double used_MPa = setup.material.elastic.elastic_modulus_MPa;
    if (std::abs(stated_MPa - used_MPa) > same * used_MPa)
        list.push_back({notes::materialOfSetup, {{"stock_MPa", stated_MPa}, {"setup_MPa", used_MPa}}});
}

/// Removes the parts of a run at or beyond the axis: facing and its approach.
void takeOffAxis(ToolRun& run)
{
    std::vector<PathPoint>& points = run.points;
    if (run.kind == ToolRun::Kind::Plunge) {
        if (points.back().x_mm <= 0) points.clear();
        return;
    }
    const auto isUseless = [](const PathPoint& end, const PathPoint& inner) {
        return end.x_mm <= 0 && (inner.x_mm <= 0 || end.z_mm == inner.z_mm);
    };
    while (points.size() > 1 && isUseless(points.back(), points[points.size() - 2])) points.pop_back();
    std::size_t first = 0;
    while (first + 1 < points.size() && isUseless(points[first], points[first + 1])) ++first;
    points.erase(points.begin(), points.begin() + static_cast<std::ptrdiff_t>(first));
}

/// Do I and K state the arc of this block?
bool statesCentre(const gcode::Program& program, std::int64_t line)
{
    const gcode::Block& block = program.blocks.at(static_cast<std::size_t>(line - 1));
    return program.wordOf(block, 'I') || program.wordOf(block, 'K');
}

/// Takes out what cuts in a bore; the line of its first block.
std::optional<std::int64_t> leaveOutBores(std::vector<ToolMove>& moves, const Shaft& stock, Notes& notes)
{
    const std::vector<bool> in_bore = movesInBores(moves, stock);
    std::optional<std::int64_t> line;
    for (std::size_t i = 0; i < moves.size(); ++i) {
        if (!in_bore[i] || !moves[i].is_feed) continue;
        moves[i].is_feed = false;
        if (!line) line = moves[i].line;
    }
    if (line) notes.push_back({notes::boreNotPredicted, {{"line", *line}}});
    return line;
}

/// A feed move that counts inches makes a program of inches.
bool countsInches(const gcode::Toolpath& path)
{
    return std::any_of(path.blocks.begin(), path.blocks.end(), [](const gcode::BlockState& state) {
        return state.runs > 0 && state.is_inch &&
               (state.kind == gcode::MoveKind::Feed || state.kind == gcode::MoveKind::Arc);
    });
}

}  // namespace

TurningRuns turningRuns(const gcode::Program& program, const gcode::Toolpath& path, const Shaft& stock,
                        const TurningSetup& setup, Notes& notes)
{
    std::vector<ToolMove> moves = toolMoves(path, setup, notes);
    for (ToolMove& move : moves)
        if (move.arc) move.arc->by_centre = statesCentre(program, move.line);
    TurningRuns turning;
    turning.bore_line = leaveOutBores(moves, stock, notes);
    std::vector<ToolRun>& runs = turning.runs;
    runs = toolRuns(moves);
    const auto faces = [](const ToolRun& run) {
        return std::any_of(run.points.begin(), run.points.end(), [](const PathPoint& at) { return at.x_mm <= 0; });
    };
    const auto first = std::find_if(runs.begin(), runs.end(), faces);
    if (first == runs.end()) return turning;
    notes.push_back({notes::facingNotPredicted, {{"line", first->points.back().line}}});
    for (ToolRun& run : runs) takeOffAxis(run);
    std::erase_if(runs, [](const ToolRun& run) { return run.points.size() < 2; });
    return turning;
}

void refuseBore(std::int64_t line)
{
    throw Error(errors::notModelled, {{"found", LT_TEXT("Engine", "a pass in a bore")}, {"line", line}});
}

std::vector<ToolMove> toolMoves(const gcode::Toolpath& path, const TurningSetup& setup, Notes& notes)
{
    MoveMaker maker(setup, notes);
    for (const gcode::Move& move : path.moves) maker.add(move);
    return maker.take();
}

TurningJob turningJob(gcode::Program program, gcode::Toolpath path, Shaft stock, TurningSetup setup,
                      gcode::ToolTable tools)
{
    TurningJob job{std::move(program),
                   std::move(path),
                   std::move(stock),
                   std::move(setup),
                   std::move(tools),
                   {},
                   {},
                   {},
                   false,
                   {}};
    TurningRuns turning = turningRuns(job.program, job.path, job.stock, job.setup, job.notes);
    if (turning.runs.empty() && turning.bore_line) refuseBore(*turning.bore_line);
    job.runs = std::move(turning.runs);
    job.bore_line = turning.bore_line;
    job.is_inch = countsInches(job.path);
    noteOtherMaterial(job.stock, job.setup, job.notes);
    job.plan = workPlan(job.stock, job.runs, job.setup);
    return job;
}

DeflectionResult predictJob(const TurningJob& job, const Progress& progress)
{
    DeflectionResult result = predictDeflection(job.plan, job.setup, progress);
    result.notes.insert(result.notes.begin(), job.notes.begin(), job.notes.end());
    return result;
}

}  // namespace lathelier::deflection
