#include "engine/deflection/turning_job.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>

#include "engine/core/core_codes.h"
#include "engine/core/texts.h"
#include "engine/core/units.h"
#include "engine/deflection/bore_passes.h"
#include "engine/deflection/deflection_codes.h"
#include "engine/deflection/deflection_quantities.h"
#include "engine/gcode/gcode_codes.h"
#include "engine/gcode/rewriter.h"

namespace lathelier::deflection {
namespace {

constexpr double mm_per_m = 1000;
constexpr int leastDecimals = 3;  ///< of a diameter in millimetres

/// Decimals of a diameter in millimetres on this grid.
int decimalsOf(double grid_um)
{
    constexpr int mostDecimals = 6;
    int decimals = leastDecimals;
    double steps = grid_um;  // of the last decimal
    while (decimals < mostDecimals && std::abs(steps - std::round(steps)) > meet_mm) {
        steps *= 10;
        ++decimals;
    }
    return decimals;
}

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

/// Changed blocks of a program, with the corner at the end of each of their parts.
class BlockPlanner {
public:
    BlockPlanner(const TurningJob& job, const CompensationParameters& parameters)
        : job_(job), parameters_(parameters), rewriter_(job.program, job.path, decimalsOf(parameters.grid_um))
    {
    }

    void add(const CorrectedRun& run)
    {
        const std::vector<CorrectedNode>& nodes = run.nodes;
        if (nodes.empty() || std::none_of(nodes.begin(), nodes.end(), isMoved)) return;
        const Text turns = LT_TEXT("Engine", "it is an arc that turns back along z");
        if (nodes.front().added) refuse(nodes.front().line, turns);
        if (isMoved(nodes.front())) plan({nodes.front()}, nodes.front());
        std::vector<CorrectedNode> parts;
        for (std::size_t k = 1; k < nodes.size(); ++k) {
            parts.push_back(nodes[k]);
            const bool is_last = k + 1 == nodes.size() || !nodes[k + 1].steps_behind;
            if (!is_last || (nodes[k].added && !nodes[k].steps_behind)) continue;
            planParts(parts, nodes[k - parts.size()]);
            parts.clear();
        }
        if (!parts.empty()) refuse(parts.back().line, turns);
        for (std::size_t k = 1; k < nodes.size(); ++k)
            if (auto error = rewriter_.refusalOfWords(static_cast<std::size_t>(nodes[k].line - 1))) throw Error(*error);
    }

    /// Blocks after a changed one that state no X get the original X.
    void restore()
    {
        double change_mm = 0;
        for (std::size_t b = 0; b < job_.path.blocks.size(); ++b) {
            const gcode::BlockState& state = job_.path.blocks[b];
            if (state.runs == 0) continue;
            if (const auto planned = corners_.find(b); planned != corners_.end()) {
                change_mm = rewriter_.rounded_mm(b, planned->second.back().x_mm) - state.end.x_mm;
                continue;
            }
            if (std::abs(change_mm) <= meet_mm) continue;
            const gcode::Block& block = job_.program.blocks[b];
            const auto states = [&](char letter) { return job_.program.wordOf(block, letter) != nullptr; };
            if (!gcode::isKnown(state.end) || states('X') || states('U')) change_mm = 0;
            const bool moves = states('Z') || states('W');
            if (std::abs(change_mm) <= meet_mm || !moves || state.is_incremental || rewriter_.refusal(b)) continue;
            if (state.kind == gcode::MoveKind::Arc) continue;  // the rewriter refuses one that begins elsewhere
            rewriter_.setX(b, state.end.x_mm);
            change_mm = 0;
        }
    }

    gcode::RewrittenProgram write() const { return rewriter_.write(); }

