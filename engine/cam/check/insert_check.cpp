#include "engine/cam/check/insert_check.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "engine/cam/job_bodies.h"
#include "engine/stock/machine_limits.h"
#include "engine/stock/stock_work.h"
#include "engine/stock/tool_travel.h"

namespace lathelier::cam {
namespace {

constexpr std::size_t blockPoints = 64;

/// Contour points sorted by z, with the maximum radius of each block of points for fast rejection.
struct Skyline {
    explicit Skyline(const std::vector<DrawnPoint>& drawn)
    {
        points.reserve(drawn.size());
        for (const DrawnPoint& point : drawn) points.push_back(point.at);
        for (std::size_t i = 0; i < points.size(); ++i) {
            if (i % blockPoints == 0) tops.push_back(points[i].x_mm);
            tops.back() = std::max(tops.back(), points[i].x_mm);
        }
    }
    std::vector<Corner> points;
    std::vector<double> tops;
};

/// Penetration depth: distance from a point inside a convex polygon to its boundary; 0 outside.
double depthIn(const stock::ConvexPolygon& polygon, const Corner& place)
{
    double depth = stock::endless_mm;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Corner &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
        const Corner way = b - a, at = place - a;
        const double length = stock::length_mm(way);
        if (!(length > 0)) continue;
        depth = std::min(depth, (way.z_mm * at.x_mm - way.x_mm * at.z_mm) / length);
        if (depth <= 0) return 0;
    }
    return depth;
}

void deepest(const Skyline& skyline, const stock::ConvexPolygon& swept, InsertBelow& found)
{
    const stock::Box box = stock::boxOf(swept);
    const auto& points = skyline.points;
    const auto by_z = [](const Corner& a, double z) { return a.z_mm < z; };
    auto i = static_cast<std::size_t>(
        std::lower_bound(points.begin(), points.end(), box.low.z_mm + insertTouch_mm, by_z) - points.begin());
    const double end_mm = box.high.z_mm - insertTouch_mm;
    while (i < points.size() && points[i].z_mm <= end_mm) {
        if (i % blockPoints == 0 && skyline.tops[i / blockPoints] <= box.low.x_mm + insertTouch_mm) {
            i += blockPoints;
            continue;
        }
        const Corner& place = points[i++];
        if (place.x_mm <= box.low.x_mm + insertTouch_mm || place.x_mm >= box.high.x_mm) continue;
        const double depth = depthIn(swept, place);
        if (depth > found.depth_mm) {
            found.depth_mm = depth;
            found.at = place;
        }
    }
}

}  // namespace

std::vector<InsertBelow> insertsBelow(std::span<const gcode::Move> moves, const Job& job, const DrawnContour& drawing,
                                      double z_zero_mm, const Progress& progress)
{
    const Skyline skyline(drawing.points());
    std::map<int, stock::ConvexPolygon> inserts;
    for (const JobTool& tool : job.tools)
        if (!tool.isDrill() && !tool.isThreader())
            inserts[tool.number] = stock::outlineOf(turningTool(tool, job)).insert;
    std::vector<InsertBelow> all;
    stock::TipFollower follower(z_zero_mm);
    stock::ToolTravel travel;
    for (const gcode::Move& move : moves) {
        progress.check();
        follower.take(move, stock::arcChord_mm, travel);
        const auto insert = inserts.find(travel.tool);
        if (travel.is_rapid || travel.corners.size() < 2 || insert == inserts.end()) continue;
        InsertBelow found;
        found.line = travel.line;
        for (std::size_t i = 1; i < travel.corners.size(); ++i) {
            const Corner &from = travel.corners[i - 1], &to = travel.corners[i];
            deepest(skyline, stock::sweptBy(stock::movedBy(insert->second, from), to - from), found);
        }
        if (found.depth_mm > insertTouch_mm) all.push_back(found);
    }
    return all;
}

}  // namespace lathelier::cam
