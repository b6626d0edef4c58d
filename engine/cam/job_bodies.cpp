#include "engine/cam/job_bodies.h"

#include <algorithm>
#include <numbers>

#include "engine/cam/clampings.h"
#include "engine/cam/setup_plan.h"

namespace lathelier::cam {
namespace {

constexpr double leastBeamDiameter_mm = 0.1;  // smallest diameter of the beam model

constexpr double leastGrip_mm = 10;  ///< clamped length of a bar whose length is not stated

}  // namespace

double stockEnd_mm(const Job& job)
{
    if (job.stock.length_mm) return *job.stock.length_mm - job.stock.face_allowance_mm;
    return job.setup.chuck_face_z_mm + std::max(leastGrip_mm, job.setup.grip_length_mm.value_or(0));
}

Shaft stockOf(const Job& job)
{
    Shaft bar;
    bar.segments.push_back(
        {stockEnd_mm(job) + job.stock.face_allowance_mm, job.stock.diameter_mm, job.stock.diameter_mm, 0, {}, ""});
    return bar;
}

Tool turningTool(const JobTool& tool, const Job& job)
{
    Tool result = tool;
    const auto assume = [](std::optional<double>& stated, double value) { stated = stated.value_or(value); };
    if (tool.isThreader()) {
        assume(result.corner_radius_mm, assumed::threadCorner_mm);
        assume(result.tip_angle_deg, assumed::threadAngle_deg);
        assume(result.edge_length_mm, assumed::threadEdge_mm);
    } else if (tool.isDrill()) {
        assume(result.diameter_mm, job.setup.tailstock ? job.setup.tailstock->centre_hole_mm : assumed::centreHole_mm);
        assume(result.tip_angle_deg, assumed::centreAngle_deg);
        assume(result.reach_mm, assumed::reach_mm);
    }
    return result;
}

stock::StockParameters stockParameters(const Job& job)
{
    const double zero_mm = job.stock.face_allowance_mm;
    stock::StockParameters parameters;
    parameters.z_zero_mm = zero_mm;
    for (const JobTool& tool : job.tools) parameters.tools.push_back(turningTool(tool, job));
    parameters.chuck = stock::ChuckBody{job.setup.chuck_face_z_mm + zero_mm, job.setup.jaw_diameter_mm.value_or(0) / 2};
    if (const auto& tailstock = job.setup.tailstock) {
        stock::TailstockBody body;
        body.end_z_mm = zero_mm;
        body.centre_hole_mm = tailstock->centre_hole_mm;
        for (const KeepOutCorner& corner : tailstock->keep_out)
            body.outline.push_back({corner.z_mm + zero_mm, corner.x_mm});
        parameters.tailstock = body;
    }
    return parameters;
}

Shaft heldStock(const Job& job)
{
    Shaft bar = stockOf(job);
    const double beyond_mm = bar.length_mm() - (job.setup.chuck_face_z_mm + job.stock.face_allowance_mm);
    if (beyond_mm > 0 && !bar.segments.empty()) bar.segments.back().length_mm -= beyond_mm;
    return bar;
}

Shaft mirrored(const Shaft& part)
{
    Shaft result = part;
    std::reverse(result.segments.begin(), result.segments.end());
    for (ShaftSegment& segment : result.segments) std::swap(segment.start_diameter_mm, segment.end_diameter_mm);
    for (ShaftBore& bore : result.bores) bore.from = bore.from == ShaftEnd::Free ? ShaftEnd::Chuck : ShaftEnd::Free;
    return result;
}

Shaft heldPart(const Shaft& part, const Job& job)
{
    const double face = job.setup.chuck_face_z_mm;
    Shaft body = part;
    body.bores.clear();
    body.marks.clear();
    if (body.length_mm() > face) return cutAt(body, face);
    if (const double stub = face - body.length_mm(); stub > 1e-9) {
        // As long as the part is attached to the bar, contours falling behind its last cylinder are not cut.
        for (std::size_t i = body.segments.size(); i-- > 1;) {
            ShaftSegment& row = body.segments[i];
            if (row.start_diameter_mm == row.end_diameter_mm && !row.arc_radius_mm) break;
            if (row.end_diameter_mm > row.start_diameter_mm) break;
            row.end_diameter_mm = row.start_diameter_mm;
            row.arc_radius_mm.reset();
        }
        ShaftSegment bar;
        bar.length_mm = stub;
        bar.start_diameter_mm = bar.end_diameter_mm = job.stock.diameter_mm;
        body.segments.push_back(bar);
    }
    for (ShaftSegment& row : body.segments)
        for (double* diameter : {&row.start_diameter_mm, &row.end_diameter_mm})
            *diameter = std::max(*diameter, leastBeamDiameter_mm);
    return body;
}

Interval usedSpeeds(const Job& job)
{
    const double slowest_m_min =
        std::min(job.cutting.rough.cutting_speed_m_min, job.cutting.finish.cutting_speed_m_min);
    const double fastest = job.max_rpm.value_or(assumedLimit_rpm);
    const double slowest = 1000 * slowest_m_min / (std::numbers::pi * job.stock.diameter_mm);
    return {std::min(slowest, fastest) / 2, fastest};
}

}  // namespace lathelier::cam
