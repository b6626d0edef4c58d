#include "engine/cam/post/roughing_cycle.h"

#include <algorithm>
#include <cmath>

#include "engine/core/units.h"

namespace lathelier::cam {
namespace {

using Eigen::Vector2d;

constexpr double leastReversal_mm = 1e-4;
constexpr double writtenUnit_mm = 1e-3;

/// True if the move is monotonic: z and x do not decrease.
bool onlyRises(const Vector2d& from, const CutMove& move)
{
    const Vector2d way = move.to - from;
    if (way.x() < -meet_mm || way.y() < -meet_mm) return false;
    if (move.kind != CutKind::Arc) return true;
    // An arc turns back where it passes a place whose tangent runs along an axis; by a tenth of a micrometre it falls
    // less than can be written.
    const Vector2d start = from - move.centre, end = move.to - move.centre;
    const auto turns = [](double a, double b) {
        return a * b < 0 && std::min(std::abs(a), std::abs(b)) > leastReversal_mm;
    };
    return !turns(start.x(), end.x()) && !turns(start.y(), end.y());
}

std::optional<std::size_t> only(const std::vector<Operation>& operations, OperationKind kind)
{
    const auto is_it = [kind](const Operation& operation) { return operation.kind == kind; };
    if (std::count_if(operations.begin(), operations.end(), is_it) != 1) return {};
    return std::find_if(operations.begin(), operations.end(), is_it) - operations.begin();
}

}  // namespace

std::variant<RoughingCycle, Text> roughingCycle(const std::vector<Operation>& operations, const CycleData& data)
{
    const auto rough = only(operations, OperationKind::Rough), semi = only(operations, OperationKind::SemiFinish),
               finish = only(operations, OperationKind::Finish);
    if (!rough || !semi || !finish || *semi != *rough + 1 || *finish <= *semi ||
        operations[*rough].tool != operations[*semi].tool)
        return LT_TEXT("Engine", "roughing, its last pass and one finish do not follow each other");
    if (data.entering_angle_deg < 90) return LT_TEXT("Engine", "the roughing insert cannot follow a wall");
    RoughingCycle cycle;
    cycle.rough = *rough;
    cycle.semi_finish = *semi;
    cycle.finish = *finish;
    for (const CutMove& move : operations[*rough].moves) {
        if (move.speed_rpm) return LT_TEXT("Engine", "its passes have speeds of their own");
        cycle.feed_mm_rev = std::max(cycle.feed_mm_rev, move.feed_mm_rev);
    }
    // The finish: rapid moves to its start, up the face, along the contour, out, and up.
    const std::vector<CutMove>& moves = operations[*finish].moves;
    const auto is_rapid = [](const CutMove& move) { return move.kind == CutKind::Rapid; };
    const auto first = std::find_if_not(moves.begin(), moves.end(), is_rapid);
    auto end = moves.end();
    while (end != first && is_rapid(end[-1])) --end;
    if (first == moves.begin() || end - first < 3) return LT_TEXT("Engine", "its contour is too short");
    auto foot = first;
    while (foot + 1 != end && foot[1].to.x() < first->to.x() + meet_mm) ++foot;
    double stock_x = 0;
    for (const CutMove& move : operations[*semi].moves)
        if (!is_rapid(move)) stock_x = std::max(stock_x, move.to.y());
    cycle.safe_x_mm = moves.front().to.y();
    cycle.start_z_mm = moves.front().to.x();
    cycle.start_x_mm = stock_x;
    if (foot + 1 == end || foot->to.x() < cycle.start_z_mm + meet_mm)
        return LT_TEXT("Engine", "its contour is too short");
    const CutMove down{CutKind::Rapid, {cycle.start_z_mm, foot->to.y()}};
    CutMove in{CutKind::Line, foot->to};
    in.feed_mm_rev = foot[1].feed_mm_rev;
    cycle.before.assign(moves.begin(), foot + 1);
    cycle.before.push_back(down);
    cycle.before.push_back({CutKind::Rapid, {cycle.start_z_mm, cycle.start_x_mm}});
    cycle.contour = {down, in};
    for (auto move = foot + 1; move != end; ++move) {
        if (is_rapid(*move) || !onlyRises(move[-1].to, *move)) return LT_TEXT("Engine", "its contour falls somewhere");
        cycle.has_finish = cycle.has_finish && !move->cutting_speed_m_min;
        cycle.contour.push_back(*move);
    }
    cycle.contour.back().speed_rpm.reset();  // on the way out
    if (!cycle.has_finish)
        for (CutMove& move : cycle.contour) {
            move.speed_rpm.reset();
            move.cutting_speed_m_min.reset();
        }
    const double whole = cycle.start_x_mm - foot->to.y() - data.allowance_mm;
    if (!(whole > writtenUnit_mm)) return LT_TEXT("Engine", "there is no more than one pass");
    // Rounded up to the written decimals; otherwise a last pass below 1 µm would remain.
    const double passes = std::ceil(whole / data.depth_mm - meet_mm);
    cycle.depth_mm = std::ceil(whole / passes / writtenUnit_mm - meet_mm) * writtenUnit_mm;
    return cycle;
}

}  // namespace lathelier::cam
