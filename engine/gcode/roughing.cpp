// G71, G72: passes at levels, bounded by the crossings of level and contour.
#include <algorithm>
#include <cmath>

#include "engine/gcode/cycles.h"
#include "engine/gcode/level_contour.h"

namespace lathelier::gcode {
namespace {

class Rougher {
public:
    Rougher(const Point& start, const std::vector<ContourPiece>& contour, const Roughing& rough)
        : start_(start), contour_(contour), rough_(rough)
    {
        axes_.is_face = rough.is_face;
        const Point first = shifted(contour.front().piece.to), last = shifted(contour.back().piece.to);
        double sum = 0;
        for (const ContourPiece& part : contour)
            sum += axes_.depthAxis(shifted(part.piece.to)) - axes_.depthAxis(start);
        axes_.sign_p = sum <= 0 ? 1 : -1;
        const double along = axes_.feedAxis(last) - axes_.feedAxis(start);
        axes_.sign_q = along <= 0 ? 1 : -1;
        begin_ = place(first);
        home_ = place(start);
        stretches_ = stretchesOf(contour, axes_, {rough.allowance_x_mm, rough.allowance_z_mm});
    }

    CycleMoves run()
    {
        double lowest = begin_.p;
        for (const Stretch& part : stretches_) lowest = std::min({lowest, part.from.p, part.to.p});
        double previous = home_.p;
        const double depth = rough_.depth_mm;
        while (previous > lowest + sameLevel_mm && moves_.size() < mostCycleMoves) {
            const double level = std::max(previous - depth, lowest);
            passesAt(level, previous);
            previous = level;
        }
        followContour();
        return std::move(moves_);
    }

private:
    Point shifted(const Point& point) const
    {
        return {point.x_mm + rough_.allowance_x_mm, point.z_mm + rough_.allowance_z_mm};
    }
    Place place(const Point& point) const { return axes_.place(point); }
    Point point(const Place& at) const { return axes_.point(at); }

    void go(MoveKind kind, const Place& at)
    {
        CycleMove move;
        move.kind = kind;
        move.to = point(at);
        move.line = line_;
        moves_.push_back(move);
        now_ = at;
    }

    /// All cuts of one level: in front of the contour, then in each pocket.
    void passesAt(double level, double previous)
    {
        bool isBelow = begin_.p <= level + sameLevel_mm;
        double entry = home_.q;
        bool isPocket = false;
        bool hasPocket = false;
        for (const Stretch& part : stretches_) {
            const bool wasBelow = isBelow;
            isBelow = part.to.p <= level + sameLevel_mm;
            if (wasBelow == isBelow) continue;
            const double q = crossing(part, level);
            line_ = part.line;
            if (isBelow) {
                entry = q;
                isPocket = true;
                continue;
            }
            cut(level, previous, entry, q, isPocket);
            hasPocket = hasPocket || isPocket;
        }
        if (isBelow) {
            line_ = contour_.back().line;
            cut(level, previous, entry, stretches_.empty() ? begin_.q : stretches_.back().to.q, isPocket);
            hasPocket = hasPocket || isPocket;
        }
        if (!hasPocket) return;
        go(MoveKind::Rapid, {home_.p, now_.q});
        go(MoveKind::Rapid, home_);
    }

    void cut(double level, double previous, double entry, double end, bool isPocket)
    {
        if (isPocket) {
            if (entry - end < 1e-6) return;
            go(MoveKind::Rapid, {home_.p, moves_.empty() ? home_.q : now_.q});
            go(MoveKind::Rapid, {home_.p, entry});
            go(MoveKind::Rapid, {previous, entry});
            go(MoveKind::Feed, {level, entry});
        } else {
            go(contour_.front().is_rapid ? MoveKind::Rapid : MoveKind::Feed, {level, home_.q});
        }
        go(MoveKind::Feed, {level, end});
        const double out = std::min(rough_.retreat_mm, std::max(entry - end, 0.0));
        if (out > 0) go(MoveKind::Rapid, {level + out, end + out});
        if (!isPocket) go(MoveKind::Rapid, {level + out, home_.q});
    }

    void followContour()
    {
        const MoveKind first = contour_.front().is_rapid ? MoveKind::Rapid : MoveKind::Feed;
        line_ = contour_.front().line;
        go(first, {begin_.p, home_.q});
        if (std::abs(begin_.q - home_.q) > 1e-9) go(begin_.q < home_.q ? MoveKind::Feed : first, begin_);
        for (std::size_t i = 1; i < contour_.size(); ++i) {
            const Piece& piece = contour_[i].piece;
            line_ = contour_[i].line;
            go(piece.isArc() ? MoveKind::Arc : MoveKind::Feed, place(shifted(piece.to)));
            moves_.back().clockwise = piece.clockwise;
            if (piece.isArc()) moves_.back().centre = shifted(piece.centre);
        }
        const double clear = std::max(now_.p, home_.p);
        if (now_.p < clear) go(MoveKind::Rapid, {clear, now_.q});
        go(MoveKind::Rapid, {clear, home_.q});
        if (clear > home_.p) go(MoveKind::Rapid, home_);
    }

    Point start_;
    const std::vector<ContourPiece>& contour_;
    Roughing rough_;
    LevelAxes axes_;
    Place begin_;
    Place home_;
    Place now_;
    std::int64_t line_ = 0;
    std::vector<Stretch> stretches_;
    CycleMoves moves_;
};

}  // namespace

std::optional<double> reachesBeyond(const Point& start, const std::vector<ContourPiece>& contour, const Roughing& rough)
{
    if (rough.is_face || contour.size() < 3) return std::nullopt;
    // Outside where the contour ends farther from the axis than it begins.
    const double side = contour[1].piece.from.x_mm <= contour.back().piece.to.x_mm ? 1 : -1;
    double reach = start.x_mm;
    for (std::size_t i = 1; i + 1 < contour.size(); ++i)
        if (side * (contour[i].piece.to.x_mm - reach) > 0) reach = contour[i].piece.to.x_mm;
    return side * (reach - start.x_mm) > sameLevel_mm ? std::optional(reach) : std::nullopt;
}

CycleMoves roughing(const Point& start, const std::vector<ContourPiece>& contour, const Roughing& rough)
{
    if (contour.size() < 2 || !(rough.depth_mm > 0)) return {};
    return Rougher(start, contour, rough).run();
}

}  // namespace lathelier::gcode
