#include "engine/cam/setup_plan.h"

#include <algorithm>
#include <cmath>

#include "engine/cam/cutting_data.h"
#include "engine/cam/deep_rest.h"
#include "engine/cam/ends.h"
#include "engine/cam/job_bodies.h"
#include "engine/cam/operation_order.h"
#include "engine/cam/plan_codes.h"
#include "engine/cam/rest_operations.h"
#include "engine/cam/roughing.h"
#include "engine/cam/threads.h"
#include "engine/cam/work_frame.h"

namespace lathelier::cam {
namespace {

class SetupPlanner {
public:
    SetupPlanner(const Clamping& clamping, WorkStock stock, const std::vector<SkippedOperation>& skipped,
                 const std::vector<OperationStep>& order, const std::vector<DroppedOperation>& dropped,
                 const Progress& progress)
        : clamping_(clamping),
          job_(clamping.job),
          skipped_(skipped),
          order_(order),
          dropped_(dropped),
          frame_(frameOf(clamping.job, clamping.part)),
          progress_(progress),
          result_{{}, {}, {}, {}, {}, {}, std::move(stock), {}}
    {
    }

    SetupOperations run()
    {
        const JobTool& rough = *job_.toolFor(ToolUse::Rough);
        const JobTool& finish = *job_.toolFor(ToolUse::Finish);
        noteRoughness(finish);
        const std::vector<OperationStep> steps = inOrder(usualSteps(rough, finish), order_);
        if (const auto fault = faultOf(steps))
            throw Error(errors::orderImpossible, {{"operation", nameOf(fault->step.kind)},
                                                  {"needed", nameOf(fault->needs.kind)},
                                                  {"reason", fault->reason}});
        for (std::size_t i = 0; i < steps.size(); ++i) {
            progress_.report(static_cast<double>(i) / static_cast<double>(steps.size()));
            runStep(steps[i]);
        }
        if (clamping_.parts_off && job_.setup.tailstock) result_.notes.push_back({notes::partOffLeftOut, {}});
        result_.rest = restOf(frame_.contour, reaches_);
        progress_.report(1);
        return std::move(result_);
    }

private:
    std::vector<OperationStep> usualSteps(const JobTool& rough, const JobTool& finish) const
    {
        std::vector<OperationStep> steps;
        const auto add = [&](OperationKind kind, int tool) {
            const OperationStep step{clamping_.is_mirrored ? 2 : 1, kind, tool};
            if (std::find(steps.begin(), steps.end(), step) == steps.end()) steps.push_back(step);
        };
        const JobTool* facer = facingTool(job_);
        add(OperationKind::Face, facer ? facer->number : rough.number);
        if (const auto hole = centreDrilling(frame_)) add(OperationKind::CentreDrill, hole->tool);
        add(OperationKind::Rough, rough.number);
        add(OperationKind::SemiFinish, rough.number);
        add(OperationKind::Finish, finish.number);
        for (const ToolUse use : {ToolUse::FinishBack, ToolUse::Groove, ToolUse::PartOff})
            for (const JobTool& tool : job_.tools)
                if (tool.use == use && (use != ToolUse::PartOff || !job_.toolFor(ToolUse::Groove)))
                    add(tool.isBlade() ? OperationKind::Groove : OperationKind::FinishBack, tool.number);
        if (!clamping_.threads.empty()) {
            const JobTool* threader = job_.toolFor(ToolUse::Thread);
            add(OperationKind::Thread, threader ? threader->number : 0);
        }
        if (clamping_.parts_off && !job_.setup.tailstock) add(OperationKind::PartOff, job_.partingBlade()->number);
        return steps;
    }

    void runStep(const OperationStep& step)
    {
        const JobTool &rough = *job_.toolFor(ToolUse::Rough), &finish = *job_.toolFor(ToolUse::Finish);
        const double depth = job_.cutting.rough.depth_mm;
        switch (step.kind) {
            case OperationKind::Face:
                frame_.faces_end = !leansOverFace(finish);
                planFacing(facingTool(job_), depth);
                // The tailstock is engaged from here on.
                reaches_ = {reachOf(frame_, rough, job_.cutting.rough.allowance_mm)};
                if (!isSkipped(OperationKind::Finish, finish.number)) reaches_.push_back(reachOf(frame_, finish));
                if (isFacedToSize_) reaches_.push_back(faceReachOf(frame_, *facingTool(job_)));
                break;
            case OperationKind::CentreDrill: break;  // planned together with facing
            case OperationKind::Rough: {
                WorkStock laid = result_.after;
                if (auto passes = roughing(frame_, rough, laid)) keep(std::move(*passes), depth);
                break;
            }
            case OperationKind::SemiFinish: keep(semiFinishing(frame_, rough), depth); break;
            case OperationKind::Finish: finishAll(rough, finish, depth); break;
            case OperationKind::FinishBack:
            case OperationKind::Groove: removeRest(*job_.tool(step.tool)); break;
            case OperationKind::Thread:
                for (const DrawnThread& thread : clamping_.threads) cutThread(thread);
                break;
            case OperationKind::PartOff: partOff(); break;
        }
    }

