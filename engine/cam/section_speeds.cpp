#include "engine/cam/section_speeds.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/cam/cutting_data.h"
#include "engine/cam/plan_codes.h"
#include "engine/cam/work_frame.h"
#include "engine/core/units.h"
#include "engine/receptance/shaft/shaft_receptance.h"
#include "engine/stability/safe_speed.h"
#include "engine/stability/speed_choice.h"
#include "engine/stability/stability_codes.h"

namespace lathelier::cam {
namespace {

using Eigen::Vector2d;

constexpr double sectionFrom_hz = 20;
constexpr double sectionTo_hz = 4000;
constexpr double sectionStep_hz = 2;
constexpr double bodyPiece_mm = 1;
constexpr double longPass_mm = 10;
constexpr std::size_t mostRoughSpeeds = 12;
constexpr double longTaper_mm = 3;  // shorter cones and arcs are assigned to the next cylinder
constexpr double leastBackPass_mm = 3;

/// The speed at one place of a body.
struct ChosenSpeed {
    double speed_rpm = 0;
    std::optional<double> frequency_hz;
    int lobe = 0;
    bool is_stable = true;  ///< false: the speed of the cutting data is kept
    FrfPtr receptance;
    std::optional<double> stable_depth_mm;         ///< at that speed, where it is not stable
    std::optional<stability::SafeSpeed> at_depth;  ///< judged by the exact relation; none: no force or depth is known
};

/// What judges a speed.
struct Cut {
    std::optional<double> coefficient_N_mm2;  ///< none: the material is not known
    double depth_mm = 0;                      ///< on the radius
};

/// Force over area of the chip at a feed: Kienzle's k_c, taken as the coefficient of the lobes.
std::optional<double> coefficientOf(const WorkMaterial* material, double feed_mm_rev, double entering_angle_deg)
{
    const double h = feed_mm_rev * std::sin(entering_angle_deg * std::acos(-1.0) / 180);
    if (!material || !(h > 0)) return {};
    return material->k_c11_N_mm2 * std::pow(h, -material->m_c);
}

/// The limiting depth at one speed; none: unlimited.
std::optional<double> depthAt(const Frf& frf, double speed_rpm, double coefficient, stability::SpeedRelation relation)
{
    stability::LobeParameters lobes;
    lobes.cutting_coefficient_N_mm2 = coefficient;
    lobes.relation = relation;
    constexpr double speedNeighbourhood = 1e-3;
    lobes.speed_rpm = {{speed_rpm * (1 - speedNeighbourhood), speed_rpm * (1 + speedNeighbourhood)}};
    lobes.points = 3;
    const stability::LobeLimit limit = stability::limitOf(frf, lobes);
    double least = std::numeric_limits<double>::infinity();
    for (const double depth : limit.depth_mm)
        if (depth < least) least = depth;
    if (!std::isfinite(least)) return {};
    return least;
}

/// The speed at the depth of the cut; `chosen`: by the rule that was asked for.
stability::SafeSpeed atDepth(const Frf& frf, const Cut& cut, double chosen_rpm, double selected_rpm, double max_rpm,
                             const Progress& progress)
{
    stability::LobeParameters lobes;
    lobes.cutting_coefficient_N_mm2 = cut.coefficient_N_mm2;
    Interval range = stability::usualRange(selected_rpm);
    range.to = std::min(range.to, max_rpm);
    return stability::safeSpeed(frf, lobes, {chosen_rpm, cut.depth_mm, range}, progress);
}

/// The lobe whose pocket holds a speed, by the exact relation; 0: none.
int lobeAt(const Frf& frf, double speed_rpm)
{
    stability::SpeedParameters speed;
    speed.speed_rpm = speed_rpm;
    speed.relation = stability::SpeedRelation::Exact;
    try {
        return stability::chooseSpeed(frf, speed).k;
    } catch (const Error& error) {
        if (!(error.code() == errors::noStableSpeed)) throw;
        return 0;
    }
}

/// A speed by the rule of the papers that chatters at the depth of the cut.
void noteChatter(Notes& notes, double from_mm, double to_mm, const ChosenSpeed& chosen)
{
    if (!chosen.is_stable || !chosen.at_depth || chosen.at_depth->selected.is_stable) return;
    const stability::SafeSpeed& safe = *chosen.at_depth;
    const auto depth = [](const std::optional<double>& limit) { return limit ? Value(*limit) : Value(); };
    notes.push_back({notes::speedChatters,
                     {{"z_start_mm", from_mm},
                      {"z_end_mm", to_mm},
                      {"speed_rpm", chosen.speed_rpm},
                      {"depth_mm", safe.question.depth},
                      {"stable_depth_mm", depth(safe.selected.limit)},
                      {"exact_rpm", safe.best.speed_rpm},
                      {"exact_depth_mm", depth(safe.best.limit)}}});
}

void noteUnstable(Notes& notes, double from_mm, double to_mm, const ChosenSpeed& chosen)
{
    Values values{{"z_start_mm", from_mm},
                  {"z_end_mm", to_mm},
                  {"speed_rpm", chosen.speed_rpm},
                  {"stable_depth_mm", chosen.stable_depth_mm ? Value(*chosen.stable_depth_mm) : Value()}};
    if (chosen.stable_depth_mm) notes.push_back({notes::stableDepthHere, values});
    notes.push_back({notes::noStableSpeedHere, std::move(values)});
}

ChosenSpeed chosenFor(const Shaft& body, const std::optional<Material>& material, double z_mm, double diameter_mm,
                      double cutting_speed_m_min, const Cut& cut, const SpeedRequest& request, const Progress& progress)
{
    ChosenSpeed chosen;
    const double selected_rpm =
        std::min(request.max_rpm, std::round(stability::spindleSpeed(cutting_speed_m_min, diameter_mm)));
    chosen.speed_rpm = selected_rpm;
    receptance::ReceptanceParameters parameters;
    parameters.respond_z_mm = parameters.excite_z_mm = std::clamp(z_mm, 0.0, body.length_mm());
    parameters.step_hz = sectionStep_hz;
    parameters = receptance::withinLines(parameters, request.spindle, {sectionFrom_hz, sectionTo_hz});
    chosen.receptance = std::make_shared<const Frf>(receptance::receptanceOf(body, material.value_or(Material{}),
                                                                             parameters, {request.spindle, {}},
                                                                             progress, receptance::LinesOf::Refined));
    const Frf& frf = *chosen.receptance;
    stability::SpeedParameters speed;
    speed.diameter_mm = diameter_mm;
    speed.cutting_speed_m_min = cutting_speed_m_min;
    speed.relation = request.relation;
    try {
        const stability::SpeedResult result = stability::chooseSpeed(frf, speed);
        chosen.frequency_hz = result.frequency_hz;
        chosen.is_stable = result.recommended_rpm <= request.max_rpm;
        if (chosen.is_stable) {
            chosen.speed_rpm = std::round(result.recommended_rpm);
            chosen.lobe = result.k;
        }
    } catch (const Error& error) {
        if (!(error.code() == errors::noStableSpeed)) throw;
        chosen.is_stable = false;
    }
    if (!cut.coefficient_N_mm2) return chosen;
    if (chosen.is_stable && cut.depth_mm > 0) {
        chosen.at_depth = atDepth(frf, cut, chosen.speed_rpm, selected_rpm, request.max_rpm, progress);
        if (request.relation == stability::SpeedRelation::Exact) {
            chosen.is_stable = chosen.at_depth->best.is_stable;
            chosen.speed_rpm = chosen.is_stable ? std::round(chosen.at_depth->best.speed_rpm) : selected_rpm;
            chosen.lobe = chosen.is_stable ? lobeAt(frf, chosen.speed_rpm) : 0;
        }
    }
    if (!chosen.is_stable)
        chosen.stable_depth_mm = depthAt(frf, chosen.speed_rpm, *cut.coefficient_N_mm2, request.relation);
    return chosen;
}

/// Rows of the finish with one speed: a cylinder, or cones and arcs in a row.
struct SpeedStretch {
    double from_mm = 0, to_mm = 0, diameter_mm = 0;
    bool is_cylinder = false;
    double Rz_um = 0;  // roughness limit of the drawing; 0: not stated
};

/// Short cones and arcs are assigned to the next stretch, the last ones to the previous.
std::vector<SpeedStretch> stretchesOf(const Shaft& part)
{
    std::vector<SpeedStretch> found;
    double begin = 0;
    for (const ShaftSegment& row : part.segments) {
        const double end = begin + row.length_mm;
        const bool is_cylinder = row.arc_radius_mm.value_or(0) == 0 && row.start_diameter_mm == row.end_diameter_mm;
        const double largest = std::max(row.start_diameter_mm, row.end_diameter_mm);
        if (is_cylinder || found.empty() || found.back().is_cylinder)
            found.push_back({begin, end, largest, is_cylinder, row.Rz_um.value_or(0)});
        else
            found.back() = {found.back().from_mm, end, std::max(found.back().diameter_mm, largest), false, 0};
        begin = end;
    }
    std::erase_if(found, [](const SpeedStretch& stretch) {
        return !stretch.is_cylinder && stretch.to_mm - stretch.from_mm < longTaper_mm;
    });
    return found;
}

/// The worst ideal Rz of the finish between two places.
double rzOf(const Clamping& clamping, double from_mm, double to_mm)
{
    const JobTool& tool = *clamping.job.toolFor(ToolUse::Finish);
    double feed = 0, end = 0;
    for (const ShaftSegment& row : clamping.part.segments) {
        const double begin = end;
        end += row.length_mm;
        if (begin > to_mm - same_mm || end < from_mm + same_mm) continue;
        feed = std::max(feed, finishFeed(clamping.job, tool, row.Rz_um.value_or(0)));
    }
    if (feed == 0) feed = finishFeed(clamping.job, tool);
    return idealRz_um(feed, tool.radius_mm(), tool.backAngle_deg());
}

double cuttingSpeed(double rpm, double diameter_mm)
{
    return rpm * std::acos(-1.0) * diameter_mm / 1000;
}

std::vector<SectionSpeed> statedSections(const Clamping& clamping)
{
    std::vector<SectionSpeed> sections;
    double begin = 0;
    for (const SpeedSection& stated : clamping.job.sections) {
        SectionSpeed section;
        section.z_start_mm = begin;
        section.z_end_mm = stated.to_z_mm;
        section.speed_rpm = stated.rpm;
        double at = 0;
        for (const ShaftSegment& row : clamping.part.segments) {
            if (at < stated.to_z_mm - same_mm && at + row.length_mm > begin + same_mm)
                section.diameter_mm = std::max({section.diameter_mm, row.start_diameter_mm, row.end_diameter_mm});
            at += row.length_mm;
        }
        section.cutting_speed_m_min = cuttingSpeed(stated.rpm, section.diameter_mm);
        section.reason = LT_TEXT("Engine", "stated by the job");
        section.Rz_um = rzOf(clamping, begin, stated.to_z_mm);
        begin = stated.to_z_mm;
        sections.push_back(section);
    }
    return sections;
}

/// Speed of a cylinder from the workpiece dynamics.
void setSpeedOf(SectionSpeed& section, const SpeedStretch& cylinder, const Clamping& clamping,
                const SpeedRequest& request, const WorkStock& before_finish, Notes& notes, const Progress& progress)
{
    const JobTool& tool = *clamping.job.toolFor(ToolUse::Finish);
    const Cut cut{coefficientOf(request.material, finishFeed(clamping.job, tool, cylinder.Rz_um),
                                tool.entering_angle_deg.value_or(90)),
                  clamping.job.cutting.rough.allowance_mm};
    const Shaft body = request.model == PartModel::Finished
                           ? request.whole
                           : before_finish.bodyUpTo(clamping.job.setup.chuck_face_z_mm, bodyPiece_mm);
    const ChosenSpeed chosen = chosenFor(body, clamping.part.material, cylinder.from_mm, cylinder.diameter_mm,
                                         section.constant_m_min, cut, request, progress);
    section.speed_rpm = chosen.speed_rpm;
    section.cutting_speed_m_min = cuttingSpeed(chosen.speed_rpm, cylinder.diameter_mm);
    section.frequency_hz = chosen.frequency_hz;
    section.lobe = chosen.lobe;
    section.receptance = chosen.receptance;
    section.stable_depth_mm = chosen.stable_depth_mm;
    section.reason = chosen.is_stable ? LT_TEXT("Engine", "stability lobes")
                                      : LT_TEXT("Engine", "no stable speed, that of the job is kept");
    if (!chosen.is_stable) noteUnstable(notes, section.z_start_mm, section.z_end_mm, chosen);
    noteChatter(notes, section.z_start_mm, section.z_end_mm, chosen);
}

}  // namespace

std::vector<SectionSpeed> finishSections(const Clamping& clamping, const SpeedRequest& request,
                                         const WorkStock& before_finish, Notes& notes, const Progress& progress)
{
    if (!clamping.job.sections.empty()) return statedSections(clamping);
    const double speed = clamping.job.cutting.finish.cutting_speed_m_min, length = clamping.part.length_mm();
    std::vector<SpeedStretch> stretches = request.spindle ? stretchesOf(clamping.part) : std::vector<SpeedStretch>{};
    const auto is_cylinder = [](const SpeedStretch& stretch) { return stretch.is_cylinder; };
    if (std::none_of(stretches.begin(), stretches.end(), is_cylinder)) {
        double largest = 0;
        for (const ShaftSegment& row : clamping.part.segments)
            largest = std::max({largest, row.start_diameter_mm, row.end_diameter_mm});
        stretches = {{0, length, largest, false, 0}};
    }
    std::vector<SectionSpeed> sections;
    double begin = 0;
    for (std::size_t i = 0; i < stretches.size(); ++i) {
        const SpeedStretch& stretch = stretches[i];
        const double share = 1.0 / static_cast<double>(stretches.size());
        SectionSpeed section;
        section.z_start_mm = begin;
        section.z_end_mm = i + 1 == stretches.size() ? length : stretch.to_mm;
        section.diameter_mm = stretch.diameter_mm;
        section.cutting_speed_m_min = section.constant_m_min = speed;
        section.max_rpm = request.max_rpm;
        section.Rz_um = rzOf(clamping, section.z_start_mm, section.z_end_mm);
        section.reason = LT_TEXT("Engine", "constant cutting speed of the job");
        if (stretch.is_cylinder)
            setSpeedOf(section, stretch, clamping, request, before_finish, notes,
                       progress.part(share * static_cast<double>(i), share * static_cast<double>(i + 1)));
        begin = section.z_end_mm;
        sections.push_back(section);
    }
    return sections;
}

void setBackSpeed(Operation& back, const Clamping& clamping, const SpeedRequest& request, const WorkStock& before,
                  Notes& notes, const Progress& progress)
{
    if (!request.spindle) return;
    const JobTool* tool = clamping.job.tool(back.tool);
    double longest = leastBackPass_mm, free_z = 0, chuck_z = 0, radius = 0;
    for (std::size_t k = 1; tool && k < back.moves.size(); ++k) {
        const Vector2d start = back.moves[k - 1].to, end = back.moves[k].to;
        if (back.moves[k].kind != CutKind::Line || std::abs(end.y() - start.y()) > same_mm || end.y() < 1) continue;
        if (start.x() - end.x() < longest) continue;
        longest = start.x() - end.x();
        free_z = end.x();
        chuck_z = start.x();
        radius = end.y();
    }
    if (radius == 0) return;
    const Cut cut{
        coefficientOf(request.material, finishFeed(clamping.job, *tool), tool->entering_angle_deg.value_or(90)),
        clamping.job.cutting.rough.allowance_mm};
    const Shaft body = request.model == PartModel::Finished
                           ? request.whole
                           : before.bodyUpTo(clamping.job.setup.chuck_face_z_mm, bodyPiece_mm);
    const ChosenSpeed chosen = chosenFor(body, clamping.part.material, std::max(0.0, free_z), 2 * radius,
                                         back.cutting_speed_m_min, cut, request, progress);
    back.speed_rpm = chosen.speed_rpm;
    if (!chosen.is_stable) return noteUnstable(notes, std::max(0.0, free_z), chuck_z, chosen);
    noteChatter(notes, std::max(0.0, free_z), chuck_z, chosen);
    notes.push_back({notes::backSpeed,
                     {{"z_start_mm", std::max(0.0, free_z)},
                      {"z_end_mm", chuck_z},
                      {"tool", std::int64_t{back.tool}},
                      {"speed_rpm", chosen.speed_rpm},
                      {"frequency_hz", chosen.frequency_hz ? Value(*chosen.frequency_hz) : Value()},
                      {"lobe", std::int64_t{chosen.lobe}}}});
}

void setRoughSpeeds(Operation& rough, const Clamping& clamping, const SpeedRequest& request, WorkStock before,
                    Notes& notes, const Progress& progress)
{
    if (!request.spindle) return;
    const double speed = rough.cutting_speed_m_min;
    const JobTool* tool = clamping.job.tool(rough.tool);
    const RoughCutting& data = clamping.job.cutting.rough;
    const std::optional<double> coefficient =
        coefficientOf(request.material, tool && tool->feed_mm_rev ? *tool->feed_mm_rev : data.feed_mm_rev,
                      tool ? tool->entering_angle_deg.value_or(90) : 90);
    double above_mm = NAN;  // radius of the pass before
    std::size_t count = 0, done = 0;
    Operation part = rough;
    for (std::size_t k = 1; k < rough.moves.size() && count < mostRoughSpeeds; ++k) {
        CutMove& move = rough.moves[k];
        const Vector2d start = rough.moves[k - 1].to;
        const bool is_pass = move.kind == CutKind::Line && std::abs(move.to.y() - start.y()) < same_mm &&
                             move.to.x() - start.x() > longPass_mm && move.to.y() > 1;
        if (!is_pass) continue;
        progress.check();
        part.moves.assign(rough.moves.begin() + static_cast<std::ptrdiff_t>(done == 0 ? 0 : done - 1),
                          rough.moves.begin() + static_cast<std::ptrdiff_t>(k + 1));
        if (done > 0) part.moves.front().kind = CutKind::Rapid;
        done = k + 1;
        before.run(part);
        const Shaft body = before.bodyUpTo(clamping.job.setup.chuck_face_z_mm, bodyPiece_mm);
        // Depth of the pass: from the pass before it, at most that of the cutting data.
        const double step_mm = above_mm - move.to.y();
        const Cut cut{coefficient, step_mm > same_mm && step_mm < data.depth_mm ? step_mm : data.depth_mm};
        above_mm = move.to.y();
        const ChosenSpeed chosen = chosenFor(body, clamping.part.material, std::max(0.0, start.x()), 2 * move.to.y(),
                                             speed, cut, request, progress);
        if (count++ == 0) {
            rough.speed_rpm = chosen.speed_rpm;
        } else {
            std::size_t first = k;  // the speed changes during the return move
            while (first > 1 && rough.moves[first - 1].kind == CutKind::Rapid) --first;
            rough.moves[first].speed_rpm = chosen.speed_rpm;
        }
        if (!chosen.is_stable) noteUnstable(notes, start.x(), move.to.x(), chosen);
        noteChatter(notes, start.x(), move.to.x(), chosen);
    }
}

}  // namespace lathelier::cam
