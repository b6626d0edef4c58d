#include "engine/gcode/grooving.h"

#include <algorithm>
#include <cmath>

namespace lathelier::gcode {
namespace {

constexpr double shareOfBlade = 0.95;

class Groover {
public:
    explicit Groover(const Grooving& groove)
        : groove_(groove),
          outward_(groove.is_inner ? -1 : 1),
          corner_(groove.is_far_corner ? groove.blade_mm : 0),
          clear_(groove.surface_mm + outward_ * groove.retreat_mm)
    {
    }

    CycleMoves run()
    {
        const auto cuts = static_cast<int>(cutsOf(groove_));
        if (cuts == 0) return {};
        const double low = groove_.near_z_mm + groove_.allowance_wall_mm;
        const double high = groove_.far_z_mm - groove_.allowance_wall_mm - groove_.blade_mm;
        for (int k = 0; k < cuts && moves_.size() < mostCycleMoves; ++k) {
            const double share = cuts > 1 ? static_cast<double>(k) / (cuts - 1) : 0;
            plunge(groove_.is_from_far ? high + (low - high) * share : low + (high - low) * share);
        }
        const double near = groove_.near_z_mm, far = groove_.far_z_mm - groove_.blade_mm;
        const double middle = (near + far) / 2;
        finishWall(groove_.is_from_far ? far : near, middle);
        finishWall(groove_.is_from_far ? near : far, middle);
        go(MoveKind::Rapid, clear_, groove_.is_from_far ? far : near);
        return std::move(moves_);
    }

private:
    void plunge(double z)
    {
        const double full = groove_.depth_mm - groove_.allowance_bottom_mm;
        go(MoveKind::Rapid, clear_, z);
        double depth = 0;
        while (groove_.infeed_mm > 0 && full - depth > groove_.infeed_mm + 1e-9 && moves_.size() < mostCycleMoves) {
            depth += groove_.infeed_mm;
            go(MoveKind::Feed, at(depth), z);
            go(MoveKind::Rapid, at(std::max(depth - groove_.retreat_mm, -groove_.retreat_mm)), z);
        }
        go(MoveKind::Feed, at(full), z);
        rest(z);
        go(MoveKind::Rapid, clear_, z);
    }

    void finishWall(double z, double middle)
    {
        go(MoveKind::Rapid, clear_, z);
        go(MoveKind::Feed, at(groove_.depth_mm), z);
        if (std::abs(middle - z) > 1e-9) go(MoveKind::Feed, at(groove_.depth_mm), middle);
        go(MoveKind::Rapid, clear_, middle);
    }

    void rest(double z)
    {
        if (!(groove_.dwell_s > 0)) return;
        go(MoveKind::Dwell, moves_.back().to.x_mm, z);
        moves_.back().dwell_s = groove_.dwell_s;
    }

    double at(double depth) const { return groove_.surface_mm - outward_ * depth; }

    /// z: of the side of the blade at the smaller Z.
    void go(MoveKind kind, double x, double z)
    {
        CycleMove move;
        move.kind = kind;
        move.to = {x, z + corner_};
        moves_.push_back(move);
    }

    Grooving groove_;
    double outward_;
    double corner_;
    double clear_;
    CycleMoves moves_;
};

}  // namespace

std::int64_t cutsOf(const Grooving& groove)
{
    const double span = groove.far_z_mm - groove.near_z_mm - 2 * groove.allowance_wall_mm - groove.blade_mm;
    const double step = shareOfBlade * (groove.blade_mm - 2 * groove.corner_mm);
    if (span < -1e-9 || !(step > 0)) return 0;
    return 1 + static_cast<std::int64_t>(std::ceil(std::min(std::max(span, 0.0) / step - 1e-9, 1e9)));
}

CycleMoves grooving(const Grooving& groove)
{
    return Groover(groove).run();
}

}  // namespace lathelier::gcode