    /// Finishing, in several passes where one would exceed the depth of cut.
    void finishAll(const JobTool& rough, const JobTool& finish, double depth)
    {
        std::optional<Operation> deep = deepPasses(frame_, rough, finish, result_.after);
        const bool is_split = deep && !isSkipped(*deep);
        if (is_split) keep(*std::move(deep), std::min(depth, deepFinish_mm));
        keep(finishing(frame_, finish), job_.cutting.rough.allowance_mm);
        if (!is_split) noteDeepFinish(rough, finish);
    }

    /// Facing and centre drilling. With a drill the tailstock is engaged afterwards; without one from the start.
    /// `facer`: null where the insert of no tool can face.
    void planFacing(const JobTool* facer, double depth)
    {
        std::optional<Operation> hole = centreDrilling(frame_);
        if (hole && isSkipped(*hole)) hole.reset();
        const bool has_tailstock = job_.setup.tailstock.has_value();
        frame_.has_tailstock = has_tailstock && !hole;
        if (hole) {
            frame_.faces_end = false;
            result_.after.setTailstock(false);
        }
        std::optional<Operation> face = facer ? facing(frame_, *facer) : std::nullopt;
        if (face && isSkipped(*face)) face.reset();
        if (face)
            keep(std::move(*face), std::min(depth, largestFacing_mm));
        else if (!facer && frame_.face_mm > faceLeft_mm)
            result_.notes.push_back({notes::noToolToFace, {{"face_mm", frame_.face_mm}}});
        else if (frame_.has_tailstock && frame_.face_mm > faceLeft_mm)
            result_.notes.push_back({notes::faceNotReached, {{"tool", std::int64_t{facer->number}}}});
        const bool is_faced = result_.operations.size() == 1;
        if (!is_faced) frame_.face_left_mm = frame_.face_mm;
        if (hole) {
            if (is_faced) frame_.face_left_mm = 0;
            keep(std::move(*hole), 0);
            hasCentreHole_ = true;
            frame_.has_tailstock = true;
            result_.after.setTailstock(true);
        } else if ((has_tailstock || !facer) && !is_faced && frame_.face_mm > faceLeft_mm) {
            frame_.faces_end = false;
        }
        isFacedToSize_ = is_faced && !has_tailstock && !frame_.faces_end;
        if (isFacedToSize_) frame_.face_left_mm = 0;
    }

    bool isSkipped(OperationKind kind, int tool) const
    {
        const SkippedOperation wanted{clamping_.is_mirrored ? 2 : 1, kind, tool};
        return std::find(skipped_.begin(), skipped_.end(), wanted) != skipped_.end();
    }
    bool isSkipped(const Operation& operation) const { return isSkipped(operation.kind, operation.tool); }

    void keep(Operation operation, double depth)
    {
        if (isSkipped(operation)) return;
        if (hasCentreHole_) {
            operation.stops_before = true;
            hasCentreHole_ = false;
        }
        const double before = result_.after.removed_mm3();
        result_.after.run(operation);
        result_.removed_mm3.push_back(result_.after.removed_mm3() - before);
        result_.depth_mm.push_back(depth);
        result_.operations.push_back(std::move(operation));
    }

