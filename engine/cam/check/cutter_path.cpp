#include "engine/cam/check/cutter_path.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "engine/cam/cam_codes.h"
#include "engine/core/units.h"
#include "engine/stock/machine_limits.h"

namespace lathelier::cam {
namespace {

double distanceToLine(const Corner& place, const Corner& from, const Corner& to)
{
    const Corner way = to - from, at = place - from;
    const double square = way.z_mm * way.z_mm + way.x_mm * way.x_mm;
    const double share = square > 0 ? std::clamp((at.z_mm * way.z_mm + at.x_mm * way.x_mm) / square, 0.0, 1.0) : 0.0;
    const Corner off = at - share * way;
    return std::sqrt(off.z_mm * off.z_mm + off.x_mm * off.x_mm);
}

double distanceToArc(const Corner& place, const CutterStroke& arc)
{
    const Corner at = place - arc.centre;
    const double away = std::sqrt(at.z_mm * at.z_mm + at.x_mm * at.x_mm);
    if (away > 0) {
        double angle = std::atan2(at.x_mm, at.z_mm) - arc.begin;
        if (arc.sweep < 0) angle = -angle;
        angle -= turn_rad * std::floor(angle / turn_rad);
        const double whole = std::abs(arc.sweep);
        if (angle <= whole)
            return std::abs(away - (arc.from_radius_mm + angle / whole * (arc.to_radius_mm - arc.from_radius_mm)));
    }
    return std::min(stock::length_mm(place - arc.from), stock::length_mm(place - arc.to));
}

/// Negative inside: the distance from the nearest edge.
double distanceToBody(const Corner& place, const ConvexPolygon& body)
{
    double outside = -stock::endless_mm;
    for (std::size_t i = 0; i < body.size(); ++i) {
        const Corner &a = body[i], &b = body[(i + 1) % body.size()];
        const Corner way = b - a, at = place - a;
        const double length = stock::length_mm(way);
        if (length > 0) outside = std::max(outside, (way.x_mm * at.z_mm - way.z_mm * at.x_mm) / length);
    }
    if (outside <= 0) return outside;
    double nearest = stock::endless_mm;
    for (std::size_t i = 0; i < body.size(); ++i)
        nearest = std::min(nearest, distanceToLine(place, body[i], body[(i + 1) % body.size()]));
    return nearest;
}

/// Converts the moves of one program to cutter strokes.
class PathMaker {
public:
    PathMaker(const Job& job, const PathPlace& place, Notes& notes) : job_(job), place_(place), notes_(notes) {}

    std::vector<CutterStroke> run(std::span<const gcode::Move> moves)
    {
        for (const gcode::Move& move : moves) {
            if (move.kind == gcode::MoveKind::Dwell) continue;
            const Corner end = placed(move.z_mm, move.x_mm);
            const bool is_place = std::abs(end.z_mm) <= stock::endless_mm && std::abs(end.x_mm) <= stock::endless_mm;
            if (is_place && isKnown_ && move.kind != gcode::MoveKind::Rapid) take(move, end);
            isKnown_ = is_place;
            at_ = end;
        }
        return std::move(strokes_);
    }

private:
    Corner placed(double Z, double X) const
    {
        const double z = place_.z_zero_mm - Z;
        return {place_.is_mirrored ? place_.length_mm - z : z, X};
    }

    /// Along z from the free end of the program toward its chuck, in the coordinates of the drawing.
    double towardChuck() const { return place_.is_mirrored ? -1 : 1; }

    void take(const gcode::Move& move, const Corner& end)
    {
        const JobTool* tool = job_.tool(move.tool);
        if (!tool) {
            if (unknown_.insert(move.tool).second)
                notes_.push_back({notes::toolNotInJob, {{"line", move.line}, {"tool", std::int64_t{move.tool}}}});
            return;
        }
        if (tool->isDrill() || tool->isThreader()) return;
        CutterStroke stroke;
        stroke.line = move.line;
        stroke.tool = move.tool;
        stroke.radius_mm = tool->radius_mm();
        const Corner centre = placed(move.centre_z_mm, move.centre_x_mm);
        if (move.kind == gcode::MoveKind::Arc && std::isfinite(centre.z_mm) && std::isfinite(centre.x_mm))
            bend(stroke, move, end, centre);
        stroke.from = at_;
        stroke.to = end;
        if (tool->isBlade())
            addBlade(stroke, *tool);
        else
            addNose(stroke, *tool);
    }

