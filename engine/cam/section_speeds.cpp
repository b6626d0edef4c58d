#include "engine/cam/section_speeds.h"

#include <algorithm>
#include <cmath>

#include "engine/cam/cutting_data.h"
#include "engine/cam/plan_codes.h"
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

/// The speed at one place of a body.
struct Chosen {
    double speed_rpm = 0;
    std::optional<double> frequency_hz;
    int lobe = 0;
    bool is_stable = true;  ///< false: the catalogue's speed is kept
    FrfPtr receptance;
};

Chosen chosenFor(const Shaft& body, const std::optional<Material>& material, double z_mm, double diameter_mm,
                 double cutting_speed_m_min, const SpeedRequest& request, const Progress& progress)
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
        if (!row.arc_radius_mm.value_or(0) && row.start_diameter_mm == row.end_diameter_mm)
            found.push_back({begin, end, row.start_diameter_mm});
        begin = end;
    }
    return found;
}

double rzOf(const Clamping& clamping)
{
    const JobTool& tool = *clamping.job.toolFor(ToolUse::Finish);
    const double feed = tool.feed_mm_rev.value_or(clamping.job.cutting.finish.feed_mm_rev);
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
            if (at < stated.to_z_mm - kSame_mm && at + row.length_mm > begin + kSame_mm)
                section.diameter_mm = std::max({section.diameter_mm, row.start_diameter_mm, row.end_diameter_mm});
            at += row.length_mm;
        }
        section.cutting_speed_m_min = cuttingSpeed(stated.rpm, section.diameter_mm);
        section.reason = LT_TEXT("Engine", "stated by the job");
        section.Rz_um = rzOf(clamping);
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
        section.Rz_um = rzOf(clamping);
        return {section};
    }
    double begin = 0;
    for (std::size_t i = 0; i < cylinders.size(); ++i) {
        const Cylinder& cylinder = cylinders[i];
        const Shaft body = request.model == PartModel::Finished
                               ? request.whole
                               : before_finish.bodyUpTo(clamping.job.setup.chuck_face_z_mm, kBodyPiece_mm);
        const double share = 1.0 / static_cast<double>(cylinders.size());
        const Chosen chosen =
            chosenFor(body, clamping.part.material, cylinder.from_mm, cylinder.diameter_mm, speed, request,
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
        section.Rz_um = rzOf(clamping);
        section.reason = chosen.is_stable ? LT_TEXT("Engine", "stability lobes")
                                          : LT_TEXT("Engine", "no stable speed, that of the job is kept");
        if (!chosen.is_stable)
            notes.push_back({notes::noStableSpeedHere,
                             {{"z_start_mm", section.z_start_mm},
                              {"z_end_mm", section.z_end_mm},
                              {"speed_rpm", chosen.speed_rpm}}});
        begin = section.z_end_mm;
        sections.push_back(section);
    }
    return sections;
}

void setFinishSpeeds(Operation& finish, const std::vector<SectionSpeed>& sections)
{
    if (sections.empty() || !sections.front().speed_rpm) return;
    finish.speed_rpm = sections.front().speed_rpm;
    for (std::size_t i = 0; i + 1 < sections.size(); ++i) {
        const double from = *sections[i].speed_rpm, to = *sections[i + 1].speed_rpm, z = sections[i].z_end_mm;
        if (from == to) continue;
        std::vector<CutMove>& moves = finish.moves;
        for (std::size_t k = 1; k < moves.size(); ++k) {
            const Vector2d start = moves[k - 1].to;
            const bool passes =
                moves[k].kind != CutKind::Rapid &&
                (moves[k].to.x() > z + kSame_mm || (moves[k].to.x() > z - kSame_mm && start.x() > z - kSame_mm));
            if (!passes) continue;
            const double ramp = moves[k].feed_mm_rev * (from + to) / 120 * std::abs(to - from) / spindleRamp_rpm_s;
            const bool is_face =
                std::abs(moves[k].to.x() - start.x()) < kSame_mm && std::abs(moves[k].to.y() - start.y()) >= ramp;
            CutMove& before = moves[k - 1];
            const double room = k >= 2 ? before.to.x() - moves[k - 2].to.x() : 0;
            if (!is_face && before.kind == CutKind::Line && room > ramp &&
                std::abs(before.to.y() - moves[k - 2].to.y()) < kSame_mm) {
                CutMove first = before;
                first.to.x() -= ramp;
                before.speed_rpm = to;
                moves.insert(moves.begin() + static_cast<std::ptrdiff_t>(k - 1), first);
            } else {
                moves[k].speed_rpm = to;
            }
            break;
        }
    }
}

void setRoughSpeeds(Operation& rough, const Clamping& clamping, const SpeedRequest& request, WorkStock before,
                    Notes& notes, const Progress& progress)
{
    if (!request.spindle) return;
    const double speed = rough.cutting_speed_m_min;
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
                                        request, progress);
        if (count++ == 0)
            rough.speed_rpm = chosen.speed_rpm;
        else
            move.speed_rpm = chosen.speed_rpm;
        if (!chosen.is_stable)
            notes.push_back({notes::noStableSpeedHere,
                             {{"z_start_mm", start.x()}, {"z_end_mm", move.to.x()}, {"speed_rpm", chosen.speed_rpm}}});
    }
}

}  // namespace lathelier::cam
