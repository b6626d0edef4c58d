#include "engine/deflection/corrected_program.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "engine/core/texts.h"
#include "engine/core/units.h"
#include "engine/deflection/deflection_codes.h"
#include "engine/deflection/deflection_quantities.h"
#include "engine/gcode/gcode_codes.h"
#include "engine/gcode/rewriter.h"

namespace lathelier::deflection {
namespace {

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
    static bool isMoved(const CorrectedNode& node) { return std::abs(node.correction_um()) > meet_mm * um_per_mm; }
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

/// A correction changes one file: the first cut of another one is named, else its first move or its first line.
void refuseOtherFiles(const TurningJob& job)
{
    const std::vector<gcode::PartPlace>& parts = job.program.parts;
    if (parts.empty()) return;
    const auto own = static_cast<std::int64_t>(parts.front().first_block);
    std::int64_t line = 0;
    for (const bool only_cuts : {true, false})
        for (const gcode::Move& move : job.path.moves)
            if (line == 0 && move.line > own && (!only_cuts || move.kind != gcode::MoveKind::Rapid)) line = move.line;
    const gcode::LinePlace place = job.program.placeOf(line > 0 ? line : own + 1);
    throw Error(errors::passInOtherFile, {{"path", place.path}, {"line", place.line}});
}

}  // namespace

std::string reasonOf(const ProgramChange& change)
{
    return fill(change.reason.english, change.values);
}

CorrectedProgram correctProgram(const TurningJob& job, const CompensationParameters& parameters,
                                const Progress& progress)
{
    if (job.bore_line) refuseBore(*job.bore_line);
    refuseOtherFiles(job);
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