    void bend(CutterStroke& stroke, const gcode::Move& move, const Corner& end, const Corner& centre) const
    {
        stroke.is_arc = true;
        stroke.centre = centre;
        const Corner first = at_ - centre, last = end - centre;
        stroke.from_radius_mm = stock::length_mm(first);
        stroke.to_radius_mm = stock::length_mm(last);
        stroke.begin = std::atan2(first.x_mm, first.z_mm);
        stroke.sweep = std::atan2(last.x_mm, last.z_mm) - stroke.begin;
        // Z and z run in opposite directions, so what is clockwise in one plane is not in the other.
        const bool is_clockwise = move.clockwise == place_.is_mirrored;
        if (is_clockwise && stroke.sweep >= 0) stroke.sweep -= turn_rad;
        if (!is_clockwise && stroke.sweep <= 0) stroke.sweep += turn_rad;
    }

    static void shift(CutterStroke& stroke, const Corner& by)
    {
        stroke.from = stroke.from + by;
        stroke.to = stroke.to + by;
        stroke.centre = stroke.centre + by;
    }

    void addNose(CutterStroke stroke, const JobTool& tool)
    {
        const double r = stroke.radius_mm;
        const double feed = tool.hand == Hand::FromChuck ? -towardChuck() : towardChuck();
        shift(stroke, {-feed * r, r});
        strokes_.push_back(std::move(stroke));
    }

    void addBlade(const CutterStroke& stroke, const JobTool& tool)
    {
        const double c = stroke.radius_mm, width = *tool.width_mm;
        const double top = std::max(tool.reach_mm.value_or(assumed::reach_mm), 2 * c);
        const double near_mm = -c * towardChuck(), far_mm = (c - width) * towardChuck();
        const auto box = [&](const Corner& tip) {
            return std::vector<Corner>{tip + Corner{near_mm, c}, tip + Corner{far_mm, c}, tip + Corner{near_mm, top},
                                       tip + Corner{far_mm, top}};
        };
        const auto add = [&](std::vector<Corner> corners) {
            CutterStroke body = stroke;
            body.is_arc = false;
            body.body = stock::hullOf(corners);
            if (body.body.size() < 3) {  // the width of the blade is twice its corner radius: the box degenerates
                body.body.clear();
                body.from = corners.front();
                body.to = corners.back();
            }
            strokes_.push_back(std::move(body));
        };
        std::vector<Corner> first = box(stroke.from), last = box(stroke.to);
        if (!stroke.is_arc) {
            first.insert(first.end(), last.begin(), last.end());
            add(std::move(first));
            return;
        }
        for (const double side : {near_mm, far_mm}) {
            CutterStroke corner = stroke;
            shift(corner, {side, c});
            strokes_.push_back(std::move(corner));
        }
        add(std::move(first));
        add(std::move(last));
        // At the smallest radius of the arc the straight edge between both corners cuts.
        double lowest = -turn_rad / 4 - stroke.begin;
        if (stroke.sweep < 0) lowest = -lowest;
        lowest -= turn_rad * std::floor(lowest / turn_rad);
        if (lowest < std::abs(stroke.sweep))
            add(box(stroke.centre - Corner{0, (stroke.from_radius_mm + stroke.to_radius_mm) / 2}));
    }

    const Job& job_;
    const PathPlace& place_;
    Notes& notes_;
    std::vector<CutterStroke> strokes_;
    std::set<int> unknown_;
    Corner at_;
    bool isKnown_ = false;
};

}  // namespace

double CutterStroke::clearance_mm(const Corner& place) const
{
    if (!body.empty()) return distanceToBody(place, body) - radius_mm;
    return (is_arc ? distanceToArc(place, *this) : distanceToLine(place, from, to)) - radius_mm;
}

std::vector<CutterStroke> cutterPath(std::span<const gcode::Move> moves, const Job& job, const PathPlace& place,
                                     Notes& notes)
{
    return PathMaker(job, place, notes).run(moves);
}

}  // namespace lathelier::cam
