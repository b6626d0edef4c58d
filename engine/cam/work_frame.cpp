#include "engine/cam/work_frame.h"

#include <algorithm>
#include <cmath>

#include "engine/cam/cutting_data.h"
#include "engine/cam/ends.h"
#include "engine/cam/job_bodies.h"
#include "engine/cam/plan_codes.h"
#include "engine/cam/tailstock.h"

namespace lathelier::cam {
namespace {

constexpr double beyondBlade_mm = 1;  // turned beyond the parting cut, so that the blade does not rub

[[noreturn]] void refuseSetup(Text reason, double missing_mm)
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
        frame.contour = extendedBy(frame.contour, blade->width_mm.value_or(0) + beyondBlade_mm);
    for (const ContourPiece& piece : frame.contour.pieces)
        frame.Rz_um.push_back(piece.row >= 0 ? part.segments.at(static_cast<std::size_t>(piece.row)).Rz_um.value_or(0)
                                             : 0);
    frame.end_mm = frame.contour.pieces.back().to_mm.x();
    frame.stock_radius_mm = job.stock.diameter_mm / 2;
    frame.face_mm = job.stock.face_allowance_mm;
    frame.face_left_mm = std::min(frame.face_mm, faceLeft_mm);
    frame.safe_x_mm = frame.stock_radius_mm + clearance_mm;
    if (job.setup.tailstock)
        for (const KeepOutCorner& corner : job.setup.tailstock->keep_out)
            frame.safe_x_mm = std::max(frame.safe_x_mm, corner.x_mm + clearance_mm);
    for (const JobTool& tool : job.tools)
        frame.safe_x_mm = std::max(
            frame.safe_x_mm, lowestBesideTailstock_mm(job, tool, -frame.face_mm - 2 * clearance_mm, frame.end_mm));
    double radius = 0;  // largest tip offset beyond the last nose centre
    for (const JobTool& tool : job.tools)
        if (tool.isProfile() && tool.hand == Hand::TowardChuck) radius = std::max(radius, tool.radius_mm());
    radius += job.cutting.rough.allowance_mm;
    if (const double beyond = frame.end_mm + radius - job.setup.chuck_face_z_mm; beyond > 0)
        refuseSetup(LT_TEXT("Engine", "the chuck stands within the length that is turned"), beyond);
    if (job.setup.grip_length_mm && job.stock.length_mm) {
        const double held = stockEnd_mm(job) - job.setup.chuck_face_z_mm;
        if (held < *job.setup.grip_length_mm)
            refuseSetup(LT_TEXT("Engine", "the bar is held too short"), *job.setup.grip_length_mm - held);
    }
    return frame;
}

double finishFeed(const Job& job, const JobTool& tool)
{
    return tool.feed_mm_rev.value_or(job.cutting.finish.feed_mm_rev);
}

double finishFeed(const Job& job, const JobTool& tool, double Rz_um)
{
    const double usual = finishFeed(job, tool);
    if (!(Rz_um > 0) || !tool.isProfile()) return usual;
    const double feed = feedForRz(Rz_um, tool.radius_mm(), tool.backAngle_deg(), usual);
    constexpr double stepsPerUnit = 1000;  // a post writes three decimals
    if (feed >= usual) return usual;
    return std::min(usual, std::max(leastFeed_mm_rev, std::floor(stepsPerUnit * feed) / stepsPerUnit));
}

std::vector<double> finishFeeds(const WorkFrame& frame, const JobTool& tool)
{
    std::vector<double> feeds;
    for (const double allowed_um : frame.Rz_um) feeds.push_back(finishFeed(*frame.job, tool, allowed_um));
    return feeds;
}

ToolWedge wedgeOf(const JobTool& tool)
{
    // Without a margin the back edge would touch the surface; the angle is clamped at 0.
    const double back = std::max(0.0, tool.backAngle_deg() - tool.back_margin_deg);
    return {tool.radius_mm(), back, tool.entering_angle_deg.value_or(90)};
}

Curve toolCurve(const WorkFrame& frame, const JobTool& tool, double allowance_mm)
{
    Curve curve;
    if (tool.isBlade()) {
        curve = bladeCurve(frame.contour, tool.radius_mm(), *tool.width_mm - 2 * tool.radius_mm(), allowance_mm);
    } else if (tool.hand == Hand::TowardChuck) {
        curve = noseCurve(frame.contour, wedgeOf(tool), allowance_mm);
    } else {
        curve = mirrored(noseCurve(mirrored(frame.contour), wedgeOf(tool), allowance_mm), frame.end_mm);
        const auto count = static_cast<std::int32_t>(frame.contour.pieces.size());
        for (CurvePiece& piece : curve)
            if (piece.source >= 0) piece.source = std::clamp(count - 1 - piece.source, 0, count - 1);
    }
    return frame.has_tailstock ? liftedOverTailstock(*frame.job, tool, curve, frame.frontZ_mm()) : curve;
}

ToolReach faceReachOf(const WorkFrame& frame, const JobTool& tool)
{
    CurvePiece face;
    face.from = {-tool.radius_mm(), 0};
    face.to = {-tool.radius_mm(), frame.stock_radius_mm};
    face.touch = Touch::Join;
    return {tool.number, {face}, tool.radius_mm(), 0};
}

ToolReach reachOf(const WorkFrame& frame, const JobTool& tool, double allowance_mm)
{
    ToolReach reach{tool.number, toolCurve(frame, tool, allowance_mm), tool.radius_mm(), 0};
    if (tool.isProfile() && tool.hand == Hand::TowardChuck && !reach.curve.empty()) {
        CurvePiece face;  // the tool moves outward along the face
        face.to = reach.curve.front().from;
        face.from = {face.to.x(), 0};
        face.touch = Touch::Join;
        if (face.to.y() > 0 && frame.faces_end && !leansOverFace(tool)) reach.curve.insert(reach.curve.begin(), face);
    }
    if (tool.isBlade()) {
        reach.radius_mm = std::max(tool.radius_mm(), 1e-6);
        reach.span_mm = *tool.width_mm - 2 * tool.radius_mm();
    }
    return reach;
}

}  // namespace lathelier::cam
