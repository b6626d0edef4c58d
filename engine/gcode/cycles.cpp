#include "engine/gcode/cycles.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <optional>

namespace lathelier::gcode {
namespace {

/// Height above the previous depth to which a drill returns at rapid (LinuxCNC: 0.01 in).
constexpr double peckClearance_mm = 0.254;

CycleMove moveTo(MoveKind kind, const Point& point)
{
    CycleMove move;
    move.kind = kind;
    move.to = point;
    return move;
}

CycleMove rest(double seconds, const Point& at)
{
    CycleMove move = moveTo(MoveKind::Dwell, at);
    move.dwell_s = seconds;
    return move;
}

CycleMoves alongZ(MoveKind cut, const Point& start, const Point& end, double taper_mm)
{
    return {moveTo(MoveKind::Rapid, {end.x_mm + taper_mm, start.z_mm}), moveTo(cut, end),
            moveTo(cut == MoveKind::Thread ? MoveKind::Rapid : MoveKind::Feed, {start.x_mm, end.z_mm}),
            moveTo(MoveKind::Rapid, start)};
}

}  // namespace

CycleMoves turningCycle(const Point& start, const Point& end, double taper_mm)
{
    return alongZ(MoveKind::Feed, start, end, taper_mm);
}

CycleMoves threadCycle(const Point& start, const Point& end, double taper_mm)
{
    return alongZ(MoveKind::Thread, start, end, taper_mm);
}

CycleMoves facingCycle(const Point& start, const Point& end, double taper_mm)
{
    return {moveTo(MoveKind::Rapid, {start.x_mm, end.z_mm + taper_mm}), moveTo(MoveKind::Feed, end),
            moveTo(MoveKind::Feed, {end.x_mm, start.z_mm}), moveTo(MoveKind::Rapid, start)};
}

namespace {

double roughDepth_mm(const MultiThread& thread)
{
    return thread.height_mm - (thread.has_finish ? thread.finish_mm : 0);
}

/// Depth of pass n behind one at `depth`; none: the rough depth is reached.
std::optional<double> nextDepth_mm(const MultiThread& thread, std::int64_t n, double depth)
{
    const double next = std::max(thread.first_mm * std::sqrt(n), depth + thread.least_mm);
    return next >= roughDepth_mm(thread) - 1e-9 ? std::nullopt : std::optional(next);
}

}  // namespace

std::int64_t roughPasses(const MultiThread& thread, std::int64_t most)
{
    double depth = 0;
    std::int64_t n = 1;
    for (; n <= most; ++n) {
        const std::optional<double> next = nextDepth_mm(thread, n, depth);
        if (!next) break;
        depth = *next;
    }
    return n;
}

CycleMoves multiThread(const Point& start, const MultiThread& thread)
{
    const double outward = start.x_mm >= thread.end.x_mm ? 1 : -1;
    const double backward = start.z_mm >= thread.end.z_mm ? 1 : -1;
    const double rough = roughDepth_mm(thread);
    CycleMoves moves;
    const auto pass = [&](double depth) {
        const double x = thread.end.x_mm + outward * (thread.height_mm - depth);
        const double run = std::min(thread.run_out_mm, std::abs(start.z_mm - thread.end.z_mm));
        moves.push_back(moveTo(MoveKind::Rapid, {x + thread.taper_mm, start.z_mm}));
        if (run > 0) moves.push_back(moveTo(MoveKind::Thread, {x, thread.end.z_mm + backward * run}));
        moves.push_back(moveTo(MoveKind::Thread, {run > 0 ? x + outward * run : x, thread.end.z_mm}));
        moves.push_back(moveTo(MoveKind::Rapid, {start.x_mm, thread.end.z_mm}));
        moves.push_back(moveTo(MoveKind::Rapid, start));
    };
    double depth = 0;
    for (std::int64_t n = 1; moves.size() < mostCycleMoves; ++n) {
        const std::optional<double> next = nextDepth_mm(thread, n, depth);
        if (!next) break;
        depth = *next;
        pass(depth);
    }
    if (thread.has_finish) pass(rough);
    for (int k = 0; k < thread.last_passes; ++k) pass(thread.height_mm);
    return moves;
}

CycleMoves driveThread(const Point& start, const DriveThread& thread)
{
    const double inward = thread.peak_mm > 0 ? 1 : -1;
    const double forward = thread.end_z_mm < start.z_mm ? -1 : 1;
    const double peak = std::abs(thread.peak_mm);
    const double full = peak + thread.height_mm;
    const double taper = thread.taper_length_mm;
    const bool hasEntry = taper > 0 && (thread.tapers & 1) != 0, hasExit = taper > 0 && (thread.tapers & 2) != 0;
    // The compound angle shifts each pass along Z; the last one ends K·tan Q before the end, as without it.
    const double lean = std::tan(thread.compound_rad);
    CycleMoves moves;
    const auto pass = [&](double depth) {
        const double shift = forward * (depth - peak) * lean;
        const double x = start.x_mm + inward * depth, rest = start.x_mm + inward * (depth - full);
        const double z0 = start.z_mm + shift, z1 = thread.end_z_mm - forward * thread.height_mm * lean + shift;
        const double shallow = x - inward * thread.height_mm;
        moves.push_back(moveTo(MoveKind::Rapid, {rest, z0}));
        if (hasEntry) {
            moves.push_back(moveTo(MoveKind::Thread, {shallow, z0}));
            moves.push_back(moveTo(MoveKind::Thread, {x, z0 + forward * taper}));
        } else {
            moves.push_back(moveTo(MoveKind::Rapid, {x, z0}));
        }
        if (hasExit) moves.push_back(moveTo(MoveKind::Thread, {x, z1 - forward * taper}));
        moves.push_back(moveTo(MoveKind::Thread, {hasExit ? shallow : x, z1}));
        moves.push_back(moveTo(MoveKind::Rapid, {rest, z1}));
    };
    const double degression = thread.degression > 0 ? thread.degression : 1;
    for (int n = 1; moves.size() < mostCycleMoves; ++n) {
        const double depth = peak + thread.first_mm * std::pow(n, 1 / degression);
        if (depth >= full) break;
        pass(depth);
    }
    for (int k = 0; k <= thread.springs; ++k) pass(full);
    moves.push_back(moveTo(MoveKind::Rapid, {start.x_mm, thread.end_z_mm}));
    return moves;
}

CycleMoves drilling(const Point& start, const Drilling& hole)
{
    const double x = start.x_mm;
    const double down = hole.bottom_z_mm < hole.level_z_mm ? -1 : 1;
    CycleMoves moves{moveTo(MoveKind::Rapid, {x, hole.level_z_mm})};
    const MoveKind cut = hole.is_tap ? MoveKind::Thread : MoveKind::Feed;
    double reached = hole.level_z_mm;
    while (hole.peck_mm > 0 && std::abs(hole.bottom_z_mm - reached) > hole.peck_mm + 1e-9 &&
           moves.size() < mostCycleMoves) {
        reached += down * hole.peck_mm;
        moves.push_back(moveTo(cut, {x, reached}));
        const double clear = reached - down * std::min(peckClearance_mm, hole.peck_mm);
        if (!hole.chip_break) moves.push_back(moveTo(MoveKind::Rapid, {x, hole.level_z_mm}));
        moves.push_back(moveTo(MoveKind::Rapid, {x, clear}));
    }
    moves.push_back(moveTo(cut, {x, hole.bottom_z_mm}));
    if (hole.dwell_s > 0) moves.push_back(rest(hole.dwell_s, {x, hole.bottom_z_mm}));
    if (hole.is_tap || hole.feeds_out) {
        moves.push_back(moveTo(cut, {x, hole.level_z_mm}));
        if (!hole.to_level) moves.push_back(moveTo(MoveKind::Rapid, start));
    } else {
        moves.push_back(moveTo(MoveKind::Rapid, {x, hole.to_level ? hole.level_z_mm : start.z_mm}));
    }
    return moves;
}

CycleMoves pecking(const Point& start, const Pecking& groove)
{
    // a: peck axis, b: step axis.
    const auto point = [&groove](double a, double b) { return groove.along_x ? Point{a, b} : Point{b, a}; };
    const double a0 = groove.along_x ? start.x_mm : start.z_mm, b0 = groove.along_x ? start.z_mm : start.x_mm;
    const double a1 = groove.along_x ? groove.end.x_mm : groove.end.z_mm;
    const double b1 = groove.along_x ? groove.end.z_mm : groove.end.x_mm;
    const double down = a1 < a0 ? -1 : 1, side = b1 < b0 ? -1 : 1;
    CycleMoves moves;
    for (double b = b0; moves.size() < mostCycleMoves;) {
        double reached = a0;
        while (groove.peck_mm > 0 && std::abs(a1 - reached) > groove.peck_mm + 1e-9 && moves.size() < mostCycleMoves) {
            reached += down * groove.peck_mm;
            moves.push_back(moveTo(MoveKind::Feed, point(reached, b)));
            if (groove.retreat_mm > 0)
                moves.push_back(moveTo(MoveKind::Rapid, point(reached - down * groove.retreat_mm, b)));
        }
        moves.push_back(moveTo(MoveKind::Feed, point(a1, b)));
        double out = b;
        if (groove.relief_mm != 0 && b != b0) {
            out = b - side * groove.relief_mm;
            moves.push_back(moveTo(MoveKind::Rapid, point(a1, out)));
        }
        moves.push_back(moveTo(MoveKind::Rapid, point(a0, out)));
        if (!(groove.step_mm > 0) || std::abs(b1 - b) < 1e-9) break;
        b = std::abs(b1 - b) <= groove.step_mm ? b1 : b + side * groove.step_mm;
        moves.push_back(moveTo(MoveKind::Rapid, point(a0, b)));
    }
    moves.push_back(moveTo(MoveKind::Rapid, start));
    return moves;
}

CycleMoves pattern(const Point& start, const std::vector<ContourPiece>& contour, const Pattern& pattern)
{
    CycleMoves moves;
    const int passes = std::max(pattern.passes, 1);
    for (int j = 0; j < passes && moves.size() < mostCycleMoves; ++j) {
        const double share = passes > 1 ? 1 - static_cast<double>(j) / (passes - 1) : 0;
        const double dx = pattern.relief_x_mm * share + pattern.allowance_x_mm;
        const double dz = pattern.relief_z_mm * share + pattern.allowance_z_mm;
        const auto shift = [&](const Point& p) { return Point{p.x_mm + dx, p.z_mm + dz}; };
        CycleMove first = moveTo(MoveKind::Rapid, shift(start));
        first.line = contour.empty() ? 0 : contour.front().line;
        moves.push_back(first);
        for (const ContourPiece& part : contour) {
            CycleMove move = moveTo(part.is_rapid        ? MoveKind::Rapid
                                    : part.piece.isArc() ? MoveKind::Arc
                                                         : MoveKind::Feed,
                                    shift(part.piece.to));
            if (part.piece.isArc()) move.centre = shift(part.piece.centre);
            move.clockwise = part.piece.clockwise;
            move.line = part.line;
            moves.push_back(move);
        }
    }
    if (!contour.empty()) {
        // Out along X before back along Z, if the start has the larger radius.
        const Point last = moves.back().to;
        CycleMove out = moveTo(MoveKind::Rapid, {start.x_mm, last.z_mm});
        out.line = contour.back().line;
        moves.push_back(out);
        CycleMove home = moveTo(MoveKind::Rapid, start);
        home.line = contour.back().line;
        moves.push_back(home);
    }
    return moves;
}

}  // namespace lathelier::gcode
