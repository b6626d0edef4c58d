#include "engine/deflection/turning_job.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>

#include "engine/core/texts.h"
#include "engine/core/units.h"
#include "engine/deflection/deflection_codes.h"
#include "engine/deflection/deflection_quantities.h"
#include "engine/gcode/gcode_codes.h"
#include "engine/gcode/rewriter.h"

namespace lathelier::deflection {
namespace {

constexpr double mm_per_m = 1000;
constexpr int decimalsOfDiameter = 3;

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
    BlockPlanner(const TurningJob& job, const std::vector<Interval>& kept_lines)
        : job_(job), keptLines_(kept_lines), rewriter_(job.program, job.path, decimalsOfDiameter)
    {
    }

    void add(const CorrectedRun& run)
    {
        const std::vector<CorrectedNode>& nodes = run.nodes;
        if (nodes.empty()) return;
        if (isMoved(nodes.front())) plan({nodes.front()}, nodes.front());
        std::vector<CorrectedNode> parts;
        for (std::size_t k = 1; k < nodes.size(); ++k) {
            parts.push_back(nodes[k]);
            if (nodes[k].added) continue;
            const CorrectedNode& before = nodes[k - parts.size()];
            const bool is_needed =
                std::any_of(parts.begin(), parts.end(), isMoved) || (isMoved(before) && parts.size() > 1);
            if (is_needed) plan(parts, before);
            parts.clear();
        }
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
            rewriter_.setX(b, state.end.x_mm);
            change_mm = 0;
        }
    }

    gcode::RewrittenProgram write() const { return rewriter_.write(); }
    std::int64_t arcs() const { return arcs_; }

    /// The corner that a part of a changed block leads to; null: it follows from another change.
    const CorrectedNode* cornerOf(const gcode::BlockChange& change) const
    {
        const auto planned = corners_.find(static_cast<std::size_t>(change.line - 1));
        if (planned == corners_.end() || change.part >= planned->second.size()) return nullptr;
        return &planned->second[change.part];
    }

private:
    static bool isMoved(const CorrectedNode& node) { return std::abs(node.correction_um()) > meet_mm * mm_per_m; }
    bool isKept(std::int64_t line) const
    {
        const auto number = static_cast<double>(line);
        return std::any_of(keptLines_.begin(), keptLines_.end(),
                           [&](const Interval& lines) { return lines.from <= number && number <= lines.to; });
    }

    void plan(const std::vector<CorrectedNode>& parts, const CorrectedNode& before)
    {
        const std::int64_t line = parts.back().line;
        if (isKept(line)) return;
        const auto b = static_cast<std::size_t>(line - 1);
        if (auto error = rewriter_.refusal(b)) throw Error(*error);
        const bool is_arc = job_.path.blocks[b].kind == gcode::MoveKind::Arc;
        if (is_arc && before.line != line && (before.z_mm < -meet_mm || parts.back().z_mm > length_mm() + meet_mm))
            throw Error(errors::ncBlockNotRewritable,
                        {{"line", line},
                         {"block", gcode::shown(job_.program, job_.program.textOf(job_.program.blocks[b]))},
                         {"reason", LT_TEXT("Engine", "it is an arc that runs beyond the work")}});
        if (is_arc) ++arcs_;
        std::vector<gcode::Point> points;
        points.reserve(parts.size());
        for (const CorrectedNode& node : parts) points.push_back({node.x_mm, job_.setup.z_zero_mm - node.z_mm});
        if (parts.size() > 1 || is_arc)
            rewriter_.split(b, std::move(points));
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
    const std::vector<Interval>& keptLines_;
    gcode::Rewriter rewriter_;
    std::map<std::size_t, std::vector<CorrectedNode>> corners_;
    std::int64_t arcs_ = 0;
};

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

/// Runs that generate a diameter; not facing and parting off, which end at or beyond the axis.
std::vector<ToolRun> turningRuns(const gcode::Toolpath& path, const TurningSetup& setup, Notes& notes)
{
    std::vector<ToolRun> runs = toolRuns(toolMoves(path, setup, notes));
    const auto faces = [](const ToolRun& run) {
        return std::any_of(run.points.begin(), run.points.end(), [](const PathPoint& at) { return at.x_mm <= 0; });
    };
    const auto first = std::find_if(runs.begin(), runs.end(), faces);
    if (first == runs.end()) return runs;
    notes.push_back({notes::facingNotPredicted, {{"line", first->points.back().line}}});
    for (ToolRun& run : runs) takeOffAxis(run);
    std::erase_if(runs, [](const ToolRun& run) { return run.points.size() < 2; });
    return runs;
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
    TurningJob job{
        std::move(program), std::move(path), std::move(stock), std::move(setup), std::move(tools), {}, {}, {}};
    job.runs = turningRuns(job.path, job.setup, job.notes);
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
    CorrectedProgram corrected;
    CompensationParameters without = parameters;
    without.robustness = false;  // robustness is computed for the written text only
    corrected.compensation = compensate(job.stock, job.runs, job.setup, without, progress.part(0, 0.6));
    CompensationResult& result = corrected.compensation;
    result.parameters = parameters;
    result.before.notes.insert(result.before.notes.begin(), job.notes.begin(), job.notes.end());

    BlockPlanner planner(job, parameters.kept_lines);
    for (const CorrectedRun& run : result.runs) planner.add(run);
    planner.restore();
    gcode::RewrittenProgram written = planner.write();
    corrected.text = std::move(written.text);
    for (const gcode::BlockChange& change : written.changes)
        corrected.changes.push_back(changeOf(change, planner.cornerOf(change)));
    result.blocks_changed = written.blocks_changed;
    result.blocks_added = written.blocks_added;
    if (planner.arcs() > 0) result.notes.push_back({notes::arcsBecomeLines, {{"count", planner.arcs()}}});

    gcode::Program again = gcode::readProgram(corrected.text, job.program.control, progress.part(0.6, 0.7));
    gcode::ToolpathParameters reading = job.path.parameters;
    reading.dialect = job.program.control->key;
    gcode::Toolpath path = findToolpath(again, reading, job.tools, progress.part(0.7, 0.8));
    Notes known;
    const std::vector<ToolRun> runs = turningRuns(path, job.setup, known);
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
