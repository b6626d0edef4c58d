#include "engine/cam/plan.h"

#include <algorithm>
#include <cmath>

#include "engine/cam/cutting_data.h"
#include "engine/cam/edges.h"
#include "engine/cam/job_bodies.h"
#include "engine/cam/job_library.h"
#include "engine/cam/job_rules.h"
#include "engine/cam/plan_codes.h"
#include "engine/cam/plan_head.h"
#include "engine/cam/plan_outcome.h"
#include "engine/cam/plan_refusal.h"
#include "engine/cam/post/program_writer.h"
#include "engine/cam/speed_words.h"
#include "engine/cam/work_frame.h"
#include "engine/gcode/program_time.h"

namespace lathelier::cam {
namespace {

constexpr double mm3PerCm3 = 1000;
constexpr int mostPlans = 20;  // each drops at least one operation of the plan before it

class Planner {
public:
    Planner(const Shaft& part, const Job& job, const TurningInputs& inputs, const TurningParameters& parameters)
        : part_(part), job_(job), inputs_(inputs), parameters_(parameters)
    {
    }

    /// Rest operations with a fault in the written program are dropped, and the others planned again.
    TurningPlan plan(const std::vector<Clamping>& clampings, const Progress& progress)
    {
        for (int i = 0;; ++i) {
            threadsCut_.clear();
            TurningPlan plan = planOnce(clampings, progress);
            const std::vector<DroppedOperation> faulty = faultyRestOperations(plan);
            if (!plan.is_refused || faulty.empty() || i == mostPlans) return plan;
            dropped_.insert(dropped_.end(), faulty.begin(), faulty.end());
        }
    }

private:
    TurningPlan planOnce(const std::vector<Clamping>& clampings, const Progress& progress)
    {
        TurningPlan plan;
        plan.parameters = parameters_;
        plan.part = part_;
        plan.job = job_;
        plan.post = inputs_.post.name;
        if (!job_.max_rpm) plan.planning.push_back({notes::speedLimitAssumed, {{"max_rpm", assumedLimit_rpm}}});
        std::optional<WorkStock> left;
        const double share = 1.0 / static_cast<double>(clampings.size());
        for (std::size_t i = 0; i < clampings.size(); ++i)
            planClamping(clampings[i], i, clampings.size(), left, plan,
                         progress.part(share * static_cast<double>(i), share * static_cast<double>(i + 1)));
        noteAssumed(plan.planning);
        plan.not_made = notMade();
        for (const DrawnFeature& feature : plan.not_made)
            if (feature.kind == MarkKind::Bore)
                plan.planning.push_back({notes::boreNotPlanned, valuesOf(feature)});
            else if (feature.kind != MarkKind::Thread)  // of those its own note says why
                plan.planning.push_back({notes::featureNotPlanned, valuesOf(feature)});
        conclude(plan);
        return plan;
    }

    /// Features of the drawing that no operation of the clampings planned so far makes.
    std::vector<DrawnFeature> notMade() const
    {
        std::vector<DrawnFeature> features = featuresBesideOutside(part_);
        std::erase_if(features, [this](const DrawnFeature& feature) {
            return std::any_of(threadsCut_.begin(), threadsCut_.end(), [&](const DrawnThread& thread) {
                return feature.kind == MarkKind::Thread && feature.z_start_mm &&
                       std::abs(*feature.z_start_mm - thread.z_start_mm) < meet_mm &&
                       std::abs(*feature.z_end_mm - thread.z_end_mm) < meet_mm;
            });
        });
        return features;
    }

    /// The same without threads that another clamping is for.
    std::vector<DrawnFeature> notMadeIn(const Clamping& clamping) const
    {
        std::vector<DrawnFeature> features = notMade();
        std::erase_if(features, [&](const DrawnFeature& feature) {
            if (feature.kind != MarkKind::Thread) return false;
            return std::none_of(clamping.threads.begin(), clamping.threads.end(), [&](const DrawnThread& thread) {
                const DrawnThread drawn = clamping.is_mirrored ? mirrored({thread}, part_.length_mm()).front() : thread;
                return std::abs(*feature.z_start_mm - drawn.z_start_mm) < meet_mm;
            });
        });
        return features;
    }