    /// Plans all rest operations of one tool.
    void removeRest(const JobTool& tool)
    {
        if (tool.isDrill() || (use(tool) == ToolUse::FinishBack) == tool.isBlade()) return;
        if (isSkipped(tool.isBlade() ? OperationKind::Groove : OperationKind::FinishBack, tool.number)) return;
        const ToolReach reach = reachOf(frame_, tool);
        const std::vector<Unreached> rest = restOf(frame_.contour, reaches_);
        bool used = false;
        for (const Unreached& interval : improvableRests(frame_, rest, reaches_, reach)) {
            progress_.check();
            if (isCornerBeyondPart(interval)) continue;
            if (const DroppedOperation* dropped = droppedFor(tool, interval)) {
                refuse(tool, interval, dropped->cause, dropped->reason);
                continue;
            }
            std::optional<Operation> operation = tool.isBlade()
                                                     ? grooving(frame_, tool, reach, interval, result_.after)
                                                     : backTurning(frame_, tool, reach, interval, result_.after);
            if (!operation) continue;
            operation->rest_z_start_mm = interval.z_start_mm;
            if (tool.isBlade() && tool.reach_mm && depthOf(*operation, tool, result_.after) > *tool.reach_mm + 1e-6) {
                refuse(tool, interval, RestCause::Holder, LT_TEXT("Engine", "the blade does not reach so deep"));
                continue;
            }
            WorkStock tried = result_.after;
            if (const std::optional<Refusal> met = tried.run(*operation)) {
                refuseFor(tool, interval, *met);
                continue;
            }
            used = true;
            keep(std::move(*operation), tool.isBlade() ? *tool.width_mm : std::min(interval.left_mm, 2.0));
            // Intervals of refused operations stay unreached.
            ToolReach part = reach;
            const double margin = 2 * reach.radius_mm + reach.span_mm + 1;
            part.curve = clipped(reach.curve, interval.z_start_mm - margin, interval.z_end_mm + margin);
            cut_.push_back(std::move(part));
        }
        if (used) {
            reaches_.insert(reaches_.end(), std::make_move_iterator(cut_.begin()), std::make_move_iterator(cut_.end()));
            cut_.clear();
        }
    }

    const DroppedOperation* droppedFor(const JobTool& tool, const Unreached& interval) const
    {
        const int setup = clamping_.is_mirrored ? 2 : 1;
        const auto found = std::find_if(dropped_.begin(), dropped_.end(), [&](const DroppedOperation& dropped) {
            return dropped.setup == setup && dropped.tool == tool.number &&
                   std::abs(dropped.z_start_mm - interval.z_start_mm) < restSpacing_mm;
        });
        return found == dropped_.end() ? nullptr : &*found;
    }

    /// The corner beyond the end of the part, next to the parting cut, is not part of the drawing.
    bool isCornerBeyondPart(const Unreached& rest) const
    {
        return clamping_.parts_off && rest.cause == RestCause::NoseRadius &&
               rest.z_end_mm > frame_.contour.length_mm - restSpacing_mm;
    }

    static ToolUse use(const JobTool& tool) { return tool.use; }

    void refuseFor(const JobTool& tool, const Unreached& interval, const Refusal& met)
    {
        switch (met.kind) {
            case stock::FindingKind::Chuck:
                return refuse(tool, interval, RestCause::Chuck, LT_TEXT("Engine", "it would meet the chuck"));
            case stock::FindingKind::Tailstock:
                return refuse(tool, interval, RestCause::Tailstock, LT_TEXT("Engine", "it would meet the tailstock"));
            case stock::FindingKind::HolderInStock:
                return refuse(tool, interval, RestCause::Holder, LT_TEXT("Engine", "its holder would meet the stock"));
            case stock::FindingKind::RapidThroughStock:
                return refuse(tool, interval, RestCause::Holder,
                              LT_TEXT("Engine", "it would meet the stock on its way there"));
        }
    }

    void refuse(const JobTool& tool, const Unreached& interval, RestCause cause, Text reason)
    {
        result_.refused.push_back({tool.number, interval, cause, reason});
        result_.notes.push_back({notes::restCannot,
                                 {{"tool", std::int64_t{tool.number}},
                                  {"z_start_mm", interval.z_start_mm},
                                  {"z_end_mm", interval.z_end_mm},
                                  {"reason", reason}}});
    }

    void cutThread(const DrawnThread& thread)
    {
        const JobTool* tool = job_.toolFor(ToolUse::Thread);
        Threading cut;
        cut.reason = LT_TEXT("Engine", "there is no tool for threads");
        if (tool && isSkipped(OperationKind::Thread, tool->number))
            cut.reason = LT_TEXT("Engine", "it is switched off");
        else if (tool)
            cut = threading(frame_, *tool, thread, job_.max_rpm.value_or(assumedLimit_rpm));
        if (cut.operation) {
            WorkStock tried = result_.after;
            if (tried.run(*cut.operation)) {
                cut.operation.reset();
                cut.reason = LT_TEXT("Engine", "its tool would meet something");
            }
        }
        if (!cut.operation) {
            result_.notes.push_back(
                {notes::threadNotPlanned, {{"designation", thread.designation}, {"reason", cut.reason}}});
            return;
        }
        result_.notes.push_back({notes::threadCut,
                                 {{"designation", thread.designation},
                                  {"pitch_mm", *thread.pitch_mm},
                                  {"passes", std::int64_t{cut.passes}},
                                  {"depth_mm", cut.depth_mm}}});
        result_.threads_cut.push_back(thread);
        keep(*std::move(cut.operation), 0);
    }

