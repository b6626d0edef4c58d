#include "engine/stock/turning_insert.h"

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
    double operator()(const std::optional<double>& given, double assumed)
    {
        if (!given) isAssumed_ = true;
        return given.value_or(assumed);
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

[[noreturn]] void refuse(const TurningTool& tool, double entering_deg, double tip_deg, double radius_mm)
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
ConvexPolygon insertOf(const TurningTool& tool, Stated& stated, ToolOutline& used)
{
    const double radius_mm = stated(tool.corner_radius_mm, assumedCornerRadius_mm);
    const double edge_mm = stated(tool.edge_length_mm, assumedEdge_mm);
    const double named_deg = tipAngleOfCode_deg(tool.name).value_or(assumedTipAngle_deg);
    const double tip_deg = stated(tool.tip_angle_deg, named_deg);
    const bool is_straight = tool.tip >= 5 && tool.tip <= 8;
    const double entering_deg =
        is_straight ? 90 - tip_deg / 2 : stated(tool.entering_angle_deg, assumedEnteringAngle_deg);
    const bool is_possible = entering_deg > 0 && tip_deg > 0 && entering_deg + tip_deg < 180 && radius_mm >= 0 &&
                             edge_mm * std::tan(tip_deg / 2 * rad_per_deg) > radius_mm;
    if (!is_possible) refuse(tool, entering_deg, tip_deg, radius_mm);
    used.corner_radius_mm = radius_mm;
    used.entering_angle_deg = entering_deg;
    used.tip_angle_deg = tip_deg;
    used.edge_length_mm = edge_mm;
    return rhombus(radius_mm, entering_deg * rad_per_deg, (entering_deg + tip_deg) * rad_per_deg, edge_mm);
}

ConvexPolygon discOf(const TurningTool& tool, Stated& stated, ToolOutline& used)
{
    used.corner_radius_mm = stated(tool.corner_radius_mm, assumedCornerRadius_mm);
    std::vector<Corner> corners;
    appendCornerArc(corners, {}, used.corner_radius_mm, 0, 4 * quarterTurn_rad);
    return hullOf(std::move(corners));
}

/// Tip at (0, 0): the corner toward +z.
ConvexPolygon bladeOf(const TurningTool& tool, Stated& stated, ToolOutline& used)
{
    const double width_mm = stated(tool.width_mm, assumedWidth_mm);
    const double radius_mm = tool.corner_radius_mm.value_or(0);
    const double reach_mm = stated(tool.edge_length_mm, assumedReach_mm);
    if (!(width_mm >= 2 * radius_mm && width_mm > 0 && reach_mm > radius_mm && radius_mm >= 0))
        refuse(tool, 90, 90, radius_mm);
    used.corner_radius_mm = radius_mm;
    used.edge_length_mm = reach_mm;
    std::vector<Corner> corners{{0, reach_mm}, {-width_mm, reach_mm}};
    appendCornerArc(corners, {radius_mm - width_mm, radius_mm}, radius_mm, 2 * quarterTurn_rad, 3 * quarterTurn_rad);
    appendCornerArc(corners, {-radius_mm, radius_mm}, radius_mm, 3 * quarterTurn_rad, 4 * quarterTurn_rad);
    return hullOf(std::move(corners));
}

/// Point at (0, 0), toward +z.
ConvexPolygon drillOf(const TurningTool& tool, Stated& stated, ToolOutline& used)
{
    const double radius_mm = stated(tool.width_mm, assumedWidth_mm) / 2;
    const double point_deg = stated(tool.tip_angle_deg, assumedPointAngle_deg);
    const double length_mm = stated(tool.edge_length_mm, assumedReach_mm);
    if (!(radius_mm > 0 && point_deg > 0 && point_deg <= 180)) refuse(tool, 0, point_deg, radius_mm);
    const double cone_mm = radius_mm / std::tan(point_deg / 2 * rad_per_deg);
    if (!(length_mm > cone_mm)) refuse(tool, 0, point_deg, radius_mm);
    used.tip_angle_deg = point_deg;
    used.edge_length_mm = length_mm;
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

ToolOutline outlineOf(const TurningTool& tool)
{
    Stated stated;
    ToolOutline outline;
    ConvexPolygon shape;
    const bool has_corner = tool.shape == ToolShape::Insert || tool.shape == ToolShape::Round;
    if (has_corner) {
        shape = tool.shape == ToolShape::Insert ? insertOf(tool, stated, outline) : discOf(tool, stated, outline);
        shape = movedBy(shape, -1 * tipFromCentre(tool.tip, outline.corner_radius_mm));
    } else {
        shape = tool.shape == ToolShape::Blade ? bladeOf(tool, stated, outline) : drillOf(tool, stated, outline);
    }
    const int tip = tool.shape == ToolShape::Drill ? 3 : tool.tip;
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

std::optional<double> tipAngleOfCode_deg(std::string_view code)
{
    struct Letter {
        char letter;
        double angle_deg;
    };
    static constexpr Letter letters[] = {{'A', 85}, {'B', 82}, {'C', 80}, {'D', 55}, {'E', 75}, {'K', 55},
                                         {'M', 86}, {'S', 90}, {'T', 60}, {'V', 35}, {'W', 80}};
    const auto is_capital = [](char c) { return c >= 'A' && c <= 'Z'; };
    if (code.size() < 4 || !std::all_of(code.begin(), code.begin() + 4, is_capital)) return {};
    const std::string_view rest = code.substr(4);
    const std::size_t digit = rest.find_first_not_of(' ');
    if (digit == std::string_view::npos || rest[digit] < '0' || rest[digit] > '9') return {};
    for (const Letter& one : letters)
        if (one.letter == code.front()) return one.angle_deg;
    return {};
}

const std::vector<Field<HolderCorner>>& fieldsOf(const HolderCorner*)
{
    using H = HolderCorner;
    static const auto all = described<H>(
        field("dz_mm", &H::dz_mm, {-1e4, 1e4},
              Label{LT_TEXT("Engine", "From the tip along z"), LT_TEXT("Engine", "Toward the chuck."), unit::mm}),
        field("dx_mm", &H::dx_mm, {-1e4, 1e4},
              Label{LT_TEXT("Engine", "From the tip along x"), LT_TEXT("Engine", "Away from the axis."), unit::mm}));
    return all;
}

const std::vector<Field<TurningTool>>& fieldsOf(const TurningTool*)
{
    using T = TurningTool;
    static const auto all = described<T>(
        field("number", &T::number, {0, 99999},
              Label{LT_TEXT("Engine", "Tool number"),
                    LT_TEXT("Engine", "As the program calls it; 0: every tool that is not listed.")}),
        field("shape", &T::shape,
              {{"insert", LT_TEXT("Engine", "insert with two edges")},
               {"round", LT_TEXT("Engine", "round insert")},
               {"blade", LT_TEXT("Engine", "blade")},
               {"drill", LT_TEXT("Engine", "drill on the axis")}},
              Label{LT_TEXT("Engine", "Shape"), LT_TEXT("Engine", "What cuts.")}),
        field("tip", &T::tip, {0, 9},
              Label{LT_TEXT("Engine", "Tip"),
                    LT_TEXT("Engine",
                            "Where the imaginary tip lies seen from the nose centre, as Fanuc counts: 3 towards the "
                            "axis and the chuck.")}),
        field("corner_radius_mm", &T::corner_radius_mm, {0, 100},
              Label{LT_TEXT("Engine", "Corner radius"), LT_TEXT("Engine", "Of the corner that cuts."), unit::mm}),
        field("entering_angle_deg", &T::entering_angle_deg, {1, 178},
              Label{LT_TEXT("Engine", "Entering angle"),
                    LT_TEXT("Engine", "Between main edge and feed: 90° less the lead angle."), unit::deg}),
        field("tip_angle_deg", &T::tip_angle_deg, {1, 180},
              Label{LT_TEXT("Engine", "Tip angle"),
                    LT_TEXT("Engine", "Between both edges: C 80°, D 55°, V 35°; of a drill, its point."), unit::deg}),
        field("edge_length_mm", &T::edge_length_mm, {0.01, 1000},
              Label{LT_TEXT("Engine", "Length of the edge"),
                    LT_TEXT("Engine", "Of an insert; the reach of a blade, the length of a drill."), unit::mm}),
        field("width_mm", &T::width_mm, {0.01, 1000},
              Label{LT_TEXT("Engine", "Width"), LT_TEXT("Engine", "Of a blade; the diameter of a drill."), unit::mm}),
        field(
            "shank_width_mm", &T::shank_width_mm, {0, 500},
            Label{LT_TEXT("Engine", "Width of the shank"),
                  LT_TEXT("Engine", "A shank across the axis behind the insert; empty: the insert alone."), unit::mm}),
        rows("holder", &T::holder, {0, 1000},
             Label{LT_TEXT("Engine", "Holder"),
                   LT_TEXT("Engine", "Corners from the tip; their convex hull must not meet stock.")}),
        field("name", &T::name, Label{LT_TEXT("Engine", "Name"), LT_TEXT("Engine", "Of insert and holder.")}));
    return all;
}

}  // namespace lathelier::stock