    void planClamping(const Clamping& clamping, std::size_t index, std::size_t count, std::optional<WorkStock>& left,
                      TurningPlan& plan, const Progress& progress)
    {
        const WorkStock begin = left ? turnedRound(*left, clamping) : barOf(clamping);
        SetupOperations planned = planSetup(clamping, begin, parameters_.skipped, parameters_.order, dropped_,
                                            progress.part(0, 0.4, LT_TEXT("Engine", "Planning")));
        SetupPlan setup;
        setup.clamping = clamping;
        const std::vector<SectionSpeed> sections =
            speeds(clamping, planned, begin, plan.planning, progress.part(0.4, 0.6, LT_TEXT("Engine", "Speeds")));
        ProgramHead head;
        head.title = job_.title.empty() ? part_.name : job_.title;
        head.number = 100 + static_cast<int>(index);
        head.max_rpm = job_.max_rpm.value_or(assumedLimit_rpm);
        head.has_tailstock = clamping.job.setup.tailstock.has_value();
        head.cut_off_mm = clamping.cut_off_to_mm;
        for (const DrawnThread& thread : planned.threads_cut)
            threadsCut_.push_back(clamping.is_mirrored ? mirrored({thread}, part_.length_mm()).front() : thread);
        HeadFacts facts{clamping, part_, inputs_.origin, sections, planned.rest, notMadeIn(clamping), index + 1,
                        count,    {}};
        head.comments = headComments(facts, inputs_.post);
        head.cycles = cycles(clamping);
        head.has_optional_stops = parameters_.optional_stops;
        head.states_offset = parameters_.work_offset;
        WrittenProgram written = writeProgram(inputs_.post, head, planned.operations);
        const GivenProgram program{index, written.text, {}, true, true};
        const GivenProgram first{0, clamping.is_mirrored ? plan.setups.front().text : std::string(), {}, true, true};
        setup.check = checkProgram(part_, job_, program, clamping.is_mirrored ? &first : nullptr,
                                   checkParametersOf(clamping, count, inputs_), inputs_.post,
                                   progress.part(0.6, 0.95, LT_TEXT("Engine", "Checking the program")));
        // The same number of lines, with the outcome in the head.
        facts.check = checkLine(setup.check);
        setMeasured(facts.rest, setup.check.rest);
        head.comments = headComments(facts, inputs_.post);
        setup.text = writeProgram(inputs_.post, head, planned.operations).text;
        if (written.no_cycle)
            plan.planning.push_back(
                {notes::cycleNotPossible,
                 {{"clamping", static_cast<std::int64_t>(index) + 1}, {"reason", *written.no_cycle}}});
        setup.predicted = planned.rest;
        setup.refused = planned.refused;
        describe(planned, written, setup, plan.planning);
        setup.moves = std::move(planned.operations);
        for (SectionSpeed section : sections) {
            section.setup = static_cast<int>(index) + 1;
            if (clamping.is_mirrored) {
                const double from = section.z_start_mm;
                section.z_start_mm = part_.length_mm() - section.z_end_mm;
                section.z_end_mm = part_.length_mm() - from;
            }
            plan.sections.push_back(section);
        }
        plan.planning.insert(plan.planning.end(), planned.notes.begin(), planned.notes.end());
        plan.setups.push_back(std::move(setup));
        left = std::move(planned.after);
        progress.report(1);
    }

