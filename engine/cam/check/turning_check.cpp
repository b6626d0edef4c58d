#include "engine/cam/check/turning_check.h"

#include <algorithm>
#include <cmath>

#include "engine/cam/cam_codes.h"
#include "engine/cam/check/insert_check.h"
#include "engine/cam/check/second_work.h"
#include "engine/cam/check/tool_changes.h"
#include "engine/cam/edges.h"
#include "engine/cam/job_bodies.h"
#include "engine/cam/job_library.h"
#include "engine/cam/job_rules.h"
#include "engine/cam/post/post.h"
#include "engine/core/units.h"
#include "engine/stock/stock_codes.h"

namespace lathelier::cam {
namespace {

constexpr std::int32_t mostBetween = 8;  ///< largest number of strokes between the neighbours of a rest

CheckKind kindOf(stock::FindingKind kind)
{
    switch (kind) {
        case stock::FindingKind::RapidThroughStock: return CheckKind::RapidThroughStock;
        case stock::FindingKind::HolderInStock: return CheckKind::HolderInStock;
        case stock::FindingKind::Chuck: return CheckKind::Chuck;
        case stock::FindingKind::Tailstock: return CheckKind::Tailstock;
    }
    return CheckKind::RapidThroughStock;
}

gcode::ToolTable toolTableOf(const Job& job)
{
    gcode::ToolTable tools;
    for (const JobTool& tool : job.tools)
        if (tool.isProfile() || tool.isBlade()) tools[tool.number] = tool;
    return tools;
}

/// A program of one clamping with its moves.
struct ReadProgram {
    gcode::Program program;
    gcode::Toolpath path;
};

ReadProgram readText(std::string text, const Job& job, const CheckParameters& parameters, const Progress& progress)
{
    ReadProgram read;
    read.program = gcode::readProgram(std::move(text), gcode::controlOf(parameters.program), progress.part(0, 0.5),
                                      parameters.program.file_name, gcode::partsOf(parameters.program));
    read.path = gcode::findToolpath(read.program, parameters.program, toolTableOf(job), progress.part(0.5, 1));
    return read;
}

/// Does a block have a word of the address X?
bool hasXWord(const gcode::Program& program, std::int64_t line)
{
    if (line < 1 || line > static_cast<std::int64_t>(program.blocks.size())) return false;
    const gcode::Block& block = program.blocks[static_cast<std::size_t>(line - 1)];
    const auto first = program.words.begin() + block.first_word;
    return std::any_of(first, first + block.word_count, [](const gcode::Word& word) { return word.letter == 'X'; });
}

/// To a control that starts at (0, 0), before a program has stated both axes. The true start is unknown, so a first
/// rapid move along Z alone must not be checked as a move along the axis.
std::vector<gcode::Move> fromUnknownStart(std::vector<gcode::Move> moves, const gcode::Program& program)
{
    if (!program.control->start.is_at_origin || moves.size() < 2) return moves;
    gcode::Move& first = moves.front();
    const gcode::Move& next = moves[1];
    if (first.kind == gcode::MoveKind::Rapid && next.kind == gcode::MoveKind::Rapid && first.x_mm == 0 &&
        next.x_mm != 0 && first.z_mm == next.z_mm && !hasXWord(program, first.line))
        first.x_mm = notANumber;
    return moves;
}

/// Inputs of the check in one clamping: part, bar, bodies.
struct CheckedClamping {
    Shaft part;
    stock::StockParameters bodies;
    std::optional<stock::MeridianStock> bar;  ///< none: as the job states it
    BarLimits limits;
    std::vector<CutterStroke> before;  ///< of the program that ran in the first clamping
};

class Check {
public:
    Check(const Shaft& part, const Job& job, const CheckParameters& parameters, const CheckInputs& inputs,
          const Progress& progress)
        : part_(part), job_(job), parameters_(parameters), inputs_(inputs), progress_(progress)
    {
        result_.parameters = parameters;
    }

