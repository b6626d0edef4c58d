#include "engine/gcode/grooving.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "engine/gcode/nose_path.h"

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
        finishWall(groove_.is_from_far, middle);
        finishWall(!groove_.is_from_far, middle);
        go(MoveKind::Rapid, clear_, groove_.is_from_far ? far : near);
        if (!fits_) moves_.clear();
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

    /// From the surface over the edge along the wall, and along the bottom to the middle.
    void finishWall(bool isFar, double middle)
    {
        const GrooveEdge& edge = isFar ? groove_.far_edge : groove_.near_edge;
        const double wall = isFar ? groove_.far_z_mm : groove_.near_z_mm, away = isFar ? 1 : -1;
        const double size = std::max(edge.chamfer_mm, edge.rounding_mm);
        const double end = isFar ? middle + groove_.blade_mm : middle;  // of the corner that cuts
        const double blade = isFar ? groove_.blade_mm : 0;
        std::vector<ContourPiece> path;
        const auto add = [&](double x, double z, const Point& centre = {}) {
            const Point to{x, z}, from = path.empty() ? to : path.back().piece.to;
            // An edge is rounded toward the axis outside, and on the way to larger Z.
            const bool clockwise = (outward_ > 0) != isFar;
            path.push_back({{from, to, centre, clockwise}, path.empty(), 0});
        };
        const double level = groove_.surface_mm;
        if (size > 0) {
            add(level, wall + away * (size + groove_.corner_mm + groove_.retreat_mm));
            add(level, wall + away * size);
            add(at(size), wall, edge.rounding_mm > 0 ? Point{at(size), wall + away * size} : Point{});
        } else {
            add(level, wall);
        }
        add(at(groove_.depth_mm), wall);
        add(at(groove_.depth_mm), end);
        if (std::abs(end - wall) < 1e-9) path.pop_back();
        if (size > 0) path = compensated(path, isFar);
        go(MoveKind::Rapid, clear_, path.front().piece.to.z_mm - blade);
        if (size > 0) go(MoveKind::Feed, path.front().piece.to.x_mm, path.front().piece.to.z_mm - blade);
        for (std::size_t i = 1; i < path.size(); ++i) {
            const Piece& piece = path[i].piece;
            go(piece.isArc() ? MoveKind::Arc : MoveKind::Feed, piece.to.x_mm, piece.to.z_mm - blade);
            if (!piece.isArc()) continue;
            moves_.back().centre = {piece.centre.x_mm, piece.centre.z_mm - blade + corner_};
            moves_.back().clockwise = piece.clockwise;
        }
        go(MoveKind::Rapid, clear_, moves_.back().to.z_mm - corner_);
    }

    /// Of the corner of the blade at this wall.
    std::vector<ContourPiece> compensated(const std::vector<ContourPiece>& path, bool isFar)
    {
        const bool isLeft = (outward_ > 0) != isFar;
        const int tip = groove_.is_inner ? (isFar ? 1 : 2) : (isFar ? 4 : 3);
        const auto found = nosePath(path, isLeft ? NoseSide::Left : NoseSide::Right, groove_.corner_mm, tip);
        fits_ = fits_ && found.has_value();
        return found.value_or(path);
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
    bool fits_ = true;
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
