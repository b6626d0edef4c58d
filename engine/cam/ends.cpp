#include "engine/cam/ends.h"

#include <algorithm>
#include <cmath>

namespace lathelier::cam {
namespace {

using Eigen::Vector2d;

constexpr double kFacingFeed_mm_rev = 0.2;  // largest
constexpr double kDrillFeed_mm_rev = 0.05;  // where none is stated
constexpr double kPartingFeed_mm_rev = 0.08;
constexpr double kPartingShare = 0.475;   // of the cutting speed of roughing
constexpr double kDrillSpeed_m_min = 25;  // of high-speed steel
constexpr double kSlowRadius_mm = 3;
constexpr double kPilotShare = 0.4;  // pilot diameter over that of the centre hole
constexpr double kRad = 3.14159265358979323846 / 180;

}  // namespace

std::optional<Operation> facing(const WorkFrame& frame, const JobTool& tool)
{
    const double away = frame.face_mm - faceLeft_mm;
    if (!(away > 1e-6)) return {};
    const RoughCutting& rough = frame.job->cutting.rough;
    Operation result{OperationKind::Face, tool.number, rough.cutting_speed_m_min, {}, {}, {}};
    MoveList moves(tipOffset(tool));
    const double feed = std::min(kFacingFeed_mm_rev, tool.feed_mm_rev.value_or(rough.feed_mm_rev));
    const double inner =
        frame.job->setup.tailstock ? frame.job->setup.tailstock->centre_hole_mm / 2 + 1 : -tool.radius_mm();
    const int passes = static_cast<int>(std::ceil(away / std::min(rough.depth_mm, largestFacing_mm) - 1e-9));
    moves.rapid({-frame.face_mm - clearance_mm, frame.safe_x_mm});
    for (int i = 1; i <= passes; ++i) {
        const double z = -frame.face_mm + away * i / passes;
        moves.rapidZ(z);
        moves.line({z, inner}, feed);
        moves.line({z - retract_mm, inner}, feed);
        moves.rapidX(frame.safe_x_mm);
    }
    result.moves = moves.taken();
    return result;
}

std::optional<Operation> centreDrilling(const WorkFrame& frame)
{
    const JobTool* drill = frame.job->toolFor(ToolUse::CentreDrill);
    if (!drill || !frame.job->setup.tailstock) return {};
    const double hole = frame.job->setup.tailstock->centre_hole_mm;
    const double pilot = kPilotShare * hole;
    const double depth = pilot + (hole - pilot) / 2 / std::tan(30 * kRad);
    Operation result{OperationKind::CentreDrill, drill->number, kDrillSpeed_m_min, {}, {}, {}};
    result.speed_rpm = std::round(1000 * kDrillSpeed_m_min / (180 * kRad * hole));
    MoveList moves(Vector2d(0, 0));
    moves.rapid({-frame.face_mm - clearance_mm - approach_mm, frame.safe_x_mm});
    moves.rapidX(0);
    moves.rapidZ(frame.frontZ_mm());
    moves.line({depth, 0}, drill->feed_mm_rev.value_or(kDrillFeed_mm_rev));
    moves.rapidZ(-frame.face_mm - clearance_mm - approach_mm);
    moves.rapidX(frame.safe_x_mm);
    result.moves = moves.taken();
    return result;
}

Operation partingOff(const WorkFrame& frame, const JobTool& blade)
{
    const double z = frame.contour.length_mm + *blade.width_mm;
    const double feed = blade.feed_mm_rev.value_or(kPartingFeed_mm_rev);
    Operation result{
        OperationKind::PartOff, blade.number, kPartingShare * frame.job->cutting.rough.cutting_speed_m_min, {}, {}, {}};
    MoveList moves(tipOffset(blade));
    moves.rapid({z, frame.safe_x_mm});
    if (frame.stock_radius_mm > kSlowRadius_mm) moves.line({z, kSlowRadius_mm}, feed);
    moves.line({z, -std::max(blade.corner_radius_mm, 0.1)}, feed / 2);
    moves.rapidX(frame.safe_x_mm);
    result.moves = moves.taken();
    return result;
}

}  // namespace lathelier::cam