    WorkStock turnedRound(const WorkStock& left, const Clamping& clamping) const
    {
        const double length = part_.length_mm(), zero = job_.stock.face_allowance_mm;
        stock::MeridianStock turned = left.columns().turnedRound(zero + length + clamping.job.stock.face_allowance_mm);
        stock::StockParameters bodies = stockParameters(clamping.job);
        bodies.z_zero_mm = std::max(0.0, turned.length_mm() - length - zero);
        if (bodies.chuck) bodies.chuck->face_z_mm = clamping.job.setup.chuck_face_z_mm + bodies.z_zero_mm;
        return WorkStock(std::move(turned), bodies);
    }

    std::vector<SectionSpeed> speeds(const Clamping& clamping, SetupOperations& planned, const WorkStock& begin,
                                     Notes& notes, const Progress& progress) const
    {
        SpeedRequest request;
        request.spindle = inputs_.spindle;
        request.relation = parameters_.relation;
        request.model = parameters_.part_model;
        if (const auto* material = workMaterial(job_.cutting.material)) request.material = &material->value;
        request.max_rpm = job_.max_rpm.value_or(assumedLimit_rpm);
        request.whole = heldPart(clamping.is_mirrored ? mirrored(part_) : part_, clamping.job);
        if (request.spindle && clamping.job.setup.tailstock) notes.push_back({notes::tailstockNotInSpeeds, {}});
        std::vector<SectionSpeed> sections;
        WorkStock work = begin;
        for (Operation& operation : planned.operations) {
            if (operation.kind == OperationKind::Rough)
                setRoughSpeeds(operation, clamping, request, work, notes, progress.part(0, 0.5));
            if (operation.kind == OperationKind::Finish) {
                sections = finishSections(clamping, request, work, notes, progress.part(0.5, 1));
                setFinishSpeeds(operation, sections, clamping.part);
            }
            if (operation.kind == OperationKind::FinishBack)
                setBackSpeed(operation, clamping, request, work, notes, progress.part(0.5, 1));
            if (request.spindle) work.run(operation);
        }
        return sections;
    }

    std::optional<CycleData> cycles(const Clamping& clamping) const
    {
        const bool wanted = parameters_.cycles == CycleChoice::Cycles ||
                            (parameters_.cycles == CycleChoice::AsPost && inputs_.post.cycles);
        if (!wanted) return {};
        const RoughCutting& rough = clamping.job.cutting.rough;
        const JobTool& tool = *clamping.job.toolFor(ToolUse::Rough);
        return CycleData{rough.depth_mm, rough.allowance_mm, tool.entering_angle_deg.value_or(90)};
    }

    /// Note where the cutting power exceeds mostPowerShare of the available power.
    void notePower(const PlannedOperation& operation, Notes& notes) const
    {
        const JobSetup& machine = job_.setup;
        if (!machine.power_kW || !operation.power_max_kW) return;
        const double motor = *operation.power_max_kW / machine.efficiency, share = motor / *machine.power_kW;
        if (share <= mostPowerShare) return;
        for (Note& note : notes) {  // the note with the largest power per operation
            if (!(note.code == notes::powerNearLimit)) continue;
            if (!(*find(note.values, "operation") == Value(nameOf(operation.kind)))) continue;
            if (std::get<double>(*find(note.values, "power_kW")) >= motor) return;
            set(note.values, "tool", std::int64_t{operation.tool});
            set(note.values, "power_kW", motor);
            set(note.values, "share_percent", 100 * share);
            return;
        }
        notes.push_back({notes::powerNearLimit,
                         {{"operation", nameOf(operation.kind)},
                          {"tool", std::int64_t{operation.tool}},
                          {"power_kW", motor},
                          {"share_percent", 100 * share},
                          {"machine_kW", *machine.power_kW},
                          {"efficiency", machine.efficiency}}});
    }

