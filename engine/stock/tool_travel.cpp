#include "engine/stock/tool_travel.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/stock/machine_limits.h"

namespace lathelier::stock {
namespace {

constexpr double mostChords = 2000;  ///< largest number of chords of one arc

bool isPlace(double z_mm, double x_mm)
{
    return std::abs(z_mm) <= endless_mm && std::abs(x_mm) <= endless_mm;  // false for NaN
}

/// Chords of an arc without its start. If start and end radius differ, the radius is interpolated linearly.
void appendPathArc(const Corner& from, const Corner& to, const Corner& centre, bool clockwise, double chord_mm,
                   std::vector<Corner>& corners)
{
    const double first_mm = length_mm(from - centre), last_mm = length_mm(to - centre);
    const double begin = std::atan2(from.x_mm - centre.x_mm, from.z_mm - centre.z_mm);
    double sweep = std::atan2(to.x_mm - centre.x_mm, to.z_mm - centre.z_mm) - begin;
    if (clockwise && sweep >= 0) sweep -= 2 * std::numbers::pi;
    if (!clockwise && sweep <= 0) sweep += 2 * std::numbers::pi;
    const double radius_mm = std::max(first_mm, last_mm);
    const double widest = radius_mm > chord_mm ? 2 * std::acos(1 - chord_mm / radius_mm) : std::numbers::pi;
    const int chords = static_cast<int>(std::clamp(std::ceil(std::abs(sweep) / widest), 1.0, mostChords));
    for (int i = 1; i < chords; ++i) {
        const double share = static_cast<double>(i) / chords;
        const double along_mm = first_mm + share * (last_mm - first_mm);
        const double angle = begin + share * sweep;
        corners.push_back(centre + along_mm * Corner{std::cos(angle), std::sin(angle)});
    }
    corners.push_back(to);
}

}  // namespace

void TipFollower::take(const gcode::Move& move, double chord_mm, ToolTravel& travel)
{
    using gcode::MoveKind;
    travel.line = move.line;
    travel.tool = move.tool;
    travel.is_rapid = move.kind == MoveKind::Rapid;
    travel.is_thread = move.kind == MoveKind::Thread;
    travel.has_start = isKnown_;
    travel.is_in_reach = true;
    travel.corners.clear();
    if (move.kind == MoveKind::Dwell) return;
    const Corner end{zZero_mm_ - move.z_mm, move.x_mm};
    if (!isPlace(end.z_mm, end.x_mm)) {
        travel.is_in_reach = isKnown_ = false;
        return;
    }
    if (isKnown_) travel.corners.push_back(at_);
    const Corner centre{zZero_mm_ - move.centre_z_mm, move.centre_x_mm};
    const bool is_arc = move.kind == MoveKind::Arc && isKnown_ && isPlace(centre.z_mm, centre.x_mm);
    // Z and z run in opposite directions, so what is clockwise in one plane is not in the other.
    if (is_arc)
        appendPathArc(at_, end, centre, !move.clockwise, chord_mm, travel.corners);
    else
        travel.corners.push_back(end);
    at_ = end;
    isKnown_ = true;
}

std::size_t countRuns(std::span<const gcode::Move> moves)
{
    std::size_t runs = 0;
    bool is_running = false;
    int tool = 0;
    for (const gcode::Move& move : moves) {
        if (move.kind == gcode::MoveKind::Dwell) continue;
        const bool is_feed = move.kind != gcode::MoveKind::Rapid;
        if (is_feed && (!is_running || move.tool != tool)) ++runs;
        is_running = is_feed;
        tool = move.tool;
    }
    return runs;
}

}  // namespace lathelier::stock