    /// The corner that a part of a changed block leads to; null: it follows from another change.
    const CorrectedNode* cornerOf(const gcode::BlockChange& change) const
    {
        const auto planned = corners_.find(static_cast<std::size_t>(change.line - 1));
        if (planned == corners_.end() || change.part >= planned->second.size()) return nullptr;
        return &planned->second[change.part];
    }

private:
    static bool isMoved(const CorrectedNode& node) { return std::abs(node.correction_um()) > meet_mm * mm_per_m; }
    bool isArc(std::int64_t line) const
    {
        return job_.path.blocks.at(static_cast<std::size_t>(line - 1)).kind == gcode::MoveKind::Arc;
    }

    [[noreturn]] void refuse(std::int64_t line, Text reason) const
    {
        const gcode::Block& block = job_.program.blocks.at(static_cast<std::size_t>(line - 1));
        throw Error(errors::ncBlockNotRewritable, {{"line", line},
                                                   {"block", gcode::shown(job_.program, job_.program.textOf(block))},
                                                   {"word", Value()},
                                                   {"reason", reason}});
    }

    /// The parts of one block; the last but a step behind it is its end.
    void planParts(const std::vector<CorrectedNode>& parts, const CorrectedNode& before)
    {
        const bool follows = isMoved(before) && (parts.size() > 1 || isArc(parts.back().line));
        if (follows || std::any_of(parts.begin(), parts.end(), isMoved)) plan(parts, before);
    }

    void plan(const std::vector<CorrectedNode>& parts, const CorrectedNode& before)
    {
        const std::int64_t line = parts.back().line;
        if (isKept(parameters_, line)) return;
        const auto b = static_cast<std::size_t>(line - 1);
        if (auto error = rewriter_.refusal(b)) throw Error(*error);
        const bool is_arc = isArc(line);
        if (is_arc && before.line != line && (before.z_mm < -meet_mm || parts.back().z_mm > length_mm() + meet_mm))
            refuse(line, LT_TEXT("Engine", "it is an arc that runs beyond the work"));
        if (is_arc && parts.size() == 1 && !parts.front().arc)
            refuse(line, LT_TEXT("Engine", "it is an arc that ends where a corrected pass begins"));
        const double z_zero_mm = job_.setup.z_zero_mm;
        std::vector<gcode::PathPart> written;
        written.reserve(parts.size());
        for (const CorrectedNode& node : parts) {
            gcode::PathPart part{{node.x_mm, z_zero_mm - node.z_mm}, {}};
            if (node.arc) part.centre = gcode::Point{node.arc->x_mm, z_zero_mm - node.arc->z_mm};
            written.push_back(part);
        }
        if (parts.size() > 1 || is_arc)
            rewriter_.split(b, std::move(written));
        else
            rewriter_.setX(b, parts.front().x_mm);
        corners_[b] = parts;
    }

    double length_mm() const
    {
        double length = 0;
        for (const ShaftSegment& segment : job_.stock.segments) length += segment.length_mm;
        return length;
    }

