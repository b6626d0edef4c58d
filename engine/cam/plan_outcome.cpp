#include "engine/cam/plan_outcome.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "engine/cam/cam_codes.h"
#include "engine/cam/plan_codes.h"
#include "engine/core/units.h"
#include "engine/gcode/controls/controls.h"

namespace lathelier::cam {
namespace {

constexpr double endFaceDepth_mm = 0.02;  ///< of the end face, along z

Interval drawnPlace(const SetupPlan& setup, double length_mm, double from_mm, double to_mm)
{
    if (!setup.clamping.is_mirrored) return {from_mm, to_mm};
    return {length_mm - to_mm, length_mm - from_mm};
}

/// Cause from the nose curves; for the rest of a refused operation, the cause of the refusal.
void assignCause(RestInterval& rest, const TurningPlan& plan)
{
    const auto meets = [&](const SetupPlan& setup, const Unreached& unreached) {
        const Interval place = drawnPlace(setup, plan.part.length_mm(), unreached.z_start_mm, unreached.z_end_mm);
        return rest.z_start_mm <= place.to && rest.z_end_mm >= place.from;
    };
    for (const SetupPlan& setup : plan.setups) {
        for (const Unreached& unreached : setup.predicted) {
            if (!meets(setup, unreached)) continue;
            if (unreached.cause == RestCause::Tailstock && rest.cause == RestCause::Uncut)
                rest.cause = RestCause::Tailstock;  // the residual material is bounded by the bar
            if (std::abs(unreached.left_mm - rest.left_mm) > gougeLimit_mm) continue;
            rest.cause = unreached.cause;
            rest.tool = unreached.tool;
            rest.nose_radius_mm.reset();
            if (unreached.cause == RestCause::NoseRadius) rest.nose_radius_mm = unreached.tool_radius_mm;
            rest.corner_radius_mm = unreached.fillet_radius_mm;
        }
        for (const RefusedOperation& refused : setup.refused)
            if (meets(setup, refused.rest) && rest.left_mm <= refused.rest.left_mm + gougeLimit_mm)
                rest.cause = refused.cause;
        const bool is_face = rest.z_start_mm < endFaceDepth_mm && rest.z_end_mm < endFaceDepth_mm;
        if (is_face && rest.cause == RestCause::Uncut && setup.clamping.job.setup.tailstock)
            rest.cause = RestCause::Tailstock;
    }
}

std::optional<Verdict> verdictOf(const TurningPlan& plan)
{
    const auto is_open = [](const SetupPlan& setup) { return !setup.check.stock.has_value(); };
    if (std::any_of(plan.setups.begin(), plan.setups.end(), is_open)) return std::nullopt;
    if (plan.is_refused || !plan.rest.empty() || !plan.not_made.empty() ||
        contains(plan.planning, notes::noStableSpeedHere))
        return Verdict::Fail;
    const auto is_blind = [](const SetupPlan& setup) { return unknownToolOf(setup.check) != 0; };
    return std::any_of(plan.setups.begin(), plan.setups.end(), is_blind) ? Verdict::Undecided : Verdict::Pass;
}

}  // namespace

CheckParameters checkParametersOf(const Clamping& clamping, std::size_t count, const TurningInputs& inputs)
{
    CheckParameters parameters;
    parameters.keeps_outlines = inputs.keeps_outlines;
    if (clamping.is_mirrored) {
        parameters.setup = 2;
        parameters.work_length_mm = clamping.work_length_mm;
        parameters.chuck_face_z_mm = clamping.job.setup.chuck_face_z_mm;
    } else if (count > 1) {
        parameters.finished_to_mm = clamping.finished_to_mm;
    }
    return parameters;
}

CheckResult checkProgram(const Shaft& part, const Job& job, const GivenProgram& program, const GivenProgram* before,
                         CheckParameters parameters, const Post& post, const Progress& progress)
{
    const auto controlOf = [&](const GivenProgram& given) { return given.is_of_post ? post.control : nullptr; };
    CheckInputs inputs;
    inputs.correction = program.correction;
    if (before) {
        inputs.before = before->text;
        inputs.before_control = controlOf(*before);
    }
    const gcode::ControlPtr control = controlOf(program);
    parameters.program.control = control;
    parameters.program.dialect = control ? control->key : gcode::automaticControl;
    return checkTurning(program.text, part, job, parameters, inputs, progress);
}

int unknownToolOf(const CheckResult& check)
{
    for (const Note& note : check.notes) {
        if (!(note.code == notes::toolNotInJob)) continue;
        const Value* tool = find(note.values, "tool");
        const auto* number = tool ? std::get_if<std::int64_t>(tool) : nullptr;
        return number && *number != 0 ? static_cast<int>(*number) : -1;
    }
    return 0;
}

void conclude(TurningPlan& plan)
{
    plan.notes = plan.planning;
    for (const SetupPlan& setup : plan.setups)
        std::copy_if(setup.check.notes.begin(), setup.check.notes.end(), std::back_inserter(plan.notes),
                     [](const Note& note) { return !(note.code == notes::drawnNotChecked); });  // TurningPlan::not_made
    plan.rest.clear();
    const SetupPlan& last = plan.setups.back();
    for (RestInterval rest : last.check.rest) {
        const Interval place = drawnPlace(last, plan.part.length_mm(), rest.z_start_mm, rest.z_end_mm);
        rest.z_start_mm = place.from;
        rest.z_end_mm = place.to;
        assignCause(rest, plan);
        plan.rest.push_back(rest);
    }
    // The ring left around a tailstock on the first face lies outside the stretch turned in the second clamping.
    if (plan.setups.size() > 1)
        for (RestInterval rest : plan.setups.front().check.rest) {
            const bool is_seen = std::any_of(plan.rest.begin(), plan.rest.end(), [&](const RestInterval& other) {
                return other.z_start_mm <= rest.z_end_mm && other.z_end_mm >= rest.z_start_mm;
            });
            if (is_seen || rest.z_end_mm > endFaceDepth_mm) continue;
            assignCause(rest, plan);
            plan.rest.push_back(rest);
        }
    std::stable_sort(plan.rest.begin(), plan.rest.end(),
                     [](const RestInterval& a, const RestInterval& b) { return a.z_start_mm < b.z_start_mm; });
    plan.left_max_mm = 0;
    for (const RestInterval& rest : plan.rest) plan.left_max_mm = std::max(plan.left_max_mm, rest.left_mm);
    plan.is_refused = std::any_of(plan.setups.begin(), plan.setups.end(), [](const SetupPlan& setup) {
        return setup.check.path.has_errors || !setup.check.findings.empty() ||
               setup.check.gouge_um > um_per_mm * gougeLimit_mm;
    });
    plan.verdict = verdictOf(plan);
}

}  // namespace lathelier::cam