    /// Notes on the finishing feed required by the Rz of the drawing.
    void noteRoughness(const JobTool& finish)
    {
        const double usual = finishFeed(job_, finish);
        double end = 0;
        for (const ShaftSegment& row : clamping_.part.segments) {
            const double begin = end;
            end += row.length_mm;
            if (!row.Rz_um) continue;
            const double feed = finishFeed(job_, finish, *row.Rz_um);
            const double ideal = idealRz_um(feed, finish.radius_mm(), finish.backAngle_deg());
            const Values place{{"z_start_mm", begin}, {"z_end_mm", end},      {"Rz_um", *row.Rz_um},
                               {"feed_mm_rev", feed}, {"ideal_Rz_um", ideal}, {"tool", std::int64_t{finish.number}}};
            if (ideal > *row.Rz_um * (1 + 1e-9))
                result_.notes.push_back({notes::roughnessNotReached, place});
            else if (feed < usual)
                result_.notes.push_back({notes::feedForRoughness, place});
        }
    }

    void partOff()
    {
        const JobTool& blade = *job_.partingBlade();
        WorkFrame end = frame_;
        end.contour.length_mm = clamping_.part_off_z_mm;
        const double behind = end.contour.length_mm + *blade.width_mm - job_.setup.chuck_face_z_mm;
        if (behind > 0)
            throw Error(errors::noSetupPossible,
                        {{"reason", LT_TEXT("Engine", "the blade that parts off stands within the chuck")},
                         {"missing_mm", behind}});
        keep(partingOff(end, blade), *blade.width_mm);
    }

    /// Note where finishing exceeds its depth of cut.
    void noteDeepFinish(const JobTool& rough, const JobTool& finish)
    {
        const Curve roughed = toolCurve(frame_, rough, job_.cutting.rough.allowance_mm),
                    finished = toolCurve(frame_, finish);
        double deepest = 0, z = 0;
        for (const CurvePiece& piece : finished)
            for (const Eigen::Vector2d& end : {piece.from, piece.to}) {
                if (end.x() < 0) continue;
                // Between both curves, normal to the surface.
                const double left = distanceTo(roughed, end, 1e4) - rough.radius_mm() + finish.radius_mm();
                if (left > deepest && piece.touch != Touch::Join) {
                    deepest = left;
                    z = end.x();
                }
            }
        if (deepest > deepFinish_mm)
            result_.notes.push_back(
                {notes::finishCutsDeep, {{"tool", std::int64_t{finish.number}}, {"depth_mm", deepest}, {"z_mm", z}}});
    }

    const Clamping& clamping_;
    const Job& job_;
    const std::vector<SkippedOperation>& skipped_;
    const std::vector<OperationStep>& order_;
    const std::vector<DroppedOperation>& dropped_;
    WorkFrame frame_;
    const Progress& progress_;
    SetupOperations result_;
    std::vector<ToolReach> reaches_, cut_;
    bool hasCentreHole_ = false;
    bool isFacedToSize_ = false;  ///< facing left nothing for the finish, whose tool cannot face
};

}  // namespace

SetupOperations planSetup(const Clamping& clamping, WorkStock stock, const std::vector<SkippedOperation>& skipped,
                          const std::vector<OperationStep>& order, const std::vector<DroppedOperation>& dropped,
                          const Progress& progress)
{
    return SetupPlanner(clamping, std::move(stock), skipped, order, dropped, progress).run();
}

WorkStock barOf(const Clamping& clamping)
{
    return WorkStock(stockOf(clamping.job), stockParameters(clamping.job));
}

bool leavesMoreThanCorners(const Clamping& clamping)
{
    const WorkFrame frame = frameOf(clamping.job, clamping.part);
    for (const Unreached& rest : restOf(frame.contour, {reachOf(frame, *clamping.job.toolFor(ToolUse::Finish))}))
        if (rest.cause != RestCause::NoseRadius) return true;
    return false;
}

}  // namespace lathelier::cam
