#include "engine/gcode/path_builder.h"

#include <cmath>

#include "engine/core/units.h"
#include "engine/gcode/gcode_codes.h"

namespace lathelier::gcode {
namespace {

constexpr double leastTurn_rad = 0.05;     ///< no arc at outside corners with smaller turn
constexpr double leastInside_rad = 0.001;  ///< pieces with smaller turn are tangent

/// Angle by which the path turns, + to the left.
double turnAngle(const Direction& a, const Direction& b)
{
    return std::atan2(a.z * b.x - a.x * b.z, a.z * b.z + a.x * b.x);
}

bool isPoint(const Piece& piece)
{
    return !piece.isArc() && distance_mm(piece.from, piece.to) < meet_mm;
}

Move moved(const Move& move, const Piece& piece)
{
    Move result = move;
    result.x_mm = piece.to.x_mm;
    result.z_mm = piece.to.z_mm;
    result.centre_x_mm = piece.centre.x_mm;
    result.centre_z_mm = piece.centre.z_mm;
    result.clockwise = piece.clockwise;
    return result;
}

/// True if the point lies between the ends of a line (within rounding before its start); for arcs, on the same side.
bool isWithin(const Piece& piece, const Point& point)
{
    if (piece.isArc())
        return distance_mm(point, piece.from) <= distance_mm(piece.from, piece.to) + 1e-6 ||
               distance_mm(point, piece.to) <= distance_mm(piece.from, piece.to) + 1e-6;
    const double length = distance_mm(piece.from, piece.to);
    return distance_mm(piece.from, point) <= length + 1e-6 && distance_mm(point, piece.to) <= length + 1e-6;
}

Point tipFromCentre(double r, int tip)
{
    switch (tip) {
        case 1: return {r, r};
        case 2: return {r, -r};
        case 3: return {-r, -r};
        case 4: return {-r, r};
        case 5: return {0, r};
        case 6: return {r, 0};
        case 7: return {0, -r};
        case 8: return {-r, 0};
        default: return {0, 0};
    }
}

}  // namespace

const char* key(MoveKind kind)
{
    switch (kind) {
        case MoveKind::Rapid: return "rapid";
        case MoveKind::Feed: return "feed";
        case MoveKind::Arc: return "arc";
        case MoveKind::Thread: return "thread";
        case MoveKind::Dwell: break;
    }
    return "dwell";
}

void PathBuilder::add(const Move& move, const Point& from, const Corner& corner)
{
    if (!waiting_ && corner.kind == CornerKind::None && (side_ == NoseSide::Off || !(radius_mm_ > 0))) {
        out_->push_back(move);
        return;
    }
    Waiting next{move, {from, {move.x_mm, move.z_mm}, {move.centre_x_mm, move.centre_z_mm}, move.clockwise}, corner};
    if (waiting_) join(next);
    if (corner.kind != CornerKind::None)
        waiting_ = next;
    else
        hand(next.move, next.programmed);
}

/// Inserts the corner between the pending move and the next.
void PathBuilder::join(Waiting& next)
{
    Waiting first = *waiting_;
    waiting_.reset();
    const bool isCutting = next.move.kind == MoveKind::Feed || next.move.kind == MoveKind::Arc;
    const Point corner = first.programmed.to;
    std::optional<Piece> between;
    if (isCutting && isKnown(first.programmed.from) && isKnown(corner) && isKnown(next.programmed.to) &&
        !isPoint(first.programmed) && !isPoint(next.programmed)) {
        const double turn = turnAngle(directionAtEnd(first.programmed), directionAtStart(next.programmed));
        if (std::abs(turn) < meet_mm) {  // no corner there
            hand(first.move, first.programmed);
            return;
        }
        std::optional<Point> a, b;
        Point centre;
        if (first.corner.kind == CornerKind::Round) {
            const double left = turn > 0 ? first.corner.size_mm : -first.corner.size_mm;
            const auto one = shifted(first.programmed, left), two = shifted(next.programmed, left);
            const auto met = one && two ? meeting(*one, *two, corner) : std::nullopt;
            if (met) {
                centre = *met;
                a = nearestOn(first.programmed, centre);
                b = nearestOn(next.programmed, centre);
            }
        } else {
            const double inner = std::sin((std::acos(-1.0) - std::abs(turn)) / 2);
            const double leg = first.corner.kind == CornerKind::Legs || inner < 1e-9
                                   ? first.corner.size_mm
                                   : first.corner.size_mm / (2 * inner);
            a = pointAtDistance(first.programmed, corner, leg);
            b = pointAtDistance(next.programmed, corner, leg);
        }
        if (a && b && isWithin(first.programmed, *a) && isWithin(next.programmed, *b))
            between = Piece{*a, *b, centre, turn < 0};
    }
    if (!between) {
        problems.push_back({first.move.line, &errors::ncCorner, first.corner.size_mm});
        hand(first.move, first.programmed);
        return;
    }
    first.programmed.to = between->from;
    hand(moved(first.move, first.programmed), first.programmed);
    Move middle = moved(first.move, *between);
    middle.kind = between->isArc() ? MoveKind::Arc : MoveKind::Feed;
    hand(middle, *between);
    next.programmed.from = between->to;
}

void PathBuilder::setNose(NoseSide side, double radius_mm, int tip)
{
    if (side == side_ && radius_mm == radius_mm_ && tip == tip_) return;
    if (waiting_) {
        const Waiting first = *waiting_;
        waiting_.reset();
        problems.push_back({first.move.line, &errors::ncCorner, first.corner.size_mm});
        hand(first.move, first.programmed);
    }
    flushNose();
    side_ = side;
    radius_mm_ = radius_mm;
    tip_ = tip;
    isStarted_ = false;
}

void PathBuilder::hand(const Move& move, const Piece& piece)
{
    if (side_ == NoseSide::Off || !(radius_mm_ > 0)) {
        out_->push_back(move);
        return;
    }
    if (move.kind == MoveKind::Dwell) {
        if (last_)
            last_->after.push_back(move);
        else
            out_->push_back(move);
        return;
    }
    if (!isKnown(piece.to)) {  // a reference point: the following path is independent
        flushNose();
        out_->push_back(move);
        isStarted_ = false;
        return;
    }
    if (isKnown(piece.from) && isPoint(piece)) return;
    if (!isStarted_) {
        startUp(move, piece);
        return;
    }
    Compensated next{move, piece, {}, false, false, {}};
    const auto tip = shifted(piece, side_ == NoseSide::Left ? radius_mm_ : -radius_mm_);
    if (!tip) problems.push_back({move.line, &errors::ncNoseFit, radius_mm_});
    next.tip = tip.value_or(piece);
    if (last_) connect(*last_, next);
    flushNose();
    last_ = std::move(next);
}

void PathBuilder::startUp(const Move& move, const Piece& piece)
{
    isStarted_ = true;
    Compensated first{move, piece, piece, false, true, {}};
    first.ends_by_next = !isKnown(piece.from);
    if (!first.ends_by_next) {
        const auto tip = shifted(piece, side_ == NoseSide::Left ? radius_mm_ : -radius_mm_);
        if (tip) first.tip = *tip;
        first.tip.from = piece.from;
    }
    last_ = std::move(first);
}

/// Joins the end of one compensated move with the beginning of the next.
void PathBuilder::connect(Compensated& last, Compensated& next)
{
    if (last.ends_by_next) {
        last.tip.to = next.tip.from;
        last.ends_by_next = false;
        return;
    }
    const double side = side_ == NoseSide::Left ? 1 : -1;
    const double turn = turnAngle(directionAtEnd(last.programmed), directionAtStart(next.programmed));
    const double inside = turn * side;
    if (std::abs(inside) < leastInside_rad || (inside < 0 && inside > -leastTurn_rad)) {
        next.tip.from = last.tip.to;
        return;
    }
    if (inside < 0) {
        if (next.move.kind == MoveKind::Rapid) return;
        Move around = moved(next.move, {last.tip.to, next.tip.from, next.programmed.from, side > 0});
        around.kind = MoveKind::Arc;
        Compensated arc{around, {}, {last.tip.to, next.tip.from, next.programmed.from, side > 0}, false, true, {}};
        put(last);
        last = arc;
        return;
    }
    const Piece along = last.is_start_up ? Piece{last.tip.to,
                                                 {last.tip.to.x_mm + directionAtEnd(last.programmed).x,
                                                  last.tip.to.z_mm + directionAtEnd(last.programmed).z},
                                                 {},
                                                 false}
                                         : last.tip;
    const auto met = meeting(along, next.tip, last.tip.to);
    if (!met) {
        problems.push_back({next.move.line, &errors::ncNoseFit, radius_mm_});
        return;
    }
    last.tip.to = *met;
    next.tip.from = *met;
}

void PathBuilder::flushNose()
{
    if (last_) put(*last_);
    last_.reset();
}

void PathBuilder::put(const Compensated& done)
{
    if (!done.is_start_up && !done.tip.isArc() && distance_mm(done.tip.from, done.tip.to) > 1e-6 &&
        std::abs(turnAngle(directionAtEnd(done.programmed), directionAtEnd(done.tip))) > 1.57)
        problems.push_back({done.move.line, &errors::ncNoseFit, radius_mm_});
    Piece tip = done.tip;
    const Point shift = tipFromCentre(radius_mm_, tip_);
    for (Point* point : {&tip.to, &tip.centre}) {
        point->x_mm += shift.x_mm;
        point->z_mm += shift.z_mm;
    }
    out_->push_back(moved(done.move, tip));
    out_->insert(out_->end(), done.after.begin(), done.after.end());
}

void PathBuilder::finish()
{
    if (waiting_) {
        const Waiting first = *waiting_;
        waiting_.reset();
        problems.push_back({first.move.line, &errors::ncCorner, first.corner.size_mm});
        hand(first.move, first.programmed);
    }
    flushNose();
}

}  // namespace lathelier::gcode
