#include "engine/cam/ends.h"

#include <algorithm>
#include <cmath>

#include "engine/cam/tailstock.h"
#include "engine/core/units.h"

namespace lathelier::cam {
namespace {

using Eigen::Vector2d;

constexpr double largestFacingFeed_mm_rev = 0.2;  // largest
constexpr double assumedDrillFeed_mm_rev = 0.05;  // where none is stated
constexpr double assumedPartingFeed_mm_rev = 0.08;
constexpr double partingSpeedShare = 0.475;  // over the cutting speed of roughing
constexpr double drillSpeed_m_min = 25;      // of high-speed steel
constexpr double slowPartingRadius_mm = 3;
constexpr double outsideCentreHole_mm = 1;  // radial distance between the end of facing and a centre hole
constexpr double leastFaceRing_mm = 0.5;    // narrower rings are not faced
constexpr double pilotDiameterShare = 0.4;  // pilot diameter over that of the centre hole

}  // namespace

bool leansOverFace(const JobTool& tool)
{
    constexpr double square_deg = 90;
    return tool.isProfile() && tool.hand == Hand::TowardChuck &&
           tool.entering_angle_deg.value_or(square_deg) < square_deg;
}

const JobTool* facingTool(const Job& job)
{
    for (const ToolUse use : {ToolUse::Rough, ToolUse::Finish})
        if (const JobTool* tool = job.toolFor(use); tool && !leansOverFace(*tool)) return tool;
    const auto found = std::find_if(job.tools.begin(), job.tools.end(), [](const JobTool& tool) {
        return tool.isProfile() && tool.hand == Hand::TowardChuck && !leansOverFace(tool);
    });
    return found == job.tools.end() ? nullptr : &*found;
}

double innerEnd_mm(const WorkFrame& frame, const JobTool& tool)
{
    if (!frame.has_tailstock) return -tool.radius_mm();
    return std::max(frame.job->setup.tailstock->centre_hole_mm / 2 + outsideCentreHole_mm,
                    lowestBesideTailstock_mm(*frame.job, tool, -frame.face_mm - approach_mm, 0));
}

std::optional<Operation> facing(const WorkFrame& frame, const JobTool& tool)
{
    const double away = frame.face_mm - faceLeft_mm, inner = innerEnd_mm(frame, tool);
    const bool is_last = !frame.faces_end && frame.face_mm > 1e-6;  // down to the finished face
    if ((!(away > 1e-6) && !is_last) || inner > frame.stock_radius_mm - leastFaceRing_mm) return {};
    const RoughCutting& rough = frame.job->cutting.rough;
    const bool is_rough = tool.use == ToolUse::Rough;
    const FinishCutting& finish = frame.job->cutting.finish;
    Operation result{OperationKind::Face,
                     tool.number,
                     is_rough ? rough.cutting_speed_m_min : finish.cutting_speed_m_min,
                     {},
                     {},
                     {}};
    MoveList moves(tipOffset(tool));
    const double feed = std::min(largestFacingFeed_mm_rev,
                                 tool.feed_mm_rev.value_or(is_rough ? rough.feed_mm_rev : finish.feed_mm_rev));
    const int passes =
        std::max(0, static_cast<int>(std::ceil(away / std::min(rough.depth_mm, largestFacing_mm) - 1e-9)));
    moves.rapid({-frame.face_mm - clearance_mm, frame.safe_x_mm});
    const auto pass = [&](double z, double along) {
        moves.rapidZ(z);
        moves.line({z, inner}, along);
        moves.line({z - retract_mm, inner}, along);
        moves.rapidX(frame.safe_x_mm);
    };
    for (int i = 1; i <= passes; ++i) pass(-frame.face_mm + away * i / passes, feed);
    if (is_last) pass(0, std::min(feed, frame.job->cutting.finish.feed_mm_rev));
    result.moves = moves.taken();
    return result;
}

std::optional<Operation> centreDrilling(const WorkFrame& frame)
{
    const JobTool* drill = frame.job->toolFor(ToolUse::CentreDrill);
    if (!drill || !frame.job->setup.tailstock) return {};
    const double hole = frame.job->setup.tailstock->centre_hole_mm;
    const double pilot = pilotDiameterShare * hole;
    const double depth = pilot + (hole - pilot) / 2 / std::tan(30 * rad_per_deg);
    Operation result{OperationKind::CentreDrill, drill->number, drillSpeed_m_min, {}, {}, {}};
    result.speed_rpm = std::round(1000 * drillSpeed_m_min / (180 * rad_per_deg * hole));
    MoveList moves(Vector2d(0, 0));
    moves.rapid({-frame.face_mm - clearance_mm - approach_mm, frame.safe_x_mm});
    moves.rapidX(0);
    moves.rapidZ(frame.frontZ_mm());
    moves.line({depth, 0}, drill->feed_mm_rev.value_or(assumedDrillFeed_mm_rev));
    moves.rapidZ(-frame.face_mm - clearance_mm - approach_mm);
    moves.rapidX(frame.safe_x_mm);
    result.moves = moves.taken();
    return result;
}

Operation partingOff(const WorkFrame& frame, const JobTool& blade)
{
    const double z = frame.contour.length_mm + *blade.width_mm;
    const double feed = blade.feed_mm_rev.value_or(assumedPartingFeed_mm_rev);
    Operation result{OperationKind::PartOff,
                     blade.number,
                     partingSpeedShare * frame.job->cutting.rough.cutting_speed_m_min,
                     {},
                     {},
                     {}};
    MoveList moves(tipOffset(blade));
    moves.rapid({z, frame.safe_x_mm});
    if (frame.stock_radius_mm > slowPartingRadius_mm) moves.line({z, slowPartingRadius_mm}, feed);
    moves.line({z, -std::max(blade.radius_mm(), 0.1)}, feed / 2);
    moves.rapidX(frame.safe_x_mm);
    result.moves = moves.taken();
    return result;
}

}  // namespace lathelier::cam