    void describe(const SetupOperations& planned, const WrittenProgram& written, SetupPlan& setup, Notes& notes) const
    {
        const LibraryEntry<WorkMaterial>* material = workMaterial(job_.cutting.material);
        const std::vector<gcode::Move>& moves = setup.check.path.moves;
        int tool = 0;
        for (std::size_t i = 0; i < planned.operations.size(); ++i) {
            const Operation& operation = planned.operations[i];
            PlannedOperation described;
            described.kind = operation.kind;
            described.tool = operation.tool;
            described.blocks = written.operations[i].blocks;
            described.first_line = written.operations[i].first_line;
            described.contour_first_line = written.operations[i].contour_first_line;
            described.contour_last_line = written.operations[i].contour_last_line;
            described.depth_mm = planned.depth_mm[i];
            described.volume_cm3 = planned.removed_mm3[i] / mm3PerCm3;
            const std::int64_t end =
                i + 1 < written.operations.size() ? written.operations[i + 1].first_line : INT64_MAX;
            std::vector<gcode::Move> own;
            for (const gcode::Move& move : moves)
                if (described.holds(move.line, end) && move.tool == operation.tool && gcode::isKnown(move.x_mm) &&
                    gcode::isKnown(move.z_mm))
                    own.push_back(move);
            const gcode::ProgramTimes times = gcode::timesOf(own);
            described.feed_length_mm = times.all.feed_length_mm;
            described.time_s = times.all.time_s();
            if (material) described.power_max_kW = powerOf(*material, operation, planned.depth_mm[i]);
            notePower(described, notes);
            setup.time_s += described.time_s + (operation.tool != tool ? parameters_.tool_change_s : 0);
            tool = operation.tool;
            setup.operations.push_back(described);
        }
    }

    double powerOf(const LibraryEntry<WorkMaterial>& material, const Operation& operation, double depth) const
    {
        const JobTool* tool = job_.tool(operation.tool);
        double feed = 0, speed = operation.cutting_speed_m_min;
        for (const CutMove& move : operation.moves) feed = std::max(feed, move.feed_mm_rev);
        const double angle = tool && tool->isProfile() ? tool->entering_angle_deg.value_or(90) : 90;
        return cuttingPower(material.value, depth, feed, angle, speed);
    }

    void noteAssumed(Notes& notes) const
    {
        if (const auto* material = workMaterial(job_.cutting.material))
            notes.push_back({notes::cuttingDataAssumed,
                             {{"source", material->source},
                              {"k_c11_N_mm2", material->value.k_c11_N_mm2},
                              {"m_c", material->value.m_c}}});
        else
            notes.push_back({notes::materialForPowerMissing, {}});
    }

