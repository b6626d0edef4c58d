#include "engine/cam/work_frame.h"

#include <algorithm>
#include <cmath>

#include "engine/cam/job_bodies.h"
#include "engine/cam/plan_codes.h"

namespace lathelier::cam {
namespace {

constexpr double kBeyondBlade_mm = 1;  // turned behind the blade that parts off, so that it does not rub

[[noreturn]] void refuse(Text reason, double missing_mm)
{
    throw Error(errors::noSetupPossible, {{"reason", reason}, {"missing_mm", missing_mm}});
}

}  // namespace

WorkFrame frameOf(const Job& job, const Shaft& part)
{
    WorkFrame frame;
    frame.job = &job;
    frame.contour = heightContour(part);
    if (const JobTool* blade = job.part_off ? job.partingBlade() : nullptr)
        frame.contour = extendedBy(frame.contour, blade->width_mm.value_or(0) + kBeyondBlade_mm);
    frame.end_mm = frame.contour.pieces.back().to_mm.x();
    frame.stock_radius_mm = job.stock.diameter_mm / 2;
    frame.face_mm = job.stock.face_allowance_mm;
    frame.safe_x_mm = frame.stock_radius_mm + clearance_mm;
    if (job.setup.tailstock)
        for (const KeepOutCorner& corner : job.setup.tailstock->keep_out)
            frame.safe_x_mm = std::max(frame.safe_x_mm, corner.x_mm + clearance_mm);
    double radius = 0;  // by which tips stand beyond the last centre
    for (const JobTool& tool : job.tools)
        if (tool.isProfile() && tool.hand == Hand::TowardChuck) radius = std::max(radius, tool.radius_mm());
    radius += job.cutting.rough.allowance_mm;
    if (const double beyond = frame.end_mm + radius - job.setup.chuck_face_z_mm; beyond > 0)
        refuse(LT_TEXT("Engine", "the chuck stands within the length that is turned"), beyond);
    if (job.setup.grip_length_mm && job.stock.length_mm) {
        const double held = stockEnd_mm(job) - job.setup.chuck_face_z_mm;
        if (held < *job.setup.grip_length_mm)
            refuse(LT_TEXT("Engine", "the bar is held too short"), *job.setup.grip_length_mm - held);
    }
    return frame;
}

ToolWedge wedgeOf(const JobTool& tool)
{
    // Without a margin the edge would lie on the surface; it never becomes less than nothing.
    const double back = std::max(0.0, tool.backAngle_deg() - tool.back_margin_deg);
    return {tool.radius_mm(), back, tool.entering_angle_deg.value_or(90)};
}

Curve toolCurve(const WorkFrame& frame, const JobTool& tool, double allowance_mm)
{
    if (tool.isBlade())
        return bladeCurve(frame.contour, tool.corner_radius_mm, *tool.width_mm - 2 * tool.corner_radius_mm,
                          allowance_mm);
    if (tool.hand == Hand::TowardChuck) return noseCurve(frame.contour, wedgeOf(tool), allowance_mm);
    return mirrored(noseCurve(mirrored(frame.contour), wedgeOf(tool), allowance_mm), frame.end_mm);
}

ToolReach reachOf(const WorkFrame& frame, const JobTool& tool, double allowance_mm)
{
    ToolReach reach{tool.number, toolCurve(frame, tool, allowance_mm), tool.radius_mm(), 0};
    if (tool.isProfile() && tool.hand == Hand::TowardChuck && !reach.curve.empty()) {
        CurvePiece face;  // the tool comes up the face
        face.to = reach.curve.front().from;
        face.from = {face.to.x(), 0};
        face.touch = Touch::Join;
        if (face.to.y() > 0) reach.curve.insert(reach.curve.begin(), face);
    }
    if (tool.isBlade()) {
        reach.radius_mm = std::max(tool.corner_radius_mm, 1e-6);
        reach.span_mm = *tool.width_mm - 2 * tool.corner_radius_mm;
    }
    return reach;
}

}  // namespace lathelier::cam