    CheckResult run(std::string text)
    {
        ReadProgram read =
            readText(std::move(text), job_, parameters_, progress_.part(0, 0.1, LT_TEXT("Engine", "Reading")));
        result_.program = std::move(read.program);
        result_.path = std::move(read.path);
        if (result_.path.has_errors) return std::move(result_);
        CheckedClamping clamping = clampingOf();
        checkSurface(clamping);
        checkBodies(clamping);
        sortFindings();
        listNotChecked();
        const bool is_clean = result_.findings.empty() && result_.rest.empty();
        const bool is_blind = contains(result_.notes, notes::toolNotInJob) || !result_.not_checked.empty();
        result_.verdict = !is_clean ? Verdict::Fail : is_blind ? Verdict::Undecided : Verdict::Pass;
        progress_.report(1);
        return std::move(result_);
    }

private:
    CheckedClamping clampingOf()
    {
        CheckedClamping clamping;
        clamping.bodies = stockParameters(job_);
        clamping.bodies.dog_leg = parameters_.dog_leg;
        clamping.bodies.most_outlines = parameters_.keeps_outlines ? stock::mostOutlines : 1;
        result_.stock_zero_mm = job_.stock.face_allowance_mm;
        clamping.limits = {job_.stock.diameter_mm / 2, -job_.stock.face_allowance_mm};
        const bool is_second = parameters_.setup == 2;
        if (is_second) {
            clamping.bodies.chuck.reset();
            clamping.bodies.tailstock.reset();
        }
        clamping.part = is_second ? mirrored(part_) : part_;
        if (is_second) reverseWork(clamping);
        if (parameters_.chuck_face_z_mm)
            clamping.bodies.chuck = stock::ChuckBody{*parameters_.chuck_face_z_mm + result_.stock_zero_mm,
                                                     job_.setup.jaw_diameter_mm.value_or(0) / 2};
        else if (is_second)
            result_.notes.push_back({notes::secondChuckUnknown, {}});
        clamping.bodies.z_zero_mm = result_.stock_zero_mm + parameters_.z_zero_mm;
        return clamping;
    }

    /// Stock after the first program, mirrored and cut to length with the face allowance of the second clamping.
    void reverseWork(CheckedClamping& clamping)
    {
        const double length = part_.length_mm(), zero = result_.stock_zero_mm;
        stock::MeridianStock bar(stockOf(job_), clamping.bodies.step_mm);
        if (inputs_.before) {
            CheckParameters first = parameters_;
            first.z_zero_mm = 0;
            if (inputs_.before_control) {
                first.program.control = *inputs_.before_control;
                first.program.dialect = gcode::automaticControl;
            }
            const ReadProgram read = readText(*inputs_.before, job_, first, progress_.part(0.1, 0.15));
            result_.before_understanding = read.path.understanding;
            if (const auto error = firstErrorOf(read.path)) throw Error(*error).with("path", "--before");
            stock::StockParameters bodies = stockParameters(job_);
            bodies.chuck.reset();
            bodies.dog_leg = parameters_.dog_leg;
            bodies.most_outlines = 1;
            bar = stock::simulateStock(std::move(bar), read.path.moves, bodies, progress_.part(0.15, 0.3)).left;
            clamping.before = cutterPath(read.path.moves, job_, {0, true, length}, result_.notes);
        }
        const double work = workLength_mm(result_.program.text, length, job_, parameters_, result_.notes);
        clamping.bar = bar.turnedRound(zero + work);
        result_.stock_zero_mm = std::max(0.0, clamping.bar->length_mm() - length - zero);
        clamping.limits.end_z_mm = -result_.stock_zero_mm;
    }

    /// Features besides the outside within the stretch that is looked at; of threads those that no move cuts.
    void listNotChecked()
    {
        const double length = part_.length_mm();
        const std::optional<Interval> stretch = lookedAt(length);
        const bool is_second = parameters_.setup == 2;
        for (const DrawnFeature& drawn : featuresBesideOutside(part_)) {
            DrawnFeature feature = drawn;
            if (is_second && drawn.z_start_mm && drawn.z_end_mm) {
                feature.z_start_mm = length - *drawn.z_end_mm;
                feature.z_end_mm = length - *drawn.z_start_mm;
            }
            if (isThreaded(feature, result_.path.moves, parameters_.z_zero_mm)) continue;
            if (stretch && feature.z_start_mm && feature.z_end_mm &&
                (*feature.z_end_mm <= stretch->from || *feature.z_start_mm >= stretch->to))
                continue;
            result_.notes.push_back({notes::drawnNotChecked, valuesOf(feature)});
            result_.not_checked.push_back(std::move(feature));
        }
    }

