#include "engine/cam/tailstock.h"

#include <algorithm>
#include <cmath>

#include "engine/cam/job_bodies.h"
#include "engine/cam/operation.h"
#include "engine/core/units.h"

namespace lathelier::cam {
namespace {

using Eigen::Vector2d;

constexpr double noFloor_mm = -1e9;
constexpr double entryLength_mm = 0.01;  // over which the curve keeps its entry height

/// Tip positions at which a body overlaps a region (Minkowski sum).
stock::ConvexPolygon forbidden(const stock::ConvexPolygon& region, const stock::ConvexPolygon& body)
{
    std::vector<stock::Corner> corners;
    corners.reserve(region.size() * body.size());
    for (const stock::Corner& r : region)
        for (const stock::Corner& b : body) corners.push_back(r - b);
    return stock::grownBy(stock::hullOf(std::move(corners)), tailstockClearance_mm);
}

CurvePiece lineBetween(const Vector2d& from, const Vector2d& to)
{
    CurvePiece piece;
    piece.from = from;
    piece.to = to;
    piece.touch = Touch::Tailstock;
    return piece;
}

/// Upper side of a convex polygon within [from, to]: corners run anticlockwise, so upper edges run to smaller z.
void addUpperSide(const stock::ConvexPolygon& polygon, double from, double to, Curve& all)
{
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const stock::Corner &right = polygon[i], &left = polygon[(i + 1) % polygon.size()];
        if (!(right.z_mm - left.z_mm > meet_mm)) continue;
        CurvePiece piece = lineBetween({left.z_mm, left.x_mm}, {right.z_mm, right.x_mm});
        if (piece.to.x() <= from || piece.from.x() >= to) continue;
        if (piece.from.x() < from) piece.from = {from, piece.at(from)};
        if (piece.to.x() > to) piece.to = {to, piece.at(to)};
        if (piece.to.x() - piece.from.x() > meet_mm) all.push_back(piece);
    }
}

}  // namespace

Curve tailstockFloor(const Job& job, const JobTool& tool, double from_mm, double to_mm)
{
    Curve all;
    const stock::StockParameters bodies = stockParameters(job);
    if (!bodies.tailstock || tool.isDrill()) return all;
    const stock::ToolOutline outline = stock::outlineOf(turningTool(tool, job));
    std::vector<const stock::ConvexPolygon*> tools{&outline.insert};
    for (const stock::ConvexPolygon& holder : outline.holders) tools.push_back(&holder);
    const double zero = bodies.z_zero_mm;
    for (const stock::ConvexPolygon& region : stock::regionsOf(*bodies.tailstock)) {
        const stock::ConvexPolygon placed = stock::movedBy(region, {-zero, 0});
        for (const stock::ConvexPolygon* body : tools) addUpperSide(forbidden(placed, *body), from_mm, to_mm, all);
    }
    return all;
}

double lowestBesideTailstock_mm(const Job& job, const JobTool& tool, double from_mm, double to_mm)
{
    double lowest = noFloor_mm;
    for (const CurvePiece& piece : tailstockFloor(job, tool, from_mm, std::max(to_mm, from_mm + entryLength_mm)))
        lowest = std::max({lowest, piece.from.y(), piece.to.y()});
    return lowest;
}

Curve liftedOverTailstock(const Job& job, const JobTool& tool, const Curve& curve, double front_mm)
{
    const Vector2d offset = tipOffset(tool);
    const double first = curve.front().from.x(), last = curve.back().to.x();
    Curve floor = shifted(tailstockFloor(job, tool, first + offset.x(), last + offset.x()), -offset);
    const double entry =
        lowestBesideTailstock_mm(job, tool, std::min(front_mm, first + offset.x()), first + offset.x());
    if (entry > noFloor_mm / 2 && entry - offset.y() > curve.front().from.y())
        floor.push_back(lineBetween({first, entry - offset.y()}, {first + entryLength_mm, entry - offset.y()}));
    if (floor.empty()) return curve;
    const double back = tool.isProfile() && tool.hand == Hand::TowardChuck ? wedgeOf(tool).back_angle_deg : 90;
    if (back < 90)
        for (const CurvePiece& piece : Curve(floor))
            for (const Vector2d& start : {piece.from, piece.to}) {
                const double far = last - start.x();
                if (far > meet_mm)
                    floor.push_back(lineBetween(start, start + Vector2d(far, -far * std::tan(back * rad_per_deg))));
            }
    for (const CurvePiece& piece : curve)
        if (piece.touch != Touch::Join) floor.push_back(piece);
    return upperEnvelope(std::move(floor));
}

}  // namespace lathelier::cam