    const TurningJob& job_;
    const CompensationParameters& parameters_;
    gcode::Rewriter rewriter_;
    std::map<std::size_t, std::vector<CorrectedNode>> corners_;
};

/// Blocks that a switch of the machine may leave out.
void noteSkipped(const TurningJob& job, Notes& list)
{
    for (std::size_t b = 0; b < job.program.blocks.size(); ++b)
        if (job.program.blocks[b].has_skip && job.path.blocks[b].runs > 0)
            return list.push_back({notes::skippedBlocksRun, {{"line", static_cast<std::int64_t>(b) + 1}}});
}

ProgramChange changeOf(const gcode::BlockChange& change, const CorrectedNode* corner)
{
    ProgramChange made{change.line, change.before, change.after, {}, {}};
    if (!corner) {
        made.reason = LT_TEXT("Engine", "ends where it ended, though the block before ends elsewhere");
    } else if (!corner->in_material) {
        made.reason = LT_TEXT("Engine", "in air the path stays where it was");
    } else {
        made.reason = LT_TEXT("Engine",
                              "{correction_um:+1} µm · dx {dx_um:+1} µm, dy {dy_um:+1} µm at z {z_mm:2} mm · F_t "
                              "{F_t_N:0} N, F_ap {F_ap_N:0} N · {stiffness:0} N/mm");
        made.values = {{"correction_um", corner->correction_um()},
                       {"z_mm", corner->z_mm},
                       {"F_t_N", corner->F_t_N},
                       {"F_ap_N", corner->F_ap_N},
                       {"dx_um", corner->dx_um},
                       {"dy_um", corner->dy_um},
                       {"stiffness", corner->stiffness_N_mm}};
    }
    return made;
}

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

struct TurningRuns {
    std::vector<ToolRun> runs;
    std::optional<std::int64_t> bore_line;
};

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

/// Runs that generate an outside diameter; not facing and parting off, which end at or beyond the axis.
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

[[noreturn]] void refuseBore(std::int64_t line)
{
    throw Error(errors::notModelled, {{"found", LT_TEXT("Engine", "a pass in a bore")}, {"line", line}});
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

std::string reasonOf(const ProgramChange& change)
{
    return fill(change.reason.english, change.values);
}

CorrectedProgram correctProgram(const TurningJob& job, const CompensationParameters& parameters,
                                const Progress& progress)
{
    if (job.bore_line) refuseBore(*job.bore_line);
    CorrectedProgram corrected;
    CompensationParameters asked = parameters;
    asked.is_inch = job.is_inch;
    CompensationParameters without = asked;
    without.robustness = false;  // robustness is computed for the written text only
    corrected.compensation = compensate(job.stock, job.runs, job.setup, without, progress.part(0, 0.6));
    CompensationResult& result = corrected.compensation;
    result.parameters = asked;
    result.before.notes.insert(result.before.notes.begin(), job.notes.begin(), job.notes.end());

    BlockPlanner planner(job, asked);
    for (const CorrectedRun& run : result.runs) planner.add(run);
    planner.restore();
    gcode::RewrittenProgram written = planner.write();
    corrected.text = std::move(written.text);
    for (const gcode::BlockChange& change : written.changes)
        corrected.changes.push_back(changeOf(change, planner.cornerOf(change)));
    result.blocks_changed = written.blocks_changed;
    result.blocks_added = written.blocks_added;
    noteSkipped(job, result.notes);

    gcode::Program again = gcode::readProgram(corrected.text, job.program.control, progress.part(0.6, 0.7));
    gcode::ToolpathParameters reading = job.path.parameters;
    reading.dialect = job.program.control->key;
    gcode::Toolpath path = findToolpath(again, reading, job.tools, progress.part(0.7, 0.8));
    Notes known;
    const std::vector<ToolRun> runs = turningRuns(again, path, job.stock, job.setup, known).runs;
    evaluateWritten(job.stock, job.runs, runs, result);
    result.written = runs;
    corrected.moves = std::move(path.moves);
    progress.report(1);
    return corrected;
}

const std::vector<QuantityOf<ProgramChange>>& quantitiesOf(const ProgramChange*)
{
    using R = ProgramChange;
    static const auto all = describedBy<R>(
        quantity<R>("line", &R::line, {LT_TEXT("Engine", "Line"), {}, 0}),
        quantity<R>("before", &R::before, {LT_TEXT("Engine", "Before"), {}, 0}),
        quantity<R>("after", &R::after, {LT_TEXT("Engine", "After"), {}, 0}),
        quantity<R>("reason", [](const R& r) { return reasonOf(r); }, {LT_TEXT("Engine", "Reason"), {}, 0}));
    return all;
}

const std::vector<QuantityOf<CorrectedProgram>>& quantitiesOf(const CorrectedProgram*)
{
    using R = CorrectedProgram;
    static const auto all = describedBy<R>(included(&R::compensation),
                                           quantity<R>("changes", [](const R& r) { return listed(r.changes); }));
    return all;
}

}  // namespace lathelier::deflection