    static std::optional<Error> firstErrorOf(const gcode::Toolpath& path)
    {
        for (const gcode::Diagnostic& diagnostic : path.diagnostics)
            if (diagnostic.error) return diagnostic.error;
        return {};
    }

    std::optional<Interval> lookedAt(double length) const
    {
        if (!parameters_.finished_from_mm && !parameters_.finished_to_mm) return {};
        return Interval{parameters_.finished_from_mm.value_or(-1), parameters_.finished_to_mm.value_or(length + 1)};
    }

    void checkSurface(const CheckedClamping& clamping)
    {
        const bool has_hole = parameters_.setup != 2 && job_.setup.tailstock;
        const DrawnContour drawing(clamping.part, inputs_.correction, usualSpacing_mm,
                                   has_hole ? job_.setup.tailstock->centre_hole_mm / 2 : 0);
        AllStrokes all;
        all.strokes = cutterPath(result_.path.moves, job_, {parameters_.z_zero_mm, false, 0}, result_.notes);
        all.own = all.strokes.size();
        all.strokes.insert(all.strokes.end(), clamping.before.begin(), clamping.before.end());
        const SurfaceDeviation found =
            surfaceDeviation(drawing, all, clamping.limits, lookedAt(clamping.part.length_mm()), gougeLimit_mm,
                             leftLimit_mm, progress_.part(0.3, 0.5, LT_TEXT("Engine", "Measuring the surface")));
        result_.gouge_um = 1000 * found.gouge_mm;
        if (found.gouge_line > 0) {
            result_.gouge_z_mm = found.gouge_at.z_mm;
            result_.gouge_line = found.gouge_line;
        }
        result_.left_max_mm = found.left_max_mm;
        for (const LeftStretch& stretch : found.left) {
            addRest(stretch, drawing, all);
            if (result_.rest.back().cause == RestCause::Uncut) assignBlock(stretch, found.clearances, all);
        }
        for (const InsertBelow& below :
             insertsBelow(result_.path.moves, job_, drawing, parameters_.z_zero_mm, progress_.part(0.5, 0.6)))
            add({below.line, CheckKind::InsertBelowDrawing, below.at.z_mm, below.at.x_mm, below.depth_mm});
        for (const BlockGouge& block : found.blocks)
            add({block.line, CheckKind::InsertBelowDrawing, block.at.z_mm, block.at.x_mm, block.depth_mm});
    }

    void addRest(const LeftStretch& stretch, const DrawnContour& drawing, const AllStrokes& all)
    {
        RestInterval rest;
        rest.z_start_mm = stretch.z_start_mm;
        rest.z_end_mm = stretch.z_end_mm;
        rest.left_mm = stretch.left_mm;
        rest.cause = causeOf(stretch, drawing, all, job_);
        if (stretch.nearest >= 0) {
            const CutterStroke& nearest = all.strokes[static_cast<std::size_t>(stretch.nearest)];
            rest.tool = nearest.tool;
            if (static_cast<std::size_t>(stretch.nearest) < all.own) rest.line = nearest.line;
            if (rest.cause == RestCause::NoseRadius) rest.nose_radius_mm = nearest.radius_mm;
        }
        if (const ContourPiece& piece = drawing.pieces()[stretch.piece]; rest.nose_radius_mm && piece.arc_radius_mm < 0)
            rest.corner_radius_mm = -piece.arc_radius_mm;
        result_.rest.push_back(rest);
    }

    /// If no geometry prevents the cut, the responsible block lies between those that cut both neighbours of the rest.
    void assignBlock(const LeftStretch& stretch, const std::vector<Clearance>& clearances, const AllStrokes& all)
    {
        if (stretch.first == 0 || stretch.last + 1 >= clearances.size()) return;
        const std::int32_t before = clearances[stretch.first - 1].own, after = clearances[stretch.last + 1].own;
        if (before < 0 || after < before || after - before > mostBetween) return;
        // If no stroke lies between them, one of the two is responsible.
        const CutterStroke& block = all.strokes[static_cast<std::size_t>(std::min(before + 1, after))];
        result_.rest.back().line = block.line;
        result_.rest.back().tool = block.tool;
    }

