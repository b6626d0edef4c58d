#include "engine/stock/tool_outline.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/core/units.h"
#include "engine/stock/stock_codes.h"

namespace lathelier::stock {
namespace {

constexpr double quarterTurn_rad = std::numbers::pi / 2;
constexpr double shankLength_mm = 100;

Corner unit(double angle)
{
    return {std::cos(angle), std::sin(angle)};
}

/// A stated number, or the assumed one.
class Stated {
public:
    double operator()(const std::optional<double>& given, double otherwise)
    {
        if (!given) isAssumed_ = true;
        return given.value_or(otherwise);
    }
    bool isAssumed() const { return isAssumed_; }

private:
    bool isAssumed_ = false;
};

/// Corners of a polygon within an arc, from angle to angle, and at the multiples of 90° between.
void appendCornerArc(std::vector<Corner>& corners, const Corner& centre, double radius_mm, double from, double to)
{
    if (!(radius_mm > 0)) {
        corners.push_back(centre);
        return;
    }
    const double widest = radius_mm > noseChord_mm ? 2 * std::acos(1 - noseChord_mm / radius_mm) : quarterTurn_rad;
    double begin = from;
    corners.push_back(centre + radius_mm * unit(from));
    while (begin < to) {
        const double next = std::min(to, (std::floor(begin / quarterTurn_rad + 1e-9) + 1) * quarterTurn_rad);
        const int parts = std::max(1, static_cast<int>(std::ceil((next - begin) / widest)));
        for (int i = 1; i <= parts; ++i)
            corners.push_back(centre + radius_mm * unit(begin + (next - begin) * i / parts));
        begin = next;
    }
}

[[noreturn]] void refuse(const Tool& tool, double entering_deg, double tip_deg, double radius_mm)
{
    throw Error(errors::toolImpossible, {{"tool", static_cast<std::int64_t>(tool.number)},
                                         {"entering_angle_deg", entering_deg},
                                         {"tip_angle_deg", tip_deg},
                                         {"corner_radius_mm", radius_mm}});
}

/// A rhombus whose cutting corner is rounded about (0, 0); `main` and `back` are the directions of its edges.
ConvexPolygon rhombus(double radius_mm, double main, double back, double edge_mm)
{
    const double tip = back - main;
    const Corner apex = -radius_mm / std::sin(tip / 2) * unit(main + tip / 2);
    std::vector<Corner> corners{apex + edge_mm * unit(main), apex + edge_mm * unit(back),
                                apex + edge_mm * unit(main) + edge_mm * unit(back)};
    appendCornerArc(corners, {}, radius_mm, back + quarterTurn_rad, main + 3 * quarterTurn_rad);
    return hullOf(std::move(corners));
}

/// Corner circle about (0, 0), tip toward -x.
ConvexPolygon insertOf(const Tool& tool, Stated& stated, ToolOutline& used)
{
    const double radius_mm = stated(tool.corner_radius_mm, assumed::cornerRadius_mm);
    const double edge_mm = stated(tool.edge_length_mm, assumed::edge_mm);
    const double named_deg = tipAngleOfCode_deg(tool.name).value_or(assumed::tipAngle_deg);
    const double tip_deg = stated(tool.tip_angle_deg, named_deg);
    const bool is_straight = tool.tip >= 5 && tool.tip <= 8;
    const double entering_deg =
        is_straight ? 90 - tip_deg / 2 : stated(tool.entering_angle_deg, assumed::enteringAngle_deg);
    const bool is_possible = entering_deg > 0 && tip_deg > 0 && entering_deg + tip_deg < 180 && radius_mm >= 0 &&
                             edge_mm * std::tan(tip_deg / 2 * rad_per_deg) > radius_mm;
    if (!is_possible) refuse(tool, entering_deg, tip_deg, radius_mm);
    used.corner_radius_mm = radius_mm;
    used.entering_angle_deg = entering_deg;
    used.tip_angle_deg = tip_deg;
    used.reach_mm = edge_mm;
    return rhombus(radius_mm, entering_deg * rad_per_deg, (entering_deg + tip_deg) * rad_per_deg, edge_mm);
}

ConvexPolygon discOf(const Tool& tool, Stated& stated, ToolOutline& used)
{
    used.corner_radius_mm = stated(tool.corner_radius_mm, assumed::cornerRadius_mm);
    std::vector<Corner> corners;
    appendCornerArc(corners, {}, used.corner_radius_mm, 0, 4 * quarterTurn_rad);
    return hullOf(std::move(corners));
}

/// Tip at (0, 0): the corner toward +z.
ConvexPolygon bladeOf(const Tool& tool, Stated& stated, ToolOutline& used)
{
    const double width_mm = stated(tool.width_mm, assumed::width_mm);
    const double radius_mm = tool.corner_radius_mm.value_or(0);
    const double reach_mm = stated(tool.reach_mm, assumed::reach_mm);
    if (!(width_mm >= 2 * radius_mm && width_mm > 0 && reach_mm > radius_mm && radius_mm >= 0))
        refuse(tool, 90, 90, radius_mm);
    used.corner_radius_mm = radius_mm;
    used.reach_mm = reach_mm;
    std::vector<Corner> corners{{0, reach_mm}, {-width_mm, reach_mm}};
    appendCornerArc(corners, {radius_mm - width_mm, radius_mm}, radius_mm, 2 * quarterTurn_rad, 3 * quarterTurn_rad);
    appendCornerArc(corners, {-radius_mm, radius_mm}, radius_mm, 3 * quarterTurn_rad, 4 * quarterTurn_rad);
    return hullOf(std::move(corners));
}

/// Point at (0, 0), toward +z.
ConvexPolygon drillOf(const Tool& tool, Stated& stated, ToolOutline& used)
{
    const double radius_mm = stated(tool.diameter_mm, assumed::width_mm) / 2;
    const double point_deg = stated(tool.tip_angle_deg, assumed::pointAngle_deg);
    const double length_mm = stated(tool.reach_mm, assumed::reach_mm);
    if (!(radius_mm > 0 && point_deg > 0 && point_deg <= 180)) refuse(tool, 0, point_deg, radius_mm);
    const double cone_mm = radius_mm / std::tan(point_deg / 2 * rad_per_deg);
    if (!(length_mm > cone_mm)) refuse(tool, 0, point_deg, radius_mm);
    used.tip_angle_deg = point_deg;
    used.reach_mm = length_mm;
    return hullOf(
        {{0, 0}, {-cone_mm, radius_mm}, {-length_mm, radius_mm}, {-length_mm, -radius_mm}, {-cone_mm, -radius_mm}});
}

/// Transforms a tool in orientation 3 (outside, toward the chuck) or 8 (straight) to the given tip number.
Corner turned(const Corner& corner, int tip)
{
    switch (tip) {
        case 1: return {-corner.z_mm, -corner.x_mm};
        case 2: return {corner.z_mm, -corner.x_mm};
        case 4: return {-corner.z_mm, corner.x_mm};
        case 5: return {corner.x_mm, corner.z_mm};
        case 6: return {corner.z_mm, -corner.x_mm};
        case 7: return {-corner.x_mm, corner.z_mm};
        default: return corner;
    }
}

ConvexPolygon turned(const ConvexPolygon& polygon, int tip)
{
    std::vector<Corner> corners;
    corners.reserve(polygon.size());
    for (const Corner& corner : polygon) corners.push_back(turned(corner, tip));
    return hullOf(std::move(corners));
}

/// From the centre of the corner to the imaginary tip, of tips 3 and 8.
Corner tipFromCentre(int tip, double radius_mm)
{
    if (tip == 0 || tip == 9) return {};
    return {tip >= 5 ? 0 : radius_mm, -radius_mm};
}

}  // namespace

ToolOutline outlineOf(const Tool& tool)
{
    Stated stated;
    ToolOutline outline;
    ConvexPolygon shape;
    switch (tool.kind) {
        case ToolKind::Blade: shape = bladeOf(tool, stated, outline); break;
        case ToolKind::Drill: shape = drillOf(tool, stated, outline); break;
        case ToolKind::RoundInsert: shape = discOf(tool, stated, outline); break;
        case ToolKind::Insert:
        case ToolKind::BoringBar:
        case ToolKind::ThreadingInsert: shape = insertOf(tool, stated, outline); break;
    }
    if (tool.kind != ToolKind::Blade && tool.kind != ToolKind::Drill)
        shape = movedBy(shape, -1 * tipFromCentre(tool.tip, outline.corner_radius_mm));
    const int tip = tool.kind == ToolKind::Drill ? 3 : tool.tip;
    outline.insert = turned(shape, tip);
    if (tool.shank_width_mm && *tool.shank_width_mm > 0) {
        const double width_mm = *tool.shank_width_mm;
        const double near_mm = boxOf(shape).high.x_mm;
        const double front_mm = -width_mm / 4;
        outline.holders.push_back(turned({{front_mm, near_mm},
                                          {front_mm, near_mm + shankLength_mm},
                                          {front_mm - width_mm, near_mm + shankLength_mm},
                                          {front_mm - width_mm, near_mm}},
                                         tip));
    }
    std::vector<Corner> corners;
    corners.reserve(tool.holder.size());
    for (const HolderCorner& corner : tool.holder) corners.push_back({corner.dz_mm, corner.dx_mm});
    if (ConvexPolygon hull = hullOf(std::move(corners)); !hull.empty()) outline.holders.push_back(std::move(hull));
    outline.is_assumed = stated.isAssumed();
    return outline;
}

}  // namespace lathelier::stock
