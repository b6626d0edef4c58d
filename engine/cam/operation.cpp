#include "engine/cam/operation.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace lathelier::cam {
namespace {

using Eigen::Vector2d;

constexpr double leastMove_mm = 1e-7;

}  // namespace

const char* key(OperationKind kind)
{
    static constexpr const char* keys[]{"face",        "centre_drill", "rough",    "semi_finish", "finish",
                                        "finish_back", "groove",       "part_off", "thread"};
    return keys[static_cast<std::size_t>(kind)];
}

Text nameOf(OperationKind kind)
{
    static const Text names[]{
        LT_TEXT("Engine", "face"),        LT_TEXT("Engine", "centre drill"), LT_TEXT("Engine", "rough"),
        LT_TEXT("Engine", "semi-finish"), LT_TEXT("Engine", "finish"),       LT_TEXT("Engine", "finish, opposite hand"),
        LT_TEXT("Engine", "groove"),      LT_TEXT("Engine", "part off"),     LT_TEXT("Engine", "thread")};
    return names[static_cast<std::size_t>(kind)];
}

Vector2d tipOffset(const JobTool& tool)
{
    if (tool.isDrill()) return {0, 0};
    const double r = tool.radius_mm();
    return {tool.isProfile() && tool.hand == Hand::FromChuck ? -r : r, -r};
}

void MoveList::rapid(const Vector2d& tip)
{
    if (!moves_.empty() && (tip - at_).norm() < leastMove_mm) return;
    CutMove move;
    move.to = at_ = tip;
    moves_.push_back(move);
}

void MoveList::line(const Vector2d& tip, double feed_mm_rev)
{
    if ((tip - at_).norm() < leastMove_mm) return;
    CutMove move;
    move.kind = CutKind::Line;
    move.to = at_ = tip;
    move.feed_mm_rev = feed_mm_rev;
    moves_.push_back(move);
}

void MoveList::thread(const Vector2d& tip, double lead_mm)
{
    CutMove move;
    move.kind = CutKind::Thread;
    move.to = at_ = tip;
    move.feed_mm_rev = lead_mm;
    moves_.push_back(move);
}

void MoveList::follow(const Curve& curve, double feed_mm_rev, bool backwards)
{
    for (std::size_t i = 0; i < curve.size(); ++i)
        follow(backwards ? curve[curve.size() - 1 - i] : curve[i], feed_mm_rev, backwards);
}

void MoveList::follow(const Curve& curve, const std::vector<double>& feeds_mm_rev, double other_mm_rev, bool backwards)
{
    for (std::size_t i = 0; i < curve.size(); ++i) {
        const CurvePiece& piece = backwards ? curve[curve.size() - 1 - i] : curve[i];
        const auto source = static_cast<std::size_t>(piece.source);
        follow(piece, piece.source >= 0 && source < feeds_mm_rev.size() ? feeds_mm_rev[source] : other_mm_rev,
               backwards);
    }
}

void MoveList::follow(const CurvePiece& piece, double feed_mm_rev, bool backwards)
{
    const Vector2d& from = backwards ? piece.to : piece.from;
    const Vector2d& to = backwards ? piece.from : piece.to;
    line(from + offset_, feed_mm_rev);
    if (!piece.isArc()) {
        line(to + offset_, feed_mm_rev);
        return;
    }
    if ((to + offset_ - at_).norm() < leastMove_mm) return;
    CutMove move;
    move.kind = CutKind::Arc;
    move.to = at_ = to + offset_;
    move.centre = piece.centre + offset_;
    // Z points away from the chuck: over an upper half toward the chuck the path runs anticlockwise there.
    move.clockwise = (piece.radius_mm > 0) == backwards;
    move.feed_mm_rev = feed_mm_rev;
    moves_.push_back(move);
}

std::vector<Vector2d> chordsOf(const Vector2d& from, const CutMove& move, double chord_mm)
{
    if (move.kind != CutKind::Arc) return {move.to};
    const Vector2d a = from - move.centre, b = move.to - move.centre;
    const double radius = (a.norm() + b.norm()) / 2;
    // In (z, x) with z away from the program's Z, G2 turns anticlockwise.
    double turn = std::remainder(std::atan2(b.y(), b.x()) - std::atan2(a.y(), a.x()), 2 * std::numbers::pi);
    if (move.clockwise && turn < 0) turn += 2 * std::numbers::pi;
    if (!move.clockwise && turn > 0) turn -= 2 * std::numbers::pi;
    const double step = 2 * std::acos(std::clamp(1 - chord_mm / radius, -1.0, 1.0));
    const auto count = static_cast<int>(std::clamp(std::ceil(std::abs(turn) / std::max(step, 1e-3)), 1.0, 2000.0));
    const double start = std::atan2(a.y(), a.x());
    std::vector<Vector2d> points;
    for (int i = 1; i < count; ++i) {
        const double angle = start + turn * i / count;
        points.push_back(move.centre + radius * Vector2d(std::cos(angle), std::sin(angle)));
    }
    points.push_back(move.to);
    return points;
}

double largestRadius_mm(const Operation& operation)
{
    double radius = 0;
    for (std::size_t i = 0; i < operation.moves.size(); ++i)
        if (operation.moves[i].kind != CutKind::Rapid) {
            radius = std::max(radius, operation.moves[i].to.y());
            if (i > 0 && operation.kind != OperationKind::Finish && operation.kind != OperationKind::SemiFinish)
                radius = std::max(radius, std::min(operation.moves[i - 1].to.y(), operation.moves.front().to.y()));
        }
    return std::max(radius, 0.5);
}

}  // namespace lathelier::cam