    void checkBodies(CheckedClamping& clamping)
    {
        const Progress progress = progress_.part(0.6, 1, LT_TEXT("Engine", "Checking against the stock"));
        const std::vector<gcode::Move> moves = fromUnknownStart(result_.path.moves, result_.program);
        clamping.bodies.tailstock_from_move = firstMoveWithTailstock(moves);
        result_.stock = clamping.bar ? stock::simulateStock(*std::move(clamping.bar), moves, clamping.bodies, progress)
                                     : stock::simulateStock(stockOf(job_), moves, clamping.bodies, progress);
        const stock::StockResult& met = *result_.stock;
        const double zero = result_.stock_zero_mm;
        for (const stock::StockFinding& found : met.findings)
            add({found.line, kindOf(found.kind), found.z_mm - zero, found.x_mm, found.depth_mm});
        result_.findings_not_listed += met.findings_not_listed;
        if (parameters_.setup == 2)
            if (const auto end = standingEnd(met, zero, job_.stock.face_allowance_mm, moves)) add(*end);
        const Notes changes = toolChangesNearWork(moves, clamping.bodies, met.length_mm, job_.stock.diameter_mm / 2);
        result_.notes.insert(result_.notes.end(), changes.begin(), changes.end());
        for (Note note : met.notes) {
            if (isIrrelevant(note, moves)) continue;
            if (const Value* z = lathelier::find(note.values, "z_mm"))
                if (const double* number = std::get_if<double>(z)) set(note.values, "z_mm", *number - zero);
            result_.notes.push_back(std::move(note));
        }
    }

    /// Notes without meaning here: no tool before the first tool call; small clearances of threading passes.
    bool isIrrelevant(const Note& note, const std::vector<gcode::Move>& moves) const
    {
        const auto number = [&note](const char* name) -> std::int64_t {
            const Value* value = lathelier::find(note.values, name);
            const auto* whole = value ? std::get_if<std::int64_t>(value) : nullptr;
            return whole ? *whole : -1;
        };
        if (note.code == notes::toolAssumed || note.code == notes::toolWithoutHolder)
            return number("tool") == 0 && !job_.tool(0);
        if (!(note.code == notes::smallClearance)) return false;
        return std::any_of(moves.begin(), moves.end(), [&](const gcode::Move& move) {
            const JobTool* tool = move.line == number("line") ? job_.tool(move.tool) : nullptr;
            return tool && tool->isThreader();
        });
    }

    /// Index of the first move after centre drilling, when the tailstock is engaged; 0 if the program drills no hole.
    std::size_t firstMoveWithTailstock(const std::vector<gcode::Move>& moves) const
    {
        for (std::size_t i = moves.size(); i-- > 0;)
            if (const JobTool* tool = job_.tool(moves[i].tool); tool && tool->isDrill()) return i + 1;
        return 0;
    }

    /// Keeps the deepest finding per block and kind.
    void add(const CheckFinding& finding)
    {
        for (CheckFinding& other : result_.findings)
            if (other.line == finding.line && other.kind == finding.kind) {
                if (finding.depth_mm > other.depth_mm) other = finding;
                return;
            }
        if (result_.findings.size() < stock::mostFindings)
            result_.findings.push_back(finding);
        else
            ++result_.findings_not_listed;
    }

    void sortFindings()
    {
        std::stable_sort(result_.findings.begin(), result_.findings.end(),
                         [](const CheckFinding& a, const CheckFinding& b) { return a.line < b.line; });
    }

    const Shaft& part_;
    const Job& job_;
    const CheckParameters& parameters_;
    const CheckInputs& inputs_;
    const Progress& progress_;
    CheckResult result_;
};

}  // namespace

CheckResult checkTurning(std::string text, const Shaft& part, const Job& stated, const CheckParameters& parameters,
                         const CheckInputs& inputs, const Progress& progress)
{
    const Job job = withLibrary(stated);
    checkPart(part);
    checkStock(job, part);
    checkTools(job);
    const Shaft drawn = brokenEdges(part, job.edge_break_mm, breaksEnd(job, parameters.setup == 2)).part;
    return Check(drawn, job, parameters, inputs, progress).run(std::move(text));
}

}  // namespace lathelier::cam
