#include "engine/cam/section_speeds.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/cam/cutting_data.h"
#include "engine/cam/plan_codes.h"
#include "engine/cam/work_frame.h"
#include "engine/receptance/shaft_receptance.h"
#include "engine/stability/speed_choice.h"
#include "engine/stability/stability_codes.h"

namespace lathelier::cam {
namespace {

using Eigen::Vector2d;

constexpr double kFrom_hz = 20;
constexpr double kTo_hz = 4000;
constexpr double kStep_hz = 2;
constexpr double kBodyPiece_mm = 1;
constexpr double kLongPass_mm = 10;
constexpr std::size_t kMostRoughSpeeds = 12;
constexpr double kSame_mm = 1e-6;
constexpr double kLeastLeft_mm = 0.1;  // of a cylinder, at the speed before
constexpr double kLift_mm = 0.5;

/// The speed at one place of a body.
struct Chosen {
    double speed_rpm = 0;
    std::optional<double> frequency_hz;
    int lobe = 0;
    bool is_stable = true;  ///< false: the catalogue's speed is kept
    FrfPtr receptance;
    std::optional<double> stable_depth_mm;  ///< at that speed, where it is not stable
};

/// Force over area of the chip at a feed: Kienzle's k_c, taken as the coefficient of the lobes.
std::optional<double> coefficientOf(const WorkMaterial* material, double feed_mm_rev, double entering_angle_deg)
{
    const double h = feed_mm_rev * std::sin(entering_angle_deg * std::acos(-1.0) / 180);
    if (!material || !(h > 0)) return {};
    return material->k_c11_N_mm2 * std::pow(h, -material->m_c);
}

/// The limiting depth at one speed; none: nothing limits it.
std::optional<double> depthAt(const Frf& frf, double speed_rpm, double coefficient, stability::SpeedRelation relation)
{
    stability::LobeParameters lobes;
    lobes.cutting_coefficient_N_mm2 = coefficient;
    lobes.relation = relation;
    constexpr double kAround = 1e-3;
    lobes.speed_rpm = {{speed_rpm * (1 - kAround), speed_rpm * (1 + kAround)}};
    lobes.points = 3;
    const stability::LobeLimit limit = stability::limitOf(frf, lobes);
    double least = std::numeric_limits<double>::infinity();
    for (const double depth : limit.depth_mm)
        if (depth < least) least = depth;
    if (!std::isfinite(least)) return {};
    return least;
}

void noteUnstable(Notes& notes, double from_mm, double to_mm, const Chosen& chosen)
{
    Values values{{"z_start_mm", from_mm},
                  {"z_end_mm", to_mm},
                  {"speed_rpm", chosen.speed_rpm},
                  {"stable_depth_mm", chosen.stable_depth_mm ? Value(*chosen.stable_depth_mm) : Value()}};
    if (chosen.stable_depth_mm) notes.push_back({notes::stableDepthHere, values});
    notes.push_back({notes::noStableSpeedHere, std::move(values)});
}

Chosen chosenFor(const Shaft& body, const std::optional<Material>& material, double z_mm, double diameter_mm,
                 double cutting_speed_m_min, const std::optional<double>& coefficient, const SpeedRequest& request,
                 const Progress& progress)
{
    Chosen chosen;
    chosen.speed_rpm = std::min(request.max_rpm, std::round(stability::spindleSpeed(cutting_speed_m_min, diameter_mm)));
    receptance::ReceptanceParameters parameters;
    parameters.respond_z_mm = parameters.excite_z_mm = std::clamp(z_mm, 0.0, body.length_mm());
    parameters.from_hz = kFrom_hz;
    parameters.to_hz = kTo_hz;
    parameters.step_hz = kStep_hz;
    chosen.receptance = std::make_shared<const Frf>(
        receptance::receptanceOf(body, material.value_or(Material{}), parameters, {request.spindle, {}}, progress));
    const Frf& frf = *chosen.receptance;
    stability::SpeedParameters speed;
    speed.diameter_mm = diameter_mm;
    speed.cutting_speed_m_min = cutting_speed_m_min;
    speed.relation = request.relation;
    try {
        const stability::SpeedResult result = stability::chooseSpeed(frf, speed);
        chosen.frequency_hz = result.frequency_hz;
        chosen.lobe = result.k;
        if (result.recommended_rpm <= request.max_rpm)
            chosen.speed_rpm = std::round(result.recommended_rpm);
        else
            chosen.is_stable = false;
    } catch (const Error& error) {
        if (!(error.code() == errors::noStableSpeed)) throw;
        chosen.is_stable = false;
    }
    if (!chosen.is_stable && coefficient)
        chosen.stable_depth_mm = depthAt(frf, chosen.speed_rpm, *coefficient, request.relation);
    return chosen;
}

/// A row of the part that is one cylinder; faces, chamfers and fillets belong to what they lead to.
struct Cylinder {
    double from_mm = 0, to_mm = 0, diameter_mm = 0;
};

std::vector<Cylinder> cylindersOf(const Shaft& part)
{
    std::vector<Cylinder> found;
    double begin = 0;
    for (const ShaftSegment& row : part.segments) {
        const double end = begin + row.length_mm;
        if (row.arc_radius_mm.value_or(0) == 0 && row.start_diameter_mm == row.end_diameter_mm)
            found.push_back({begin, end, row.start_diameter_mm});
        begin = end;
    }
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
        if (begin > to_mm - kSame_mm || end < from_mm + kSame_mm) continue;
        feed = std::max(feed, finishFeed(clamping.job, tool, row.Rz_um.value_or(0)));
    }
    if (feed == 0) feed = finishFeed(clamping.job, tool);
    return idealRz_um(feed, tool.radius_mm(), tool.backAngle_deg());
}

double cuttingSpeed(double rpm, double diameter_mm)
{
    return rpm * std::acos(-1.0) * diameter_mm / 1000;
}

/// A move along a cylinder toward the chuck.
bool isAlong(const CutMove& move, const Vector2d& start)
{
    return move.kind == CutKind::Line && std::abs(move.to.y() - start.y()) < kSame_mm &&
           move.to.x() > start.x() + kSame_mm;
}

/// Does the drawing state limits or roughness of the row at z, or what is cut on it?
bool isParticular(const Shaft& part, double z_mm)
{
    double end = 0;
    for (const ShaftSegment& row : part.segments) {
        end += row.length_mm;
        if (z_mm <= end) return isToleranced(row) || row.Rz_um.has_value();
    }
    return false;
}

/// The place of a boundary in a path: moves from `first` on lead beyond it; those up to `end` are faces, chamfers and
/// fillets before the next cylinder.
struct Crossing {
    std::size_t first = 0, end = 0;
    double length_mm = 0;  // of these moves
};

std::optional<Crossing> crossingOf(std::vector<CutMove>& moves, double z)
{
    for (std::size_t k = 1; k < moves.size(); ++k) {
        const Vector2d start = moves[k - 1].to;
        if (moves[k].kind == CutKind::Rapid) continue;
        if (!(moves[k].to.x() > z + kSame_mm || (moves[k].to.x() > z - kSame_mm && start.x() > z - kSame_mm))) continue;
        if (isAlong(moves[k], start) && start.x() < z - kSame_mm) {  // the boundary lies within a cylinder
            CutMove before = moves[k];
            before.to.x() = z;
            moves.insert(moves.begin() + static_cast<std::ptrdiff_t>(k), before);
            ++k;
        }
        Crossing crossing{k, k, 0};
        while (crossing.end < moves.size() && moves[crossing.end].kind != CutKind::Rapid &&
               !isAlong(moves[crossing.end], moves[crossing.end - 1].to)) {
            crossing.length_mm += (moves[crossing.end].to - moves[crossing.end - 1].to).norm();
            ++crossing.end;
        }
        return crossing;
    }
    return {};
}

void changeSpeed(std::vector<CutMove>& moves, double from_rpm, double to_rpm, double z, const Shaft& part)
{
    const std::optional<Crossing> crossing = crossingOf(moves, z);
    if (!crossing) return;
    const std::size_t k = crossing->first;
    const double ramp =
        moves[k].feed_mm_rev * (from_rpm + to_rpm) / 120 * std::abs(to_rpm - from_rpm) / spindleRamp_rpm_s;
    const double missing = ramp - crossing->length_mm;
    const auto at = [&moves](std::size_t i) { return moves.begin() + static_cast<std::ptrdiff_t>(i); };
    if (missing <= 0 || crossing->end == moves.size()) {
        moves[k].speed_rpm = to_rpm;
        return;
    }
    CutMove& before = moves[k - 1];
    const bool is_cylinder = k >= 2 && isAlong(before, moves[k - 2].to);
    if (is_cylinder && before.to.x() - moves[k - 2].to.x() > missing + kLeastLeft_mm && !isParticular(part, z)) {
        CutMove first = before;
        first.to.x() -= missing;
        before.speed_rpm = to_rpm;
        moves.insert(at(k - 1), first);
        return;
    }
    // Where the way between both cylinders is highest nothing stands above the tool.
    const bool is_end = crossing->end > k && moves[crossing->end - 1].to.y() > before.to.y();
    const std::size_t place = is_end ? crossing->end : k;
    CutMove down = moves[place - 1];
    down.kind = CutKind::Line;
    down.feed_mm_rev = moves[k].feed_mm_rev;
    down.speed_rpm.reset();
    CutMove up = down;
    up.to.y() += std::max(kLift_mm, missing / 2);
    if (is_end)
        moves[k].speed_rpm = to_rpm;
    else
        up.speed_rpm = to_rpm;
    moves.insert(at(place), {up, down});
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
            if (at < stated.to_z_mm - kSame_mm && at + row.length_mm > begin + kSame_mm)
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

}  // namespace

std::vector<SectionSpeed> finishSections(const Clamping& clamping, const SpeedRequest& request,
                                         const WorkStock& before_finish, Notes& notes, const Progress& progress)
{
    if (!clamping.job.sections.empty()) return statedSections(clamping);
    const double speed = clamping.job.cutting.finish.cutting_speed_m_min, length = clamping.part.length_mm();
    std::vector<Cylinder> cylinders = request.spindle ? cylindersOf(clamping.part) : std::vector<Cylinder>{};
    std::vector<SectionSpeed> sections;
    if (cylinders.empty()) {
        SectionSpeed section;
        section.z_end_mm = length;
        for (const ShaftSegment& row : clamping.part.segments)
            section.diameter_mm = std::max({section.diameter_mm, row.start_diameter_mm, row.end_diameter_mm});
        section.cutting_speed_m_min = speed;
        section.reason = LT_TEXT("Engine", "constant cutting speed of the job");
        section.Rz_um = rzOf(clamping, 0, length);
        return {section};
    }
    const JobTool& tool = *clamping.job.toolFor(ToolUse::Finish);
    const std::optional<double> coefficient =
        coefficientOf(request.material, finishFeed(clamping.job, tool), tool.entering_angle_deg.value_or(90));
    double begin = 0;
    for (std::size_t i = 0; i < cylinders.size(); ++i) {
        const Cylinder& cylinder = cylinders[i];
        const Shaft body = request.model == PartModel::Finished
                               ? request.whole
                               : before_finish.bodyUpTo(clamping.job.setup.chuck_face_z_mm, kBodyPiece_mm);
        const double share = 1.0 / static_cast<double>(cylinders.size());
        const Chosen chosen =
            chosenFor(body, clamping.part.material, cylinder.from_mm, cylinder.diameter_mm, speed, coefficient, request,
                      progress.part(share * static_cast<double>(i), share * static_cast<double>(i + 1)));
        SectionSpeed section;
        section.z_start_mm = begin;
        section.z_end_mm = i + 1 == cylinders.size() ? length : cylinder.to_mm;
        section.diameter_mm = cylinder.diameter_mm;
        section.speed_rpm = chosen.speed_rpm;
        section.cutting_speed_m_min = cuttingSpeed(chosen.speed_rpm, cylinder.diameter_mm);
        section.frequency_hz = chosen.frequency_hz;
        section.lobe = chosen.lobe;
        section.receptance = chosen.receptance;
        section.Rz_um = rzOf(clamping, section.z_start_mm, section.z_end_mm);
        section.stable_depth_mm = chosen.stable_depth_mm;
        section.reason = chosen.is_stable ? LT_TEXT("Engine", "stability lobes")
                                          : LT_TEXT("Engine", "no stable speed, that of the job is kept");
        if (!chosen.is_stable) noteUnstable(notes, section.z_start_mm, section.z_end_mm, chosen);
        begin = section.z_end_mm;
        sections.push_back(section);
    }
    return sections;
}

void setFinishSpeeds(Operation& finish, const std::vector<SectionSpeed>& sections, const Shaft& part)
{
    if (sections.empty() || !sections.front().speed_rpm) return;
    finish.speed_rpm = sections.front().speed_rpm;
    for (std::size_t i = 0; i + 1 < sections.size(); ++i)
        if (*sections[i].speed_rpm != *sections[i + 1].speed_rpm)
            changeSpeed(finish.moves, *sections[i].speed_rpm, *sections[i + 1].speed_rpm, sections[i].z_end_mm, part);
}

void setRoughSpeeds(Operation& rough, const Clamping& clamping, const SpeedRequest& request, WorkStock before,
                    Notes& notes, const Progress& progress)
{
    if (!request.spindle) return;
    const double speed = rough.cutting_speed_m_min;
    const JobTool* tool = clamping.job.tool(rough.tool);
    const std::optional<double> coefficient = coefficientOf(
        request.material, tool && tool->feed_mm_rev ? *tool->feed_mm_rev : clamping.job.cutting.rough.feed_mm_rev,
        tool ? tool->entering_angle_deg.value_or(90) : 90);
    std::size_t count = 0, done = 0;
    Operation part = rough;
    for (std::size_t k = 1; k < rough.moves.size() && count < kMostRoughSpeeds; ++k) {
        CutMove& move = rough.moves[k];
        const Vector2d start = rough.moves[k - 1].to;
        const bool is_pass = move.kind == CutKind::Line && std::abs(move.to.y() - start.y()) < kSame_mm &&
                             move.to.x() - start.x() > kLongPass_mm && move.to.y() > 1;
        if (!is_pass) continue;
        progress.check();
        part.moves.assign(rough.moves.begin() + static_cast<std::ptrdiff_t>(done == 0 ? 0 : done - 1),
                          rough.moves.begin() + static_cast<std::ptrdiff_t>(k + 1));
        if (done > 0) part.moves.front().kind = CutKind::Rapid;
        done = k + 1;
        before.run(part);
        const Shaft body = before.bodyUpTo(clamping.job.setup.chuck_face_z_mm, kBodyPiece_mm);
        const Chosen chosen = chosenFor(body, clamping.part.material, std::max(0.0, start.x()), 2 * move.to.y(), speed,
                                        coefficient, request, progress);
        if (count++ == 0) {
            rough.speed_rpm = chosen.speed_rpm;
        } else {
            std::size_t first = k;  // on the way back to the front the spindle has time
            while (first > 1 && rough.moves[first - 1].kind == CutKind::Rapid) --first;
            rough.moves[first].speed_rpm = chosen.speed_rpm;
        }
        if (!chosen.is_stable) noteUnstable(notes, start.x(), move.to.x(), chosen);
    }
}

}  // namespace lathelier::cam