    const Shaft& part_;
    const Job& job_;
    const TurningInputs& inputs_;
    const TurningParameters& parameters_;
    std::vector<DroppedOperation> dropped_;  ///< by plans before this one
    std::vector<DrawnThread> threadsCut_;    ///< z of the drawing
};

bool isOnlyCorners(const TurningPlan& plan)
{
    return !plan.is_refused && std::all_of(plan.rest.begin(), plan.rest.end(), [](const RestInterval& rest) {
        return rest.cause == RestCause::NoseRadius || rest.cause == RestCause::Blade;
    });
}

void checkFeeds(const Job& job)
{
    for (const ToolUse use : {ToolUse::Rough, ToolUse::Finish, ToolUse::FinishBack}) {
        const JobTool* tool = job.toolFor(use);
        if (!tool || !tool->isProfile()) continue;
        const double feed = tool->feed_mm_rev.value_or(use == ToolUse::Rough ? job.cutting.rough.feed_mm_rev
                                                                             : job.cutting.finish.feed_mm_rev);
        if (feed >= 2 * tool->radius_mm())
            throw Error(errors::feedBeyondNose, {{"tool", std::int64_t{tool->number}},
                                                 {"feed_mm_rev", feed},
                                                 {"nose_radius_mm", tool->radius_mm()},
                                                 {"most_mm_rev", 2 * tool->radius_mm()}});
    }
}

/// Precondition: part and job satisfy job_rules.h. `both_ends`: the part as two clampings turn it, with the edge of its
/// other end broken.
TurningPlan planned(const Shaft& part, const Shaft& both_ends, const Job& job, const TurningInputs& inputs,
                    const TurningParameters& parameters, const Progress& progress)
{
    Planner planner(part, job, inputs, parameters);
    std::optional<TurningPlan> one;
    std::optional<Error> refusal;
    if (parameters.setups != SetupChoice::Two) {
        try {
            one = planner.plan({wholeClamping(part, job)},
                               progress.part(0, parameters.setups == SetupChoice::One ? 1 : 0.4));
        } catch (const Error& error) {
            if (parameters.setups == SetupChoice::One || !(error.code() == errors::noSetupPossible)) throw;
            refusal = error;
        }
        if (one && (parameters.setups == SetupChoice::One || isOnlyCorners(*one))) return *std::move(one);
    }
    const std::optional<double> split = splitOf(both_ends);
    double missing = 0;
    const std::optional<Grip> grip = split ? gripBefore(both_ends, job, *split, missing) : std::nullopt;
    if (!grip) {
        if (one) return *std::move(one);
        if (refusal) throw Error(*refusal);
        throw Error(errors::noSetupPossible,
                    {{"reason", LT_TEXT("Engine", "no finished cylinder is long enough to grip the part by")},
                     {"missing_mm", missing}});
    }
    try {
        Planner second(both_ends, job, inputs, parameters);
        TurningPlan two = second.plan(twoClampings(both_ends, job, *split, *grip), progress.part(0.4, 1));
        two.planning.push_back({notes::secondClampingAssumed,
                                {{"grip_start_mm", grip->from_mm},
                                 {"grip_end_mm", grip->to_mm},
                                 {"chuck_face_z_mm", part.length_mm() - grip->to_mm},
                                 {"face_allowance_mm", two.setups.back().clamping.job.stock.face_allowance_mm}}});
        if (const auto& cut = two.setups.back().clamping.cut_off_to_mm)
            two.planning.push_back({notes::cutOffFirst, {{"length_mm", *cut}}});
        if (grip->has_tolerance) two.planning.push_back({notes::softJaws, {}});
        if (!one || (!two.is_refused && (one->is_refused || two.left_max_mm < one->left_max_mm - leastRest_mm)))
            return two;
        one->planning.push_back(
            {notes::twoClampingsNoBetter, {{"left_mm", two.left_max_mm}, {"left_one_mm", one->left_max_mm}}});
    } catch (const Error& error) {
        if (!one || !(error.code() == errors::noSetupPossible)) throw;
    }
    return *std::move(one);
}

}  // namespace

const CheckResult& TurningPlan::worstCheck() const
{
    const auto worse = [](const SetupPlan& a, const SetupPlan& b) {
        return std::pair(a.check.findings.size(), a.check.gouge_um) <
               std::pair(b.check.findings.size(), b.check.gouge_um);
    };
    return std::max_element(setups.begin(), setups.end(), worse)->check;
}

TurningPlan planTurning(const Shaft& part, const Job& stated, const TurningInputs& inputs,
                        const TurningParameters& parameters, const Progress& progress)
{
    const Job job = withLibrary(stated);
    checkPart(part);
    checkStock(job, part);
    checkTools(job);
    checkUses(job);
    checkFeeds(job);
    const BrokenEdges one = brokenEdges(part, job.edge_break_mm, breaksEnd(job, false)),
                      two = brokenEdges(part, job.edge_break_mm, true);
    TurningPlan plan = planned(one.part, two.part, job, inputs, parameters, progress);
    const BrokenEdges& edges = plan.setups.size() > 1 ? two : one;
    plan.stated = stated;
    noteLibrary(stated, plan.planning);
    noteRanges(job, plan.planning);
    noteFits(job, plan.planning);
    if (job.edge_break_mm > 0)
        plan.planning.push_back(
            {notes::edgesBroken, {{"edge_break_mm", job.edge_break_mm}, {"count", edges.count}, {"left", edges.left}}});
    conclude(plan);
    return plan;
}

}  // namespace lathelier::cam
