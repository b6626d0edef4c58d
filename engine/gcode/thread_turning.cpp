#include "engine/gcode/thread_turning.h"

#include <algorithm>
#include <cmath>

namespace lathelier::gcode {

std::int64_t passesOfThread(const ThreadTurning& thread)
{
    const std::int64_t last = thread.allowance_mm > 0 ? 1 : 0;
    return (std::int64_t{thread.roughs} + last + thread.idles) * thread.starts;
}

CycleMoves threadTurning(const ThreadTurning& thread)
{
    const double inward = thread.is_inner ? 1 : -1;
    const double forward = thread.to.z_mm < thread.from.z_mm ? -1 : 1;
    const double slope = (thread.to.x_mm - thread.from.x_mm) / std::abs(thread.to.z_mm - thread.from.z_mm);
    const Point begin{thread.from.x_mm - slope * thread.run_in_mm, thread.from.z_mm - forward * thread.run_in_mm};
    const Point end{thread.to.x_mm + slope * thread.run_out_mm, thread.to.z_mm + forward * thread.run_out_mm};
    const double lean = std::tan(std::abs(thread.angle_deg) * std::acos(-1.0) / 180);
    const double outside = thread.is_inner ? std::min(begin.x_mm, end.x_mm) : std::max(begin.x_mm, end.x_mm);
    const double clear = outside - inward * thread.clearance_mm;
    CycleMoves moves;
    const auto go = [&moves](MoveKind kind, double x, double z) {
        CycleMove move;
        move.kind = kind;
        move.to = {x, z};
        moves.push_back(move);
    };
    int count = 0;
    const auto pass = [&](double depth) {
        const double side = thread.angle_deg < 0 && count % 2 == 1 ? -1 : 1;
        const double shift = -side * forward * (thread.depth_mm - depth) * lean;
        ++count;
        go(MoveKind::Rapid, clear, begin.z_mm + shift);
        go(MoveKind::Rapid, begin.x_mm + inward * depth, begin.z_mm + shift);
        go(MoveKind::Thread, end.x_mm + inward * depth, end.z_mm);
        go(MoveKind::Rapid, clear, end.z_mm);
    };
    const double rough = thread.depth_mm - thread.allowance_mm;
    for (int start = 0; start < thread.starts && moves.size() < mostCycleMoves; ++start) {
        count = 0;
        for (int k = 1; k <= thread.roughs; ++k) {
            const double share = static_cast<double>(k) / thread.roughs;
            pass(k == thread.roughs ? rough : rough * (thread.is_degressive ? std::sqrt(share) : share));
        }
        const int last = (thread.allowance_mm > 0 ? 1 : 0) + thread.idles;
        for (int k = 0; k < last; ++k) pass(thread.depth_mm);
    }
    go(MoveKind::Rapid, clear, begin.z_mm);
    return moves;
}

double coarsePitch_mm(double size_mm)
{
    struct Size {
        double size_mm, pitch_mm;
    };
    constexpr Size sizes[] = {{3, 0.5}, {4, 0.7},  {5, 0.8},  {6, 1},    {8, 1.25}, {10, 1.5}, {12, 1.75}, {14, 2},
                              {16, 2},  {18, 2.5}, {20, 2.5}, {22, 2.5}, {24, 3},   {27, 3},   {30, 3.5},  {33, 3.5},
                              {36, 4},  {39, 4},   {42, 4.5}, {45, 4.5}, {48, 5},   {52, 5},   {56, 5.5},  {60, 5.5}};
    for (const Size& one : sizes)
        if (std::abs(one.size_mm - size_mm) < 1e-9) return one.pitch_mm;
    return 0;
}

}  // namespace lathelier::gcode
